#pragma once
// Fills the scalar channels of a snapshot from its state.

#include <functional>

#include "engine/dynamics/system/cable_system.h"
#include "engine/systems/pocket/pocket.h"

namespace netpocket {

// Contact force of the target as a mean over the output interval, from the impulse it has received.
class ChannelRecorder {
 public:
  explicit ChannelRecorder(const Pocket& pocket) : spacecraft_(pocket.spacecraft), target_(pocket.target) {}

  // `snapshot` holds everything but its channels, captured from `system` just now together with `energy`.
  void fill(Snapshot& snapshot, const Structure& structure, CableSystem& system, const EnergyAudit& energy,
            double time_step);

  // Every number of the state, as in CableSystem::visit_state.
  void visit_state(const std::function<void(double&)>& visit);

 private:
  std::int32_t spacecraft_, target_;
  double last_time_ = 0;
  Eigen::Vector3d last_impulse_ = Eigen::Vector3d::Zero();
};

}  // namespace netpocket
