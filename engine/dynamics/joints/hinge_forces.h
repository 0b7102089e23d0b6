#pragma once
// Moments of hinges (model.h) on the two gradients that they join and on the body that keeps their plane.
//
// Let t2 be the unit vector along gradient2, and t the unit vector along gradient1 turned by the rest rotation R. The
// angle is theta = atan2(|t x t2|, t.t2). The energy is stiffness theta^2/2, multiplied by the hold of each gradient
// (hinge_hold.h), since a gradient that vanishes where a cord folds up has no direction to hold. The moment on t2 is
// -(stiffness theta + damping dtheta/dt) n with n = t x t2 / |t x t2|. As a force on a gradient it is -moment/|g| along
// the unit vector in the plane of the joint. The body takes the moment that the two gradients do not balance, so the
// three moments add up to zero.
//
// This is the readable form. Steps use hinge_kernel.h, which also limits the damping.

#include <Eigen/Core>

#include "engine/dynamics/joints/hinge_hold.h"
#include "engine/model/model.h"

namespace netpocket {

struct HingeForces {
  Eigen::Vector3d on_gradient1, on_gradient2;  // N m (conjugate to gradients)
  Eigen::Vector3d torque_on_body;              // N m
  double energy;                               // J
  double dissipated_power;                     // W
  double angle;                                // rad
};

// `g1`, `g2`: the gradients; `g1_rate`, `g2_rate`: their rates (1/s). `axes` turns body axes into world axes and
// rotates with `angular_velocity` (rad/s). All other vectors in world axes. The gradients must not be zero.
HingeForces hinge_forces(const Hinge& hinge, const Eigen::Vector3d& g1, const Eigen::Vector3d& g2,
                         const Eigen::Vector3d& g1_rate, const Eigen::Vector3d& g2_rate, const Eigen::Matrix3d& axes,
                         const Eigen::Vector3d& angular_velocity);

}  // namespace netpocket
