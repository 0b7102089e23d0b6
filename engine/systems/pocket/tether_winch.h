#pragma once
// The winch of a pocket's tether: a drum on the spacecraft that pays out and reels in while the pocket is let go. Its
// brake is closed while the spacecraft holds the pocket, and for good from tether.brake_at on. Whether braked or
// driven, the drum's clutch slips beyond tether.slip_tension, so that a jerk pays out rope.

#include "engine/control/controller.h"
#include "engine/control/winch.h"
#include "engine/scenario/pocket_tether.h"

namespace netpocket {

class TetherWinch : public Controller {
 public:
  // `rope`: as the model numbers them. `hub`: index of the body.
  TetherWinch(const Scenario& scenario, std::int32_t rope, std::int32_t hub);

  void update(const Measurements& measurements, double interval, Commands& commands) override;
  void change(const Scenario& scenario, double now) override;
  void visit_state(const std::function<void(double&)>& visit) override { winch_.visit_state(visit); }

  const Winch& winch() const { return winch_; }

 private:
  WinchCommand command_at(double time, bool is_held) const;

  PocketTether tether_;
  std::int32_t rope_, hub_;
  Winch winch_;
};

}  // namespace netpocket
