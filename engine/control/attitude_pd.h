#pragma once
// Attitude control by a torque proportional to the error and its rate.
//
// In body axes, with the rotation vector e from the wanted attitude, w_e the error of the angular velocity w, and the
// wanted angular acceleration a:
//   torque = -P e - D w_e + w x (J w) + J a.
// The third term makes the rotation linear. About a principal axis J e'' + D e' + P e = 0 then holds exactly. Source:
// Wen & Kreutz-Delgado 1991, IEEE Trans. Autom. Control 36, 1148, doi:10.1109/9.90228.

#include <Eigen/Core>

#include "engine/control/tracking_error.h"
#include "engine/dynamics/assembly/dynamic_body.h"

namespace netpocket {

// Gains by body axis.
struct AttitudeGains {
  Eigen::Vector3d proportional = Eigen::Vector3d::Zero();  // N m/rad
  Eigen::Vector3d derivative = Eigen::Vector3d::Zero();    // N m s/rad
};

// Gains P = I f^2 and D = 2 z I f for moments of inertia I (kg m^2), a natural frequency f (rad/s) and a damping ratio
// z.
AttitudeGains attitude_gains(const Eigen::Vector3d& moments, double frequency, double damping_ratio);

// Stateless; safe for any number of threads.
class AttitudePd {
 public:
  // `inertia` J in kg m^2, body axes, about the centre of mass. Zero: no gyroscopic term and no wanted acceleration.
  AttitudePd(const AttitudeGains& gains, const Eigen::Matrix3d& inertia) : gains_(gains), inertia_(inertia) {}

  // Torque about the centre of mass, world axes; no force.
  Wrench demand(const BodyState& present, const WantedMotion& wanted) const;

 private:
  AttitudeGains gains_;
  Eigen::Matrix3d inertia_;
};

}  // namespace netpocket
