#pragma once
// Where a surface is nearest to a point.

#include <Eigen/Core>

namespace netpocket {

struct SurfacePoint {
  double distance;         // m, signed: negative inside
  Eigen::Vector3d normal;  // unit, outward, body axes
};

}  // namespace netpocket
