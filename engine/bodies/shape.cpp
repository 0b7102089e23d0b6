#include "engine/bodies/shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/bodies/triangle_mesh.h"
#include "engine/math/elementary.h"
#include "engine/math/symmetric_algebra.h"

namespace netpocket {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

// A squared length below this has lost its digits by underflow and gives no direction.
constexpr double kSmallestSquare = std::numeric_limits<double>::min();

double sign(double value) { return std::copysign(1.0, value); }

SurfacePoint nearest(const Sphere& sphere, const Vector3d& point) {
  const double square = symmetric_squared_norm(point);
  if (square < kSmallestSquare) return {-sphere.radius, Vector3d::UnitY()};
  const double distance = std::sqrt(square);
  return {distance - sphere.radius, point / distance};
}

// Axis of the face nearest to a point inside. `excess` is |point| minus the half edges; no component is positive. At
// equal distances y has priority. Between x and z the choice alternates from quadrant to quadrant, so that quarter
// turns rotate it with the box.
int nearest_face_axis(const Vector3d& excess, const Vector3d& point) {
  if (excess.y() >= std::max(excess.x(), excess.z())) return 1;
  if (excess.x() == excess.z()) return point.x() * point.z() > 0 ? 0 : 2;
  return excess.x() > excess.z() ? 0 : 2;
}

SurfacePoint nearest(const Box& box, const Vector3d& point) {
  const Vector3d excess = point.cwiseAbs() - 0.5 * box.size;
  const Vector3d outside = excess.cwiseMax(0.0);
  const double square = symmetric_squared_norm(outside);
  if (square >= kSmallestSquare) {
    const double distance = std::sqrt(square);
    return {distance, (outside / distance).cwiseProduct(point.unaryExpr(&sign))};
  }
  const int axis = nearest_face_axis(excess, point);
  return {excess[axis], sign(point[axis]) * Vector3d::Unit(axis)};
}

SurfacePoint nearest(const Cylinder& cylinder, const Vector3d& point) {
  const double radial_square = point.x() * point.x() + point.z() * point.z();
  const double radius = std::sqrt(radial_square);
  const Vector3d radial =
      radial_square < kSmallestSquare ? Vector3d::UnitX() : Vector3d(point.x() / radius, 0, point.z() / radius);
  const Vector3d axial = sign(point.y()) * Vector3d::UnitY();

  const double flank = radius - cylinder.radius;
  const double end = std::abs(point.y()) - 0.5 * cylinder.length;
  const double outside_flank = std::max(flank, 0.0);
  const double outside_end = std::max(end, 0.0);
  const double square = outside_flank * outside_flank + outside_end * outside_end;
  if (square >= kSmallestSquare) {
    const double distance = std::sqrt(square);
    return {distance, (outside_flank / distance) * radial + (outside_end / distance) * axial};
  }
  if (end >= flank) return {end, axial};
  return {flank, radial};
}

// The least distance of the parts. It is exact outside their union and a bound inside.
SurfacePoint nearest(const Satellite& satellite, const Vector3d& point) {
  SurfacePoint best{std::numeric_limits<double>::infinity(), Vector3d::UnitY()};
  for (const Satellite::Part& part : satellite.parts()) {
    const SurfacePoint found =
        std::visit([&](const auto& solid) { return nearest(solid, point - part.centre); }, part.solid);
    if (found.distance < best.distance) best = found;
  }
  return best;
}

SurfacePoint nearest(const MeshShape& shape, const Vector3d& point) { return shape.mesh->nearest(point); }

template <typename Solid>
bool nearer(const Solid& solid, const Vector3d& point, double reach) {
  return !(nearest(solid, point).distance > reach);
}
bool nearer(const MeshShape& shape, const Vector3d& point, double reach) { return shape.mesh->is_nearer(point, reach); }

double smallest_radius(const Sphere& sphere) { return sphere.radius; }
double smallest_radius(const Box& box) { return 0.5 * box.size.minCoeff(); }
double smallest_radius(const Cylinder& cylinder) { return cylinder.radius; }

double smallest_radius(const Satellite& satellite) { return 0.5 * satellite.dimensions().bus.minCoeff(); }
double smallest_radius(const MeshShape& shape) { return cube_root(3 * shape.mesh->volume() / (4 * std::numbers::pi)); }

// Smallest box along the body axes.
AlignedBox3d extent(const Sphere& sphere) {
  return {Vector3d::Constant(-sphere.radius), Vector3d::Constant(sphere.radius)};
}
AlignedBox3d extent(const Box& box) { return {-0.5 * box.size, 0.5 * box.size}; }
AlignedBox3d extent(const Cylinder& cylinder) {
  const Vector3d half(cylinder.radius, 0.5 * cylinder.length, cylinder.radius);
  return {-half, half};
}
AlignedBox3d extent(const Satellite& satellite) {
  AlignedBox3d box;
  for (const Satellite::Part& part : satellite.parts()) {
    box.extend(std::visit([](const auto& solid) { return extent(solid); }, part.solid).translated(part.centre));
  }
  return box;
}
AlignedBox3d extent(const MeshShape& shape) { return shape.mesh->bounds(); }

double outer_radius(const Sphere& sphere) { return sphere.radius; }
double outer_radius(const Box& box) { return 0.5 * symmetric_norm(box.size); }
double outer_radius(const Cylinder& cylinder) { return hypotenuse(cylinder.radius, 0.5 * cylinder.length); }

double outer_radius(const Satellite& satellite) {
  double radius = 0;
  for (const Satellite::Part& part : satellite.parts()) {
    const AlignedBox3d box = std::visit([](const auto& solid) { return extent(solid); }, part.solid);
    radius = std::max(radius, (part.centre.cwiseAbs() + box.max()).norm());
  }
  return radius;
}
double outer_radius(const MeshShape& shape) { return shape.mesh->bounding_radius(); }

// Half the edges of the bounding box along the world axes.
Vector3d half_extent(const Sphere& sphere, const Eigen::Matrix3d&) { return Vector3d::Constant(sphere.radius); }
Vector3d half_extent(const Box& box, const Eigen::Matrix3d& rotation) {
  return symmetric_product(rotation.cwiseAbs(), 0.5 * box.size);
}
Vector3d half_extent(const Cylinder& cylinder, const Eigen::Matrix3d& rotation) {
  // A disc perpendicular to the unit vector a extends to R sqrt(1 - a_i^2) along axis i. The other two columns of the
  // rotation give the root without cancellation.
  const Vector3d rim = (rotation.col(0).cwiseAbs2() + rotation.col(2).cwiseAbs2()).cwiseSqrt();
  return cylinder.radius * rim + 0.5 * cylinder.length * rotation.col(1).cwiseAbs();
}

// Box along the world axes round a box along the body axes.
AlignedBox3d turned(const AlignedBox3d& box, const Vector3d& position, const Eigen::Matrix3d& rotation) {
  const Vector3d centre = position + rotation * box.center(), half = 0.5 * (rotation.cwiseAbs() * box.sizes());
  return {centre - half, centre + half};
}

template <typename Solid>
AlignedBox3d world_box(const Solid& solid, const Vector3d& position, const Eigen::Matrix3d& rotation) {
  const Vector3d half = half_extent(solid, rotation);
  return {position - half, position + half};
}
AlignedBox3d world_box(const Satellite& satellite, const Vector3d& position, const Eigen::Matrix3d& rotation) {
  return turned(extent(satellite), position, rotation);
}
AlignedBox3d world_box(const MeshShape& shape, const Vector3d& position, const Eigen::Matrix3d& rotation) {
  return turned(extent(shape), position, rotation);
}

double solid_volume(const Satellite& satellite) {
  double sum = 0;
  for (const Satellite::Part& part : satellite.parts())
    sum += std::visit([](const auto& solid) { return volume(solid); }, part.solid);
  return sum;
}
double solid_volume(const MeshShape& shape) { return shape.mesh->volume(); }
template <typename Solid>
double solid_volume(const Solid& solid) {
  return volume(solid);
}

// Principal moments of inertia of the solid shape per unit mass, m^2.
Vector3d squared_gyration(const Sphere& sphere) { return Vector3d::Constant(0.4 * sphere.radius * sphere.radius); }
Vector3d squared_gyration(const Box& box) {
  const Vector3d square = box.size.cwiseAbs2() / 12.0;
  return {square.y() + square.z(), square.z() + square.x(), square.x() + square.y()};
}
Vector3d squared_gyration(const Cylinder& cylinder) {
  const double square = cylinder.radius * cylinder.radius;
  const double across = 0.25 * square + cylinder.length * cylinder.length / 12.0;
  return {across, 0.5 * square, across};
}

template <typename Solid>
Eigen::Matrix3d unit_inertia(const Solid& solid) {
  return squared_gyration(solid).asDiagonal();
}
// Sums each part's own inertia and that of its mass at its centre (parallel axis theorem).
Eigen::Matrix3d unit_inertia(const Satellite& satellite) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Satellite::Part& part : satellite.parts()) {
    const Vector3d& c = part.centre;
    const Eigen::Matrix3d own = std::visit([](const auto& solid) { return unit_inertia(solid); }, part.solid);
    const double share = std::visit([](const auto& solid) { return volume(solid); }, part.solid);
    sum += share * (own + c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
  }
  return sum / solid_volume(satellite);
}
Eigen::Matrix3d unit_inertia(const MeshShape& shape) { return shape.mesh->unit_inertia(); }

}  // namespace

SurfacePoint nearest_surface_point(const Shape& shape, const Vector3d& point) {
  return std::visit([&](const auto& s) { return nearest(s, point); }, shape);
}

bool is_nearer(const Shape& shape, const Vector3d& point, double reach) {
  return std::visit([&](const auto& s) { return nearer(s, point, reach); }, shape);
}

double contact_radius(const Shape& shape) {
  return std::visit([](const auto& s) { return smallest_radius(s); }, shape);
}

double bounding_radius(const Shape& shape) {
  return std::visit([](const auto& s) { return outer_radius(s); }, shape);
}

AlignedBox3d bounding_box(const Shape& shape, const Vector3d& position, const Eigen::Matrix3d& rotation) {
  return std::visit([&](const auto& s) { return world_box(s, position, rotation); }, shape);
}

AlignedBox3d extents(const Shape& shape) {
  return std::visit([](const auto& s) { return extent(s); }, shape);
}

double volume(const Shape& shape) {
  return std::visit([](const auto& s) { return solid_volume(s); }, shape);
}

Eigen::Matrix3d solid_inertia(const Shape& shape, double mass) {
  return mass * std::visit([](const auto& s) { return unit_inertia(s); }, shape);
}

}  // namespace netpocket
