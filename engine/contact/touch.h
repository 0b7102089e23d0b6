#pragma once
// A place where two bodies overlap.

#include <Eigen/Core>

#include "engine/math/symmetric_algebra.h"

namespace netpocket {

struct Touch {
  Eigen::Vector3d point;   // m
  Eigen::Vector3d normal;  // unit, from the second body to the first
  double depth;            // m, > 0
  double weight;           // share of the pair's contact stiffness
};

// A body's axes in those of another frame.
struct Placement {
  Eigen::Vector3d position;  // m
  Eigen::Matrix3d rotation;

  Eigen::Vector3d point(const Eigen::Vector3d& own) const { return position + symmetric_product(rotation, own); }
  Eigen::Vector3d direction(const Eigen::Vector3d& own) const { return symmetric_product(rotation, own); }
  Eigen::Vector3d own_point(const Eigen::Vector3d& point) const {
    return symmetric_transposed_product(rotation, point - position);
  }
  Eigen::Vector3d own_direction(const Eigen::Vector3d& direction) const {
    return symmetric_transposed_product(rotation, direction);
  }
};

}  // namespace netpocket
