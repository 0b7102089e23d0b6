#pragma once
// Shapes of rigid bodies, centred at the body's centre of mass, in body axes.

#include <Eigen/Core>
#include <variant>

namespace netpocket {

struct Sphere {
  double radius;  // m
};
struct Box {
  Eigen::Vector3d size;  // m, full edge lengths along the body axes
};
struct Cylinder {
  double radius;  // m
  double length;  // m, along the body's y axis
};
using Shape = std::variant<Sphere, Box, Cylinder>;

// Nearest point of a shape's surface to a point.
struct SurfacePoint {
  double distance;         // m, signed: negative inside
  Eigen::Vector3d normal;  // unit, outward, body axes
};

// `point` in body axes. At points with several nearest surface points (the centre of a sphere, the medial planes of a
// box) one of them is chosen by a fixed rule, so that the answer is always finite and the same.
SurfacePoint nearest_surface_point(const Shape& shape, const Eigen::Vector3d& point);

// Radius of curvature of the surface for the Hertz law: the radius of spheres and cylinders' flanks, the smallest half
// edge of a box (its faces are flat, but a cord meets its edges).
double contact_radius(const Shape& shape);

// Radius of the smallest centred sphere that holds the shape.
double bounding_radius(const Shape& shape);

}  // namespace netpocket
