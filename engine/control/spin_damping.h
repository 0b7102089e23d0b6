#pragma once
// Damps the spin of a body or of a captured stack by a torque against its angular velocity.
//
//   torque = -D (w - w_wanted), shortened to the largest torque.
// Its power on a body that is to stop is never positive. A spin about a principal axis with the moment I decays as
// exp(-D t/I), or linearly while the torque is at its limit.

#include <Eigen/Core>
#include <limits>

#include "engine/dynamics/assembly/dynamic_body.h"

namespace netpocket {

struct SpinDamping {
  double gain = 0;                                        // D, N m s/rad
  double most = std::numeric_limits<double>::infinity();  // N m, largest size of the torque
  Eigen::Vector3d wanted_spin = Eigen::Vector3d::Zero();  // rad/s, world axes

  // Torque about the centre of mass for the angular velocity (rad/s), both in world axes; no force.
  Wrench demand(const Eigen::Vector3d& angular_velocity) const;
};

}  // namespace netpocket
