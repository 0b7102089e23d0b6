#pragma once
// A contact point of two bodies, and the placement of a body.

#include <Eigen/Core>

#include "engine/math/symmetric_algebra.h"

namespace netpocket {

struct Touch {
  Eigen::Vector3d point;   // m
  Eigen::Vector3d normal;  // unit, from the second body to the first
  double depth;            // m, > 0
  double weight;           // share of the pair's contact stiffness
};

// Placement of a body's axes in another frame. own_point and own_direction are the inverse of point and direction.
struct Placement {
  Eigen::Vector3d position;  // m
  Eigen::Matrix3d rotation;  // body's axes to those of the frame

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
