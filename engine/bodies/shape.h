#pragma once
// Shapes of rigid bodies, centred at the body's centre of mass, in body axes.

#include <Eigen/Core>
#include <Eigen/Geometry>
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
// box) one of them is chosen by a fixed rule, so that the answer is always finite and the same. Exact to round-off
// everywhere; a quarter turn of shape and point about y turns the answer with them to the last bit (off the y axis).
SurfacePoint nearest_surface_point(const Shape& shape, const Eigen::Vector3d& point);

// Radius of curvature of the surface for the Hertz law: the radius of spheres and cylinders' flanks, the smallest half
// edge of a box (its faces are flat, but a cord meets its edges).
double contact_radius(const Shape& shape);

// Radius of the smallest centred sphere that holds the shape.
double bounding_radius(const Shape& shape);

// Smallest box along the world axes that holds the shape, with its centre at `position` and `rotation` from body to
// world axes.
Eigen::AlignedBox3d bounding_box(const Shape& shape, const Eigen::Vector3d& position, const Eigen::Matrix3d& rotation);

// Inertia (kg m^2, about the centre of mass, body axes) of the shape filled evenly with `mass` (kg).
Eigen::Matrix3d solid_inertia(const Shape& shape, double mass);

}  // namespace netpocket
