#pragma once
// Attitude control by two loops with an observer.
//
// All in body axes, by component, with the rotation vector e from the wanted attitude and the wanted angular velocity
// w_w and acceleration a:
//   outer loop  r = -(c e + h_o sat(e/phi_o)), cut to |r| <= r_max        wanted approach
//   inner loop  s = w - w_w - r,  torque = J (a + r' - k s - h sat(s/phi) - d) + w x (J w)
// r' is the derivative of r with e' = w - w_w, 0 where r is cut. d is the disturbance's estimate
// (extended_state_observer.h). Where |e| < phi_o and r is not cut, the outer loop decays with the rate c + h_o/phi_o.
//
// This follows the structure that the abstract of Mech. Sci. 2022, 13, 751, doi:10.5194/ms-13-751-2022, describes: a
// sliding mode loop of the attitude around one of the angular velocity, with an extended observer for contact and
// flexibility. The equations and gains of that paper were not available; those here are this program's own.

#include <Eigen/Core>

#include "engine/control/sliding_mode.h"
#include "engine/dynamics/assembly/dynamic_body.h"

namespace netpocket {

struct DoubleLoopSettings {
  double slope = 0;               // c, 1/s
  double outer_switching = 0;     // h_o, rad/s
  double outer_layer = 0;         // phi_o, rad
  double fastest = 0.1;           // r_max, rad/s, by component
  SlidingModeGains inner;         // k, h and phi; its slope is not used
  double observer_bandwidth = 0;  // rad/s; 0: no observer
};

class DoubleLoop {
 public:
  // `inertia` in kg m^2, body axes, about the centre of mass; must have an inverse.
  DoubleLoop(const DoubleLoopSettings& settings, const Eigen::Matrix3d& inertia);

  // Torque about the centre of mass, world axes, after another period `dt` (s); no force.
  Wrench update(const BodyState& present, const WantedMotion& wanted, double dt);
  // To be called if the actuators exert something else than demanded: the torque (N m, body axes) until the next
  // update.
  void note_delivered(const Eigen::Vector3d& torque) { acting_ = torque; }

  Eigen::Vector3d disturbance() const { return inertia_ * inner_.disturbance(); }  // estimate, N m, body axes
  void visit_state(const NumberVisitor& visit);

 private:
  // One component of the outer loop: r, and r' for the rate of the error.
  struct Approach {
    double rate, acceleration;
  };
  Approach approach(double error, double error_rate) const;

  DoubleLoopSettings settings_;
  SlidingModeLaw inner_;
  Eigen::Matrix3d inertia_, inverse_inertia_;
  Eigen::Vector3d acting_ = Eigen::Vector3d::Zero();  // N m, body axes, torque of the control since the last update
};

}  // namespace netpocket
