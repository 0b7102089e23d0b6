#include "engine/contact/shape_pair.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/bodies/segment_distance.h"
#include "engine/bodies/triangle_mesh.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;
using Part = TouchableShape::Part;

// Features of meshes within this fraction of the smaller shape's radius are kept.
constexpr double kMargin = 0.05;
// Edges do not cross if the square of the sine between them is below this.
constexpr double kParallelAxes = 1e-6;

Part make_part(const Shape& solid, const Vector3d& centre) {
  Part part{solid, centre, bounding_radius(solid), std::nullopt, {}};
  if (const Box* box = std::get_if<Box>(&solid)) part.polytope.emplace(*box, centre);
  if (const Cylinder* cylinder = std::get_if<Cylinder>(&solid)) part.polytope.emplace(*cylinder, centre);
  if (const MeshShape* mesh = std::get_if<MeshShape>(&solid)) part.features = features_of(*mesh->mesh);
  if (part.polytope) part.features = features_of(*part.polytope);
  return part;
}

// Axes of `first` in those of `second`.
Placement relative(const Placement& first, const Placement& second) {
  Placement place{second.own_point(first.position), {}};
  for (int i = 0; i < 3; ++i) place.rotation.col(i) = second.own_direction(first.rotation.col(i));
  return place;
}

// The inverse placement: axes of the second in those of the first.
Placement inverse(const Placement& place) {
  return {-symmetric_transposed_product(place.rotation, place.position), place.rotation.transpose()};
}

Touch turned_over(const Touch& touch, const Placement& place) {
  return {place.point(touch.point), -place.direction(touch.normal), touch.depth, touch.weight};
}

// A sphere against another part, in the axes of that part. Returns the distance of their surfaces (m) and appends a
// touch if it is negative.
double find_of_sphere(const Sphere& sphere, const Vector3d& centre, const Part& other, std::vector<Touch>& touches) {
  const SurfacePoint surface = other.nearest(centre);
  const double distance = surface.distance - sphere.radius;
  if (distance < 0) {
    // The point is in the middle of the overlap.
    touches.push_back({centre - (sphere.radius + 0.5 * distance) * surface.normal, surface.normal, -distance, 1});
  }
  return distance;
}

}  // namespace

TouchableShape::TouchableShape(const Shape& shape) : radius_(bounding_radius(shape)) {
  const Satellite* satellite = std::get_if<Satellite>(&shape);
  if (satellite == nullptr) {
    parts_.push_back(make_part(shape, Vector3d::Zero()));
    return;
  }
  for (const Satellite::Part& part : satellite->parts()) {
    parts_.push_back(make_part(std::visit([](const auto& solid) -> Shape { return solid; }, part.solid), part.centre));
  }
}

ShapePair::ShapePair(const TouchableShape& first, const TouchableShape& second)
    : first_(first),
      second_(second),
      margin_(kMargin * std::min(first.radius(), second.radius())),
      meshes_(first.parts().size() * second.parts().size()) {}

// Upper bound (m) of the motion of any point of the first shape in the second's axes.
double ShapePair::way_since(const Placement& before, const Placement& now) const {
  return (now.position - before.position).norm() + (now.rotation - before.rotation).norm() * first_.radius();
}

void ShapePair::find(const Placement& first, const Placement& second, std::vector<Touch>& touches) {
  touches.clear();
  const double reach = first_.radius() + second_.radius();
  if (!((first.position - second.position).squaredNorm() <= reach * reach)) return;
  const Placement place = relative(first, second);
  if (!place.rotation.allFinite()) return;  // the state has diverged
  if (place_ && way_since(*place_, place) < clearance_) return;
  place_ = place;
  clearance_ = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < first_.parts().size(); ++i) {
    for (std::size_t j = 0; j < second_.parts().size(); ++j) {
      clearance_ = std::min(clearance_, find_of_parts(i, j, place, touches));
    }
  }
  for (Touch& touch : touches) {
    touch.point = second.point(touch.point);
    touch.normal = second.direction(touch.normal);
  }
}

// Returns a lower bound (m) of the distance of two parts and appends their touches in the second's axes.
double ShapePair::find_of_parts(std::size_t i, std::size_t j, const Placement& place, std::vector<Touch>& touches) {
  const Part &one = first_.parts()[i], &two = second_.parts()[j];
  const Vector3d centre = place.point(one.centre);
  const double apart = symmetric_norm(centre - two.centre) - one.radius - two.radius;
  if (apart > 0) return apart;
  if (one.sphere() != nullptr) return find_of_sphere(*one.sphere(), centre, two, touches);
  if (two.sphere() != nullptr) {
    std::vector<Touch> found;
    const double distance = find_of_sphere(*two.sphere(), inverse(place).point(two.centre), one, found);
    for (const Touch& touch : found) touches.push_back(turned_over(touch, place));
    return distance;
  }
  if (one.polytope && two.polytope) return find_touches(*one.polytope, place, *two.polytope, touches);
  return find_of_mesh(one, two, meshes_[i * second_.parts().size() + j], place, touches);
}

