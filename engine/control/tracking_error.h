#pragma once
// A wanted motion of a body, and how the present motion differs from it. Pure functions.

#include <Eigen/Core>

#include "engine/state/snapshot.h"

namespace netpocket {

struct WantedMotion {
  BodyState state;
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();          // m/s^2, world axes
  Eigen::Vector3d angular_acceleration = Eigen::Vector3d::Zero();  // rad/s^2, world axes
};

// Present minus wanted.
struct TrackingError {
  Eigen::Vector3d error = Eigen::Vector3d::Zero();  // m or rad
  Eigen::Vector3d rate = Eigen::Vector3d::Zero();   // m/s or rad/s
};

// Of the position, in world axes.
TrackingError position_error(const BodyState& present, const BodyState& wanted);

// Of the attitude, in present body axes. The error is the rotation vector (attitude_error.h), the rate the difference
// of the angular velocities. That is the error's derivative if the error's axis stays the same. Otherwise the two
// differ by about half the vector product of error and rate.
TrackingError rotation_error(const BodyState& present, const BodyState& wanted);

// A vector in world axes, in the axes of the body.
Eigen::Vector3d to_body_axes(const BodyState& body, const Eigen::Vector3d& world);
// A vector in the axes of the body, in world axes.
Eigen::Vector3d to_world_axes(const BodyState& body, const Eigen::Vector3d& local);

}  // namespace netpocket
