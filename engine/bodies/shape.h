#pragma once
// Shapes of rigid bodies, centred at the body's centre of mass, in body axes.

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

// `point` in body axes. At points with several nearest surface points (the centre of a sphere, the medial planes of a
// box) one of them is chosen by a fixed rule, so that the answer is always finite and the same. Exact to round-off
// everywhere, but inside a satellite, where the nearest surface of the part that holds the point counts, also where it
// touches another part. For sphere, box and cylinder a quarter turn of shape and point about y turns the answer with
// them to the last bit (off the y axis).
SurfacePoint nearest_surface_point(const Shape& shape, const Eigen::Vector3d& point);

// Whether the signed distance is at most `reach` (m, >= 0) or not a number; for meshes far cheaper than the distance.
bool is_nearer(const Shape& shape, const Eigen::Vector3d& point, double reach);

// Radius of curvature of the surface for the Hertz law: the radius of spheres and cylinders' flanks, the smallest half
// edge of a box (its faces are flat, but a cord meets its edges), that of a satellite's bus, the radius of the sphere
// with a mesh's volume. It hardly matters which: cords are a thousand times thinner.
double contact_radius(const Shape& shape);

// Radius of the smallest centred sphere that holds the shape.
double bounding_radius(const Shape& shape);

// Box along the world axes that holds the shape, with its centre at `position` and `rotation` from body to world axes:
// the smallest one, but for meshes and satellites that round their box in body axes.
Eigen::AlignedBox3d bounding_box(const Shape& shape, const Eigen::Vector3d& position, const Eigen::Matrix3d& rotation);

// Smallest box along the body axes that holds the shape.
Eigen::AlignedBox3d extents(const Shape& shape);

double volume(const Shape& shape);  // m^3

// Inertia (kg m^2, about the centre of mass, body axes) of the shape filled evenly with `mass` (kg).
Eigen::Matrix3d solid_inertia(const Shape& shape, double mass);

}  // namespace netpocket