namespace {

// Corners of `one` within `margin` of `two`. `place`: axes of `one` in those of `two`.
std::vector<std::int32_t> near_corners(const Part& one, const Part& two, const Placement& place, double margin) {
  std::vector<std::int32_t> found;
  for (std::size_t i = 0; i < one.features.corners.size(); ++i) {
    const Vector3d point = place.point(one.features.corners[i].point);
    if (two.is_nearer(point, margin)) found.push_back(static_cast<std::int32_t>(i));
  }
  return found;
}

// Edges of `one` that may be within `margin` of `two`.
std::vector<std::int32_t> near_edges(const Part& one, const Part& two, const Placement& place, double margin) {
  std::vector<std::int32_t> found;
  for (std::size_t i = 0; i < one.features.edges.size(); ++i) {
    const FeatureEdge& edge = one.features.edges[i];
    const double half = 0.5 * (edge.end - edge.begin).norm();
    if (two.is_nearer(place.point(0.5 * (edge.begin + edge.end)), margin + half)) {
      found.push_back(static_cast<std::int32_t>(i));
    }
  }
  return found;
}

// An edge in the second's axes.
FeatureEdge placed(const FeatureEdge& edge, const Placement& place) {
  return {place.point(edge.begin), place.point(edge.end), place.direction(edge.side1), place.direction(edge.side2),
          edge.weight};
}

bool is_inside(double fraction) { return fraction > 0 && fraction < 1; }

// Touch of two convex edges that cross so that their bodies overlap there. `a` belongs to the first part, `b` to the
// second; both in the axes of the second.
std::optional<Touch> crossing(const FeatureEdge& a, const FeatureEdge& b) {
  const Vector3d along_a = a.end - a.begin, along_b = b.end - b.begin;
  Vector3d normal = along_a.cross(along_b);
  const double square = symmetric_squared_norm(normal);
  if (square < kParallelAxes * symmetric_squared_norm(along_a) * symmetric_squared_norm(along_b)) return std::nullopt;
  normal /= std::sqrt(square);
  if (!b.looks(normal)) normal = -normal;
  if (!b.looks(normal) || !a.looks(-normal)) return std::nullopt;
  const SegmentDistance nearest = closest_points({a.begin, a.end}, {b.begin, b.end});
  if (!is_inside(nearest.first_fraction) || !is_inside(nearest.second_fraction)) return std::nullopt;
  const double depth = symmetric_dot(normal, nearest.second_point - nearest.first_point);
  if (depth <= 0) return std::nullopt;
  return Touch{0.5 * (nearest.first_point + nearest.second_point), normal, depth, std::min(a.weight, b.weight)};
}

}  // namespace

ShapePair::Near ShapePair::find_near(const Part& one, const Part& two, const Placement& place) const {
  const Placement back = inverse(place);
  return {near_corners(one, two, place, margin_), near_corners(two, one, back, margin_),
          near_edges(one, two, place, margin_), near_edges(two, one, back, margin_)};
}

double ShapePair::find_of_mesh(const Part& one, const Part& two, MeshMemory& memory, const Placement& place,
                               std::vector<Touch>& touches) const {
  const double way = memory.place ? way_since(*memory.place, place) : margin_;
  if (way >= margin_) {
    memory.near = find_near(one, two, place);
    memory.place = place;
  }
  const Near& near = memory.near;
  if (near.empty()) return memory.place ? margin_ - way_since(*memory.place, place) : 0;
  const Placement back = inverse(place);
  for (const std::int32_t index : near.corners1) {
    const FeatureCorner& corner = one.features.corners[static_cast<std::size_t>(index)];
    const Vector3d point = place.point(corner.point);
    const SurfacePoint surface = two.nearest(point);
    if (surface.distance < 0) touches.push_back({point, surface.normal, -surface.distance, corner.weight});
  }
  for (const std::int32_t index : near.corners2) {
    const FeatureCorner& corner = two.features.corners[static_cast<std::size_t>(index)];
    const SurfacePoint surface = one.nearest(back.point(corner.point));
    if (surface.distance >= 0) continue;
    touches.push_back({corner.point, -place.direction(surface.normal), -surface.distance, corner.weight});
  }
  for (const std::int32_t i : near.edges1) {
    const FeatureEdge a = placed(one.features.edges[static_cast<std::size_t>(i)], place);
    for (const std::int32_t j : near.edges2) {
      const FeatureEdge& b = two.features.edges[static_cast<std::size_t>(j)];
      const std::optional<Touch> touch = crossing(a, b);
      if (!touch) continue;
      // Edges on opposite sides of deeply overlapping bodies cross as well. They are no contacts.
      if (two.nearest(touch->point - 0.5 * touch->depth * touch->normal).distance > 0) continue;
      if (one.nearest(back.point(touch->point + 0.5 * touch->depth * touch->normal)).distance > 0) continue;
      touches.push_back(*touch);
    }
  }
  return 0;
}

}  // namespace netpocket
