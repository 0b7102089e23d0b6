#pragma once
// Distance and normal of a surface at the place nearest to a point.

#include <Eigen/Core>

namespace netpocket {

struct SurfacePoint {
  double distance;         // m, negative inside
  Eigen::Vector3d normal;  // unit, outward, body axes
};

}  // namespace netpocket
