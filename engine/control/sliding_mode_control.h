#pragma once
// Sliding mode control of a body's attitude and of its position, with observer and collision feed-forward.
//
// Attitude, in body axes, with the inertia J, the angular velocity w and the wanted angular acceleration a:
//   torque = J (a + u) + w x (J w) - estimated contact torque.
// Position, in world axes, with the mass m and the wanted acceleration a:
//   force = m (a + u) - estimated contact force.
// u is the law of sliding_mode.h. The last terms are the collision feed-forward. The observer counts the estimated
// contact among the known accelerations, so it estimates what the feed-forward misses: errors of the estimate,
// vibration of the flexible structure.
//
// This follows the structure that the abstract and the conclusions of Actuators 2025, 14, 358,
// doi:10.3390/act14070358, describe: feed-forward of the estimated collision force, an extended state observer for the
// estimate's errors and the flexible uncertainties, sliding mode feedback. The equations and gains of that paper were
// not available; those here are this program's own.

#include <Eigen/Core>

#include "engine/control/sliding_mode.h"
#include "engine/dynamics/assembly/dynamic_body.h"

namespace netpocket {

class AttitudeSlidingMode {
 public:
  // `inertia` in kg m^2, body axes, about the centre of mass; must have an inverse. `observer_bandwidth` in rad/s; 0:
  // no observer.
  AttitudeSlidingMode(const SlidingModeGains& gains, double observer_bandwidth, const Eigen::Matrix3d& inertia);

  // Torque about the centre of mass, world axes, after another period `dt` (s); no force. `contact`: estimated torque
  // of contacts on the body (N m, world axes); zero: no feed-forward.
  Wrench update(const BodyState& present, const WantedMotion& wanted, const Eigen::Vector3d& contact, double dt);
  // To be called if the actuators exert something else than demanded: the torque (N m, body axes) until the next
  // update.
  void note_delivered(const Eigen::Vector3d& torque) { acting_ = torque; }

  Eigen::Vector3d disturbance() const { return inertia_ * law_.disturbance(); }  // estimate, N m, body axes
  void visit_state(const NumberVisitor& visit);

 private:
  SlidingModeLaw law_;
  Eigen::Matrix3d inertia_, inverse_inertia_;
  Eigen::Vector3d acting_ = Eigen::Vector3d::Zero();  // N m, body axes, torque of the control since the last update
};

class PositionSlidingMode {
 public:
  // `mass` in kg; the rest as for AttitudeSlidingMode.
  PositionSlidingMode(const SlidingModeGains& gains, double observer_bandwidth, double mass);

  // Force at the centre of mass, world axes, after another period `dt` (s); no torque. `contact`: estimated force of
  // contacts on the body (N, world axes); zero: no feed-forward.
  Wrench update(const BodyState& present, const WantedMotion& wanted, const Eigen::Vector3d& contact, double dt);
  // To be called if the actuators exert something else than demanded: the force (N, world axes) until the next update.
  void note_delivered(const Eigen::Vector3d& force) { acting_ = force; }

  Eigen::Vector3d disturbance() const { return mass_ * law_.disturbance(); }  // estimate, N, world axes
  void visit_state(const NumberVisitor& visit);

 private:
  SlidingModeLaw law_;
  double mass_;
  Eigen::Vector3d acting_ = Eigen::Vector3d::Zero();  // N, world axes, force of the control since the last update
};

}  // namespace netpocket
