#include "engine/orbit/gravity.h"

#include <cmath>

namespace netpocket {
namespace {

double oblateness(double j2) { return -1.5 * j2 * kEarthMu * kEarthRadius * kEarthRadius; }

}  // namespace

Eigen::Vector3d gravity_at(const Eigen::Vector3d& position, double j2) {
  const double square = position.squaredNorm(), r = std::sqrt(square);
  Eigen::Vector3d result = -kEarthMu / (square * r) * position;
  if (j2 == 0) return result;
  const double z = position.z(), factor = oblateness(j2) / (square * square * r);
  result += factor * (1 - 5 * z * z / square) * position;
  result.z() += 2 * factor * z;
  return result;
}

Eigen::Matrix3d gravity_gradient_at(const Eigen::Vector3d& position, double j2) {
  const double square = position.squaredNorm(), r = std::sqrt(square);
  const Eigen::Matrix3d dyad = position * position.transpose();
  Eigen::Matrix3d result = kEarthMu / (square * r) * (3 / square * dyad - Eigen::Matrix3d::Identity());
  if (j2 == 0) return result;
  const double z = position.z(), factor = oblateness(j2) / (square * square * r);
  const double part = z * z / square;
  result += factor * (1 - 5 * part) * Eigen::Matrix3d::Identity() + factor * (-5 + 35 * part) / square * dyad;
  const Eigen::Vector3d mixed = -10 * factor * z / square * position;
  result.row(2) += mixed.transpose();
  result.col(2) += mixed;
  result(2, 2) += 2 * factor;
  return result;
}

}  // namespace netpocket
