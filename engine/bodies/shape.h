#pragma once
// Shapes of rigid bodies, in body axes with the origin at the body's centre of mass. Lengths in m. Pure functions: any
// thread may call them.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <variant>

#include "engine/bodies/primitives.h"
#include "engine/bodies/satellite.h"
#include "engine/bodies/surface_point.h"

namespace netpocket {

class TriangleMesh;  // triangle_mesh.h

// A closed surface of triangles; never null.
struct MeshShape {
  std::shared_ptr<const TriangleMesh> mesh;
};
using Shape = std::variant<Sphere, Box, Cylinder, Satellite, MeshShape>;

// Nearest surface point to `point` (m, body axes). If there are several (the centre of a sphere, the medial planes of a
// box), a fixed rule chooses one, so that the result is always finite and the same. It is exact to round-off, except
// inside a satellite: there it is the nearest surface of the part that contains the point, even where that part touches
// another. For sphere, box and cylinder, if shape and point are rotated by a quarter turn about y, the result is
// rotated with them to the last bit (off the y axis).
SurfacePoint nearest_surface_point(const Shape& shape, const Eigen::Vector3d& point);

// Whether the signed distance of `point` (m, body axes) is at most `reach` (m, >= 0) or NaN. For meshes it is far
// cheaper than the distance.
bool is_nearer(const Shape& shape, const Eigen::Vector3d& point, double reach);

// Radius of curvature (m) of the surface for the Hertz law. Sphere and cylinder: the radius. Box: half of the smallest
// edge (its faces are flat, but a cord touches its edges). Satellite: as for its bus. Mesh: the radius of the sphere
// with the same volume. The choice hardly matters, because cords are a thousand times thinner.
double contact_radius(const Shape& shape);

// Radius (m) of a sphere about the origin that contains the shape. It is the smallest one, except for satellites.
double bounding_radius(const Shape& shape);

// Box along the world axes that contains the shape. `position` (m) is its centre, `rotation` is from body to world
// axes. It is the smallest such box; for meshes and satellites it encloses their box in body axes.
Eigen::AlignedBox3d bounding_box(const Shape& shape, const Eigen::Vector3d& position, const Eigen::Matrix3d& rotation);

// Smallest box along the body axes that contains the shape.
Eigen::AlignedBox3d extents(const Shape& shape);

double volume(const Shape& shape);  // m^3

// Inertia (kg m^2, about the centre of mass, body axes) of the shape filled uniformly with `mass` (kg).
Eigen::Matrix3d solid_inertia(const Shape& shape, double mass);

}  // namespace netpocket
