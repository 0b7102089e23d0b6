#include "engine/control/attitude_error.h"

#include <cmath>

#include "engine/math/elementary.h"
#include "engine/math/symmetric_algebra.h"

namespace netpocket {

Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& rotation) {
  const double size = symmetric_norm(rotation.vec());
  if (size == 0) return Eigen::Vector3d::Zero();
  const double angle = 2 * arc_tangent(size, std::abs(rotation.w()));
  return (rotation.w() < 0 ? -angle : angle) / size * rotation.vec();
}

// The product of the wanted attitude's conjugate and the present attitude, with the sums of symmetric_algebra.h.
Eigen::Vector3d attitude_error(const Eigen::Quaterniond& present, const Eigen::Quaterniond& wanted) {
  const Eigen::Vector3d p = present.vec(), w = wanted.vec();
  const Eigen::Vector3d vector = (wanted.w() * p - present.w() * w) - w.cross(p);
  const double scalar = wanted.w() * present.w() + symmetric_dot(w, p);
  return rotation_vector({scalar, vector.x(), vector.y(), vector.z()});
}

}  // namespace netpocket
