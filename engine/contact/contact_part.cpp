#include "engine/contact/contact_part.h"

#include <algorithm>
#include <limits>

namespace netpocket {
namespace {

double thickness(const Sphere& sphere) { return 2 * sphere.radius; }
double thickness(const Box& box) { return box.size.minCoeff(); }
double thickness(const Cylinder& cylinder) { return std::min(2 * cylinder.radius, cylinder.length); }
double thickness(const MeshShape&) { return std::numeric_limits<double>::infinity(); }

template <typename Solid>
ContactPart make_part(const Solid& solid, const Eigen::Vector3d& centre) {
  return {solid, centre, bounding_radius(solid), thickness(solid), !std::is_same_v<Solid, MeshShape>};
}

std::vector<ContactPart> parts_of(const Satellite& satellite) {
  std::vector<ContactPart> parts;
  for (const Satellite::Part& part : satellite.parts()) {
    parts.push_back(std::visit([&](const auto& solid) { return make_part(solid, part.centre); }, part.solid));
  }
  return parts;
}
template <typename Solid>
std::vector<ContactPart> parts_of(const Solid& solid) {
  return {make_part(solid, Eigen::Vector3d::Zero())};
}

}  // namespace

std::vector<ContactPart> contact_parts(const Shape& shape) {
  return std::visit([](const auto& solid) { return parts_of(solid); }, shape);
}

}  // namespace netpocket
