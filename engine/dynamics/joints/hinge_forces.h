#pragma once
// Moments of hinges (model.h) on the two gradients they join and on the body that keeps their plane.
//
// With unit vectors t2 along gradient2 and t along gradient1 turned by the rest rotation R, the angle is
// theta = atan2(|t x t2|, t.t2) and the energy stiffness theta^2/2, times the hold of each gradient where one is short:
// what folds up so far that its slope vanishes has no direction to be held by. The moment on t2 is -(stiffness theta +
// damping dtheta/dt) n, n = t x t2 / |t x t2|; as forces on the gradients, that is -moment/|g| along the unit vector in
// the plane of the joint. Whatever moment the two gradients do not balance between them acts on the body, so the three
// together exert none.
//
// The readable form; steps use hinge_kernel.h, which besides bounds the damping.

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

// g1, g2: the gradients, g1_rate, g2_rate their rates; `axes` turns body axes into world axes and spins with
// `angular_velocity`. World frame.
HingeForces hinge_forces(const Hinge& hinge, const Eigen::Vector3d& g1, const Eigen::Vector3d& g2,
                         const Eigen::Vector3d& g1_rate, const Eigen::Vector3d& g2_rate, const Eigen::Matrix3d& axes,
                         const Eigen::Vector3d& angular_velocity);

}  // namespace netpocket
