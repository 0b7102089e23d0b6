#include "engine/contact/polytope.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/bodies/segment_distance.h"
#include "engine/math/elementary.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

// Number of sides of the prism that represents a cylinder. Its flank is at most 0.0012 radii inside the cylinder's.
constexpr int kSides = 64;
// An overlap along a product of edges is taken only if it is less than that along any face's normal by this fraction of
// the smaller solid's radius.
constexpr double kPreference = 0.01;
// A corner outside a side of a face by up to this fraction of that radius counts as inside, for aligned solids.
constexpr double kAligned = 1e-9;
// Edges count as parallel if the square of the sine between them is below this.
constexpr double kParallelEdges = 1e-12;

// Unit vectors (cosine, sine) of evenly spaced angles from 0 on, by bisection. So a quarter turn maps the vectors onto
// each other to the last bit, on any processor.
std::vector<Eigen::Vector2d> unit_circle(int count) {
  std::vector<Eigen::Vector2d> points = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  while (static_cast<int>(points.size()) < count) {
    std::vector<Eigen::Vector2d> finer;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector2d sum = points[i] + points[(i + 1) % points.size()];
      finer.push_back(points[i]);
      finer.emplace_back(sum / std::sqrt(sum.x() * sum.x() + sum.y() * sum.y()));
    }
    points = std::move(finer);
  }
  return points;
}

Vector3d unit(const Vector3d& v) { return v / symmetric_norm(v); }

}  // namespace

