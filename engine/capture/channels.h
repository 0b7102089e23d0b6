#pragma once
// Fills the scalar channels of a snapshot from its state.

#include <functional>

#include "engine/dynamics/system/cable_system.h"
#include "engine/systems/pocket/pocket.h"

namespace netpocket {

// Remembers the target's contact impulse at the previous snapshot. The contact force is the mean over the output
// interval.
class ChannelRecorder {
 public:
  explicit ChannelRecorder(const Pocket& pocket) : spacecraft_(pocket.spacecraft), target_(pocket.target) {}

  // Fills all channels of `snapshot`. Its other values and `energy` must just have been captured from `system`.
  // `time_step` in s.
  void fill(Snapshot& snapshot, const Structure& structure, CableSystem& system, const EnergyAudit& energy,
            double time_step);

  // Gives every number of the state to `visit`, as CableSystem::visit_state does.
  void visit_state(const std::function<void(double&)>& visit);

 private:
  std::int32_t spacecraft_, target_;
  double last_time_ = 0;
  Eigen::Vector3d last_impulse_ = Eigen::Vector3d::Zero();
};

}  // namespace netpocket
