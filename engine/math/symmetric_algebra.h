#pragma once
// Vector sums whose rounding is the same after quarter turns about Y.
//
// The pocket maps onto itself under (x, z) -> (z, -x). Floating-point addition is commutative but not associative. So a
// sum keeps that symmetry to the last bit only if its x and z terms are added first. Eigen's own dot product adds x and
// y first.

#include <Eigen/Core>
#include <cmath>

namespace netpocket {

inline double symmetric_dot(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return (a.x() * b.x() + a.z() * b.z()) + a.y() * b.y();
}

inline double symmetric_squared_norm(const Eigen::Vector3d& a) { return symmetric_dot(a, a); }

inline double symmetric_norm(const Eigen::Vector3d& a) { return std::sqrt(symmetric_squared_norm(a)); }

// matrix^T v, e.g. world to body axes.
inline Eigen::Vector3d symmetric_transposed_product(const Eigen::Matrix3d& matrix, const Eigen::Vector3d& v) {
  return {symmetric_dot(matrix.col(0), v), symmetric_dot(matrix.col(1), v), symmetric_dot(matrix.col(2), v)};
}

// matrix v, e.g. body to world axes.
inline Eigen::Vector3d symmetric_product(const Eigen::Matrix3d& matrix, const Eigen::Vector3d& v) {
  return (matrix.col(0) * v.x() + matrix.col(2) * v.z()) + matrix.col(1) * v.y();
}

}  // namespace netpocket