Polytope::Polytope(const Box& box, const Vector3d& centre) : centre_(centre), radius_(0.5 * symmetric_norm(box.size)) {
  for (int i = 0; i < 8; ++i) {
    const Vector3d signs((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
    vertices_.emplace_back(centre + 0.5 * box.size.cwiseProduct(signs));
    if (i < 4) half_vertices_.emplace_back(0.5 * box.size.cwiseProduct(signs));
  }
  for (const auto& face :
       {std::vector<std::int32_t>{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}}) {
    add_face(face, false);
  }
}

Polytope::Polytope(const Cylinder& cylinder, const Vector3d& centre)
    : centre_(centre), radius_(hypotenuse(cylinder.radius, 0.5 * cylinder.length)), weight_(8.0 / (2 * kSides)) {
  std::vector<std::int32_t> low, high;
  for (const Eigen::Vector2d& point : unit_circle(kSides)) {
    const Vector3d rim(cylinder.radius * point.x(), 0.5 * cylinder.length, cylinder.radius * point.y());
    high.push_back(static_cast<std::int32_t>(vertices_.size()));
    vertices_.emplace_back(centre + rim);
    low.push_back(static_cast<std::int32_t>(vertices_.size()));
    vertices_.emplace_back(centre + Vector3d(rim.x(), -rim.y(), rim.z()));
    half_vertices_.push_back(rim);
  }
  for (std::size_t i = 0; i < low.size(); ++i) {
    const std::size_t next = (i + 1) % low.size();
    add_face({low[i], high[i], high[next], low[next]}, true);
  }
  add_face(low, false);
  std::ranges::reverse(high);
  add_face(high, false);
}

void Polytope::add_face(const std::vector<std::int32_t>& corners, bool curved) {
  const Vector3d first = vertices_[corners[1]] - vertices_[corners[0]];
  const Vector3d normal = unit(first.cross(vertices_[corners[2]] - vertices_[corners[1]]));
  faces_.push_back({normal, symmetric_dot(normal, vertices_[corners[0]] - centre_), corners, curved});
  for (std::size_t i = 0; i < corners.size(); ++i) add_edge(corners[i], corners[(i + 1) % corners.size()]);
}

// Each edge belongs to two faces, once in each direction; only one is added.
void Polytope::add_edge(std::int32_t begin, std::int32_t end) {
  if (begin > end) return;
  const Vector3d direction = unit(vertices_[end] - vertices_[begin]);
  for (EdgeClass& parallel : edge_classes_) {
    if (symmetric_squared_norm(parallel.direction.cross(direction)) > kParallelEdges) continue;
    parallel.edges.push_back({begin, end});
    return;
  }
  edge_classes_.push_back({direction, {{begin, end}}});
}

double Polytope::half_width(const Vector3d& normal) const {
  double width = 0;
  for (const Vector3d& vertex : half_vertices_) width = std::max(width, std::abs(symmetric_dot(normal, vertex)));
  return width;
}

namespace {

// Axis that separates the two solids, or along which they overlap.
struct Axis {
  double separation = -std::numeric_limits<double>::infinity();  // m
  Vector3d normal = Vector3d::UnitY();                           // from the second to the first, in the second's axes
  std::size_t face = 0;                                          // whose normal it is, for axes of faces
};

// Corner of a face that is being clipped.
struct Corner {
  Vector3d point;
  double weight;
  bool own_edge;  // whether the edge to the next corner belongs to the face, not to the clipping
  bool own;       // whether it is a corner of the face, not made by clipping
};

class Pair {
 public:
  Pair(const Polytope& first, const Placement& place, const Polytope& second)
      : first_(first),
        second_(second),
        place_(place),
        between_(place.point(first.centre()) - second.centre()),
        size_(std::min(first.radius(), second.radius())) {}

  double find(std::vector<Touch>& touches) {
    const Axis of_second = face_axis(second_, false), of_first = face_axis(first_, true);
    const bool takes_first = of_first.separation > of_second.separation + kAligned * size_;
    const Axis& face = takes_first ? of_first : of_second;
    if (face.separation > 0) return face.separation;
    Axis other = edge_axis();
    consider_curved(first_, true, other);
    consider_curved(second_, false, other);
    const double separation = std::max(face.separation, other.separation);
    if (separation >= 0) return separation;
    const bool prefers_face = other.separation <= face.separation + kPreference * size_;
    if (!prefers_face || !touch_face(face, takes_first, -separation, touches)) {
      touch_edges(other, -separation, touches);
    }
    return separation;
  }

 private:
  void consider(Axis& best, const Vector3d& direction, std::size_t face) const {
    const double along = symmetric_dot(direction, between_);
    const double separation =
        std::abs(along) - first_.half_width(place_.own_direction(direction)) - second_.half_width(direction);
    if (separation <= best.separation) return;
    best = {separation, along < 0 ? Vector3d(-direction) : direction, face};
  }

  // Tests the normals of the flat or the curved faces that face the other solid.
  void consider_faces(const Polytope& solid, bool is_first, bool curved, Axis& best) const {
    for (std::size_t i = 0; i < solid.faces().size(); ++i) {
      const Polytope::Face& face = solid.faces()[i];
      if (face.curved != curved) continue;
      const Vector3d normal = is_first ? Vector3d(-place_.direction(face.normal)) : face.normal;
      if (symmetric_dot(normal, between_) >= 0) consider(best, normal, i);
    }
  }
  Axis face_axis(const Polytope& solid, bool is_first) const {
    Axis best;
    consider_faces(solid, is_first, false, best);
    return best;
  }
  void consider_curved(const Polytope& solid, bool is_first, Axis& best) const {
    consider_faces(solid, is_first, true, best);
  }

  Axis edge_axis() const {
    Axis best;
    for (const Polytope::EdgeClass& edges : first_.edge_classes()) {
      const Vector3d direction = place_.direction(edges.direction);
      for (const Polytope::EdgeClass& others : second_.edge_classes()) {
        const Vector3d product = direction.cross(others.direction);
        const double square = symmetric_squared_norm(product);
        if (square > kParallelEdges) consider(best, product / std::sqrt(square), 0);
      }
    }
    return best;
  }

  Vector3d vertex(const Polytope& solid, std::int32_t index) const {
    const Vector3d& own = solid.vertices()[static_cast<std::size_t>(index)];
    return &solid == &first_ ? place_.point(own) : own;
  }
  Vector3d normal_of(const Polytope& solid, const Polytope::Face& face) const {
    return &solid == &first_ ? place_.direction(face.normal) : face.normal;
  }

  // The face of `solid` whose normal is most opposed to a direction.
  const Polytope::Face& opposite_face(const Polytope& solid, const Vector3d& direction) const {
    const Polytope::Face* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Polytope::Face& face : solid.faces()) {
      const double along = symmetric_dot(normal_of(solid, face), direction);
      if (along >= least) continue;
      least = along;
      best = &face;
    }
    return *best;
  }

  // The part of a convex polygon on the inner side of a plane (Sutherland & Hodgman 1974).
  std::vector<Corner> clip(const std::vector<Corner>& polygon, const Vector3d& outward, const Vector3d& on_plane,
                           double weight) const {
    std::vector<Corner> left;
    const double tolerance = kAligned * size_;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Corner &here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
      const double out_here = symmetric_dot(outward, here.point - on_plane);
      const double out_next = symmetric_dot(outward, next.point - on_plane);
      const bool inside = out_here <= tolerance, next_inside = out_next <= tolerance;
      if (inside) left.push_back(here);
      if (inside == next_inside) continue;
      const double part = std::clamp(out_here / (out_here - out_next), 0.0, 1.0);
      const Vector3d point = here.point + part * (next.point - here.point);
      // The new corner is where an edge of the other solid crosses the side, or a corner of the reference face.
      const double its_weight = here.own_edge ? std::max(weight, here.weight) : weight;
      left.push_back({point, its_weight, next_inside && here.own_edge, false});
    }
    return left;
  }

  // Adds the corners below a face as contact points, shifted so that the greatest depth is `least` (m). False if their
  // greatest depth was less than half of `least`: then the solids touch beside the face.
  bool touch_face(const Axis& axis, bool is_of_first, double least, std::vector<Touch>& touches) const {
    const Polytope& reference = is_of_first ? first_ : second_;
    const Polytope& other = is_of_first ? second_ : first_;
    const Polytope::Face& face = reference.faces()[axis.face];
    const Vector3d outward = normal_of(reference, face);
    std::vector<Corner> corners;
    for (const std::int32_t corner : opposite_face(other, outward).corners) {
      corners.push_back({vertex(other, corner), other.weight(), true, true});
    }
    for (std::size_t i = 0; i < face.corners.size() && !corners.empty(); ++i) {
      corners = clip(corners, side(reference, face, i), vertex(reference, face.corners[i]), reference.weight());
    }
    // Vertices may lie below the face without belonging to the opposite face, e.g. round a rim.
    std::erase_if(corners, [](const Corner& corner) { return corner.own; });
    add_vertices_within(other, reference, face, corners);
    const Vector3d on_face = vertex(reference, face.corners[0]);
    const auto depth_of = [&](const Corner& corner) { return symmetric_dot(outward, on_face - corner.point); };
    double deepest = 0;
    for (const Corner& corner : corners) deepest = std::max(deepest, depth_of(corner));
    if (deepest < 0.5 * least) return false;
    for (const Corner& corner : corners) {
      const double depth = depth_of(corner) + (least - deepest);
      if (depth > 0) touches.push_back({corner.point, axis.normal, depth, corner.weight});
    }
    return true;
  }

  // Outward unit normal of the plane through a side of a face and perpendicular to the face.
  Vector3d side(const Polytope& solid, const Polytope::Face& face, std::size_t index) const {
    const Vector3d here = vertex(solid, face.corners[index]);
    const Vector3d next = vertex(solid, face.corners[(index + 1) % face.corners.size()]);
    return unit((next - here).cross(normal_of(solid, face)));
  }

  // Adds the vertices of `solid` that are below a face of the other solid and within its sides.
  void add_vertices_within(const Polytope& solid, const Polytope& other, const Polytope::Face& face,
                           std::vector<Corner>& corners) const {
    const Vector3d outward = normal_of(other, face);
    const double offset = symmetric_dot(outward, vertex(other, face.corners[0]));
    for (std::size_t i = 0; i < solid.vertices().size(); ++i) {
      const Vector3d point = vertex(solid, static_cast<std::int32_t>(i));
      if (symmetric_dot(outward, point) > offset) continue;
      bool within = true;
      for (std::size_t k = 0; k < face.corners.size() && within; ++k) {
        const Vector3d apart = point - vertex(other, face.corners[k]);
        within = symmetric_dot(side(other, face, k), apart) <= kAligned * size_;
      }
      if (within) corners.push_back({point, solid.weight(), true, true});
    }
  }

  // The edge that reaches farthest in a direction; if several do, the first.
  Segment farthest_edge(const Polytope& solid, const Vector3d& direction) const {
    Segment best{Vector3d::Zero(), Vector3d::Zero()};
    double most = -std::numeric_limits<double>::infinity();
    for (const Polytope::EdgeClass& parallel : solid.edge_classes()) {
      for (const auto& [begin, end] : parallel.edges) {
        const Segment edge{vertex(solid, begin), vertex(solid, end)};
        const double along = symmetric_dot(direction, edge.start + edge.end);
        if (along <= most) continue;
        most = along;
        best = edge;
      }
    }
    return best;
  }

  void touch_edges(const Axis& axis, double depth, std::vector<Touch>& touches) const {
    const SegmentDistance nearest =
        closest_points(farthest_edge(first_, -axis.normal), farthest_edge(second_, axis.normal));
    touches.push_back({0.5 * (nearest.first_point + nearest.second_point), axis.normal, depth, 1});
  }

  const Polytope &first_, &second_;
  const Placement& place_;
  Vector3d between_;  // m, from the centre of the second to that of the first
  double size_;       // m, radius of the smaller one
};

}  // namespace

double find_touches(const Polytope& first, const Placement& place, const Polytope& second,
                    std::vector<Touch>& touches) {
  return Pair(first, place, second).find(touches);
}

}  // namespace netpocket
