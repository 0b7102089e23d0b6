#include "engine/analysis/metrics/target_samples.h"

#include <numbers>
#include <variant>

#include "engine/bodies/triangle_mesh.h"
#include "engine/sampling/sobol_sequence.h"

namespace netpocket {
namespace {

// Calls `use` with points of a Sobol sequence in the box until it has returned true `count` times.
template <typename Use>
void fill_box(const Eigen::AlignedBox3d& box, int count, const Use& use) {
  constexpr std::uint64_t kMostPoints = 2'000'000;  // for shapes that fill next to nothing of their box
  SobolWalk walk(3);
  for (std::uint64_t i = 1; count > 0 && i < kMostPoints; ++i) {
    walk.next();
    const Eigen::Vector3d part(walk[0], walk[1], walk[2]);
    if (use(Eigen::Vector3d(box.min() + box.sizes().cwiseProduct(part)))) --count;
  }
}

double area_of(const Sphere& s) { return 4 * std::numbers::pi * s.radius * s.radius; }

double area_of(const Box& b) {
  return 2 * (b.size.x() * b.size.y() + b.size.y() * b.size.z() + b.size.z() * b.size.x());
}

double area_of(const Cylinder& c) { return 2 * std::numbers::pi * c.radius * (c.radius + c.length); }

double area_of(const Satellite& s) {
  double area = 0;
  for (const Satellite::Part& part : s.parts()) {
    area += std::visit([](const auto& solid) { return area_of(solid); }, part.solid);
  }
  return area;
}

double area_of(const MeshShape& m) {
  double area = 0;
  for (const Triangle& t : m.mesh->triangles()) {
    const auto corner = [&](int i) {
      return m.mesh->vertices()[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])];
    };
    area += (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 2;
  }
  return area;
}

}  // namespace

std::vector<SurfaceSample> surface_samples(const Shape& shape, int count) {
  const double thickness = 0.01 * bounding_radius(shape);
  Eigen::AlignedBox3d box = extents(shape);
  box.min().array() -= thickness;
  box.max().array() += thickness;
  std::vector<SurfaceSample> samples;
  fill_box(box, count, [&](const Eigen::Vector3d& point) {
    if (!is_nearer(shape, point, thickness)) return false;
    const SurfacePoint surface = nearest_surface_point(shape, point);
    if (surface.distance < 0) return false;
    samples.push_back({point - surface.distance * surface.normal, surface.normal});
    return true;
  });
  return samples;
}

std::vector<Eigen::Vector3d> volume_samples(const Shape& shape, int count) {
  std::vector<Eigen::Vector3d> samples;
  fill_box(extents(shape), count, [&](const Eigen::Vector3d& point) {
    const bool is_inside = is_nearer(shape, point, 0);
    if (is_inside) samples.push_back(point);
    return is_inside;
  });
  return samples;
}

double surface_area(const Shape& shape) {
  return std::visit([](const auto& s) { return area_of(s); }, shape);
}

double characteristic_length(const Shape& shape) { return extents(shape).sizes().mean(); }

}  // namespace netpocket
