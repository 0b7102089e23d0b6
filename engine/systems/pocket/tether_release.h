#pragma once
// A pocket on a tether during a run: when the spacecraft lets it go, and the channels that tell how it is towed.

#include <memory>
#include <vector>

#include "engine/control/capture_times.h"
#include "engine/control/controller.h"
#include "engine/scenario/pocket_tether.h"
#include "engine/state/channels.h"
#include "engine/systems/pocket/pocket.h"

namespace netpocket {

class TetherRelease : public Controller {
 public:
  // `hub`: index of the body. `times`: of the closing.
  TetherRelease(const Scenario& scenario, std::int32_t hub, std::shared_ptr<const CaptureTimes> times);

  void update(const Measurements& measurements, double interval, Commands& commands) override;
  void change(const Scenario& scenario, double now) override;
  void visit_state(const std::function<void(double&)>& /*visit*/) override {}

 private:
  double release_time() const;

  PocketTether tether_;
  std::int32_t hub_;
  std::shared_ptr<const CaptureTimes> times_;
};

class TetherChannels {
 public:
  // A pocket without a hub has no such channels.
  explicit TetherChannels(const Pocket& pocket);

  const std::vector<ChannelInfo>& infos() const { return infos_; }
  // Fills them, the first of which has the index `first`. The rest of `snapshot` must just have been captured.
  void fill(const CableSystem& system, std::size_t first, Snapshot& snapshot) const;

 private:
  std::vector<ChannelInfo> infos_;
  std::int32_t hub_, target_;
  std::vector<std::int32_t> tether_;      // elements; empty: it is wound
  std::int32_t rope_ = -1;                // then, as the model numbers ropes
  std::int32_t eye_ = -1, far_end_ = -1;  // nodes
};

}  // namespace netpocket
