#include "engine/contact/contact_part.h"

#include <algorithm>
#include <limits>

namespace netpocket {
namespace {

double thickness(const Sphere& sphere) { return 2 * sphere.radius; }
double thickness(const Box& box) { return box.size.minCoeff(); }
double thickness(const Cylinder& cylinder) { return std::min(2 * cylinder.radius, cylinder.length); }
double thickness(const MeshShape&) { return std::numeric_limits<double>::infinity(); }

// A quarter of the thickness leaves flat faces, and the depth that a cord may reach (contact_laws.cpp).
constexpr double kMostRounding = 0.25;

double rounding_of(const Sphere&, double) { return 0; }
double rounding_of(const MeshShape&, double) { return 0; }
template <typename Solid>
double rounding_of(const Solid& solid, double edge_radius) {
  return std::min(edge_radius, kMostRounding * thickness(solid));
}

Sphere inside(const Sphere& sphere, double) { return sphere; }
MeshShape inside(const MeshShape& mesh, double) { return mesh; }
Box inside(const Box& box, double rounding) { return {box.size.array() - 2 * rounding}; }
Cylinder inside(const Cylinder& cylinder, double rounding) {
  return {cylinder.radius - rounding, cylinder.length - 2 * rounding};
}

template <typename Solid>
ContactPart make_part(const Solid& solid, const Eigen::Vector3d& centre, double edge_radius) {
  const double rounding = rounding_of(solid, edge_radius);
  return {inside(solid, rounding), rounding,         centre,
          bounding_radius(solid),  thickness(solid), !std::is_same_v<Solid, MeshShape>};
}

std::vector<ContactPart> parts_of(const Satellite& satellite, double edge_radius) {
  std::vector<ContactPart> parts;
  for (const Satellite::Part& part : satellite.parts()) {
    parts.push_back(
        std::visit([&](const auto& solid) { return make_part(solid, part.centre, edge_radius); }, part.solid));
  }
  return parts;
}
template <typename Solid>
std::vector<ContactPart> parts_of(const Solid& solid, double edge_radius) {
  return {make_part(solid, Eigen::Vector3d::Zero(), edge_radius)};
}

}  // namespace

std::vector<ContactPart> contact_parts(const Shape& shape, double edge_radius) {
  return std::visit([&](const auto& solid) { return parts_of(solid, edge_radius); }, shape);
}

}  // namespace netpocket
