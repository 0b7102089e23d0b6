#pragma once
// A body's shape for the contact with cords: one or more solids, each of which is convex or a triangle mesh. A
// satellite has eight solids, every other shape has one. Each solid has contacts of its own. So a cord that lies in the
// corner between two solids is pushed by both.

#include <Eigen/Core>
#include <vector>

#include "engine/bodies/shape.h"

namespace netpocket {

struct ContactPart {
  Shape solid;             // never a satellite
  Eigen::Vector3d centre;  // m, of the solid, body axes
  double bounding_radius;  // m, about its centre
  double thickness;        // m, least extent; infinite for a mesh, whose wall thickness is not known
  bool is_convex;

  // Nearest surface point of the solid to `point` (m, body axes).
  SurfacePoint nearest(const Eigen::Vector3d& point) const { return nearest_surface_point(solid, point - centre); }
};

// The solids of a shape.
std::vector<ContactPart> contact_parts(const Shape& shape);

}  // namespace netpocket
