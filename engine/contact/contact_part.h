#pragma once
// A body's shape as cords touch it: a few solids, each of which is convex or a triangle mesh. A satellite is eight
// solids, every other shape is one. Each solid has contacts of its own, so a cord that lies in the corner between two
// of them is pushed by both.

#include <Eigen/Core>
#include <vector>

#include "engine/bodies/shape.h"

namespace netpocket {

struct ContactPart {
  Shape solid;             // never a satellite
  Eigen::Vector3d centre;  // m, of the solid, body axes
  double bounding_radius;  // m, about its centre
  double thickness;        // m, the least extent; infinite for a mesh, whose walls are not known
  bool is_convex;

  // `point` in body axes.
  SurfacePoint nearest(const Eigen::Vector3d& point) const { return nearest_surface_point(solid, point - centre); }
};

std::vector<ContactPart> contact_parts(const Shape& shape);

}  // namespace netpocket
