#pragma once
// Fills the scalar channels of a snapshot that do not depend on the kind of the capture system.

#include <functional>

#include "engine/dynamics/system/cable_system.h"

namespace netpocket {

// Remembers the target's contact impulse at the previous snapshot. The contact force is the mean over the output
// interval.
class ChannelRecorder {
 public:
  // Indices of bodies; -1: the system has none.
  ChannelRecorder(std::int32_t spacecraft, std::int32_t target) : spacecraft_(spacecraft), target_(target) {}

  // Fills those channels that the snapshot's list contains. Its other values and `energy` must just have been captured
  // from `system`. `time_step` in s.
  void fill(Snapshot& snapshot, CableSystem& system, const EnergyAudit& energy, double time_step);

  // Gives every number of the state to `visit`, as CableSystem::visit_state does.
  void visit_state(const std::function<void(double&)>& visit);

 private:
  void fill_contact(Snapshot& snapshot, const CableSystem& system);

  std::int32_t spacecraft_, target_;
  double last_time_ = 0;
  Eigen::Vector3d last_impulse_ = Eigen::Vector3d::Zero();
};

}  // namespace netpocket
