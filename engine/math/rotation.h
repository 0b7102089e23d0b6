#pragma once
// Rotations from rotation vectors.

#include <Eigen/Geometry>

#include "engine/math/elementary.h"
#include "engine/math/symmetric_algebra.h"

namespace netpocket {

// The rotation about the direction of `vector` by an angle equal to its length (rad).
inline Eigen::Quaterniond rotation_by(const Eigen::Vector3d& vector) {
  const double angle = symmetric_norm(vector);
  if (angle == 0) return Eigen::Quaterniond::Identity();
  const Eigen::Vector3d part = (sine(0.5 * angle) / angle) * vector;
  return {cosine(0.5 * angle), part.x(), part.y(), part.z()};
}

}  // namespace netpocket
