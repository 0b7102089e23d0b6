#pragma once
// Vectors of the cable element. The pocket repeats every 90 degrees about the world's Y axis, and a symmetric capture
// must stay symmetric to the last bit. Therefore sums over components are grouped so that the rotation
// (x, z) -> (z, -x) only swaps two summands. Use these functions instead of Eigen's reductions and products, whose
// order depends on the instruction set.

#include <Eigen/Core>

namespace netpocket {

// Coordinates of an element, or quantities conjugate to them. Columns r1, g1, r2, g2: positions (m) and gradients
// dr/dp (dimensionless) of the two nodes, world frame.
using ElementCoordinates = Eigen::Matrix<double, 3, 4>;

// One number per column of ElementCoordinates.
using NodalWeights = Eigen::Vector4d;

// d(force)/d(coordinates). Row and column index: 3 * (column of ElementCoordinates) + component.
using ElementTangent = Eigen::Matrix<double, 12, 12>;

inline double dot(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return (a.x() * b.x() + a.z() * b.z()) + a.y() * b.y();
}

inline double squared_norm(const Eigen::Vector3d& a) { return dot(a, a); }

// Work of forces on displacements; power of forces on velocities.
inline double work(const ElementCoordinates& force, const ElementCoordinates& displacement) {
  const auto column = [&](int i) { return dot(Eigen::Vector3d(force.col(i)), Eigen::Vector3d(displacement.col(i))); };
  return (column(0) + column(2)) + (column(1) + column(3));
}

// sum_i w_i q_i: interpolation with shape functions.
inline Eigen::Vector3d combine(const ElementCoordinates& q, const NodalWeights& w) {
  return w[0] * q.col(0) + w[1] * q.col(1) + w[2] * q.col(2) + w[3] * q.col(3);
}

}  // namespace netpocket
