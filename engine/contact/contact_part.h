#pragma once
// A body's shape for the contact with cords: one or more solids, each of which is convex or a triangle mesh. A
// satellite has eight solids, every other shape has one. Each solid has contacts of its own. So a cord that lies in the
// corner between two solids is pushed by both.
//
// Edges of boxes and cylinders may be round. The solid is then the set of points within `rounding` of a smaller solid.
// At a sharp edge the normal of an axis that has entered the solid jumps from one face to the other, and the cord slips
// off. At a round one the normal turns gradually, down to the depth `rounding`.

#include <Eigen/Core>
#include <vector>

#include "engine/bodies/shape.h"

namespace netpocket {

struct ContactPart {
  Shape solid;             // never a satellite; smaller by `rounding` on every side
  double rounding;         // m, radius of its edges; 0: sharp
  Eigen::Vector3d centre;  // m, of the solid, body axes
  double bounding_radius;  // m, about its centre
  double thickness;        // m, least extent; infinite for a mesh, whose wall thickness is not known
  bool is_convex;

  // Nearest surface point of the solid to `point` (m, body axes).
  SurfacePoint nearest(const Eigen::Vector3d& point) const {
    const SurfacePoint inner = nearest_surface_point(solid, point - centre);
    return {inner.distance - rounding, inner.normal};
  }
};

// The solids of a shape, whose edges have the radius `edge_radius` (m), but at most a quarter of a solid's thickness.
// Meshes keep their edges.
std::vector<ContactPart> contact_parts(const Shape& shape, double edge_radius = 0);

}  // namespace netpocket
