#pragma once
// Shapes with closed formulas, centred at the origin.

#include <Eigen/Core>
#include <numbers>

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

// Volume, m^3.
inline double volume(const Sphere& s) { return 4 * std::numbers::pi / 3 * s.radius * s.radius * s.radius; }
inline double volume(const Box& b) { return b.size.prod(); }
inline double volume(const Cylinder& c) { return std::numbers::pi * c.radius * c.radius * c.length; }

}  // namespace netpocket
