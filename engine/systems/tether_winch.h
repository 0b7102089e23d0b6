#pragma once
// The winch of a tether: a drum on the spacecraft that pays out and reels in. Until its drive begins, and for good from
// a time or an event on, its brake is closed; so it is while the spacecraft holds what is on the tether. Whether braked
// or driven, the drum's clutch slips beyond tether.slip_tension, so that a jerk pays out rope.

#include <memory>

#include "engine/control/capture_times.h"
#include "engine/control/controller.h"
#include "engine/control/winch.h"
#include "engine/model/model.h"
#include "engine/scenario/tether_drum.h"
#include "engine/state/channels.h"

namespace netpocket {

// Adds a tether that a drum winds to a model: a straight line without inertia from the node `eye` to the node
// `far_end`, wound at `eye`. Half of the mass of all its rope stays at either end. It is drawn as a node group "wound
// tether".
void add_wound_tether(Model& model, const TetherDrum& drum, const CableSection& section, std::int32_t eye,
                      std::int32_t far_end);

class TetherWinch : public Controller {
 public:
  struct Parts {
    std::int32_t rope;    // as the model numbers them
    std::int32_t held;    // body that is on the tether and may be locked to the spacecraft; -1: none
    std::int32_t target;  // body
  };

  // `times`: of the closing.
  TetherWinch(const Scenario& scenario, const Parts& parts, std::shared_ptr<const CaptureTimes> times);

  void update(const Measurements& measurements, double interval, Commands& commands) override;
  void change(const Scenario& scenario, double now) override;
  void visit_state(const std::function<void(double&)>& visit) override;

  const Winch& winch() const { return winch_; }

 private:
  double time_of(DrumEvent event) const;
  WinchCommand command_at(double time, bool is_held) const;

  TetherDrum drum_;
  Parts parts_;
  std::shared_ptr<const CaptureTimes> times_;
  double first_touch_;  // s, of the target; infinite: not yet
  Winch winch_;
};

// Length and rate of a wound tether, as channels.
std::vector<ChannelInfo> wound_tether_channels();

}  // namespace netpocket
