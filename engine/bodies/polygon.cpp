#include "engine/bodies/polygon.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "engine/math/elementary.h"

namespace netpocket {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }
double cross(const Vector2d& a, const Vector2d& b, const Vector2d& c) { return cross(b - a, c - a); }

CornerTriples fan(std::int32_t corners) {
  CornerTriples triangles;
  for (std::int32_t i = 2; i < corners; ++i) triangles.push_back({0, i - 1, i});
  return triangles;
}

// The polygon in its plane, seen from the side from which it runs counter-clockwise. It has no corners if they lie on a
// line.
struct FlatPolygon {
  std::vector<Vector2d> corners;
  double area = 0;    // m^2
  double extent = 0;  // m
};

bool lie_on_a_line(std::span<const Vector3d> corners, double extent) {
  const auto farthest = *std::max_element(corners.begin(), corners.end(), [&](const Vector3d& a, const Vector3d& b) {
    return (a - corners[0]).squaredNorm() < (b - corners[0]).squaredNorm();
  });
  const Vector3d line = (farthest - corners[0]).normalized();
  return std::all_of(corners.begin(), corners.end(),
                     [&](const Vector3d& corner) { return line.cross(corner - corners[0]).norm() <= 1e-9 * extent; });
}

std::variant<FlatPolygon, std::string> flatten(std::span<const Vector3d> corners) {
  Vector3d middle = Vector3d::Zero();
  Eigen::AlignedBox3d box;
  for (const Vector3d& corner : corners) {
    middle += corner / static_cast<double>(corners.size());
    box.extend(corner);
  }
  Vector3d area = Vector3d::Zero();  // area vector by Newell's method
  for (std::size_t i = 0; i < corners.size(); ++i) {
    area += (corners[i] - middle).cross(corners[(i + 1) % corners.size()] - middle) / 2;
  }
  FlatPolygon flat;
  flat.extent = box.diagonal().norm();
  flat.area = area.norm();
  constexpr double kNoArea = 1e-12;  // fraction of the square of the extent
  if (!(flat.area > kNoArea * flat.extent * flat.extent)) {
    if (lie_on_a_line(corners, flat.extent)) return FlatPolygon{};
    return std::string("a face crosses itself");
  }
  const Vector3d normal = area / flat.area, x = normal.unitOrthogonal(), y = normal.cross(x);
  double height = 0;
  for (const Vector3d& corner : corners) {
    height = std::max(height, std::abs(normal.dot(corner - middle)));
    flat.corners.emplace_back(x.dot(corner - middle), y.dot(corner - middle));
  }
  if (height > kPolygonFlatness * flat.extent) {
    return fmt::format(
        "a face is not plane: a corner lies {:.2g} of its extent off its plane ({:g} is allowed); export "
        "it as triangles",
        height / flat.extent, kPolygonFlatness);
  }
  return flat;
}

// A convex polygon turns left at each corner, by one full turn in all.
bool is_convex(const FlatPolygon& polygon) {
  const auto& p = polygon.corners;
  const std::size_t count = p.size();
  double turned = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector2d in = p[(i + 1) % count] - p[i], out = p[(i + 2) % count] - p[(i + 1) % count];
    if (cross(in, out) <= 1e-9 * in.norm() * out.norm()) return false;
    turned += arc_tangent(cross(in, out), in.dot(out));
  }
  return turned < 7;  // one turn is 2 pi, two turns are 4 pi
}

// Whether two sides cross in their interiors, not at their ends.
bool crosses_itself(const FlatPolygon& polygon) {
  const auto& p = polygon.corners;
  const std::size_t count = p.size();
  const double least = 1e-12 * polygon.extent * polygon.extent;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector2d &a = p[i], &b = p[(i + 1) % count];
    for (std::size_t k = i + 2; k < count; ++k) {
      const Vector2d &c = p[k], &d = p[(k + 1) % count];
      const double c_side = cross(a, b, c), d_side = cross(a, b, d), a_side = cross(c, d, a), b_side = cross(c, d, b);
      const auto opposite = [&](double s, double t) { return (s > least && t < -least) || (s < -least && t > least); };
      if (opposite(c_side, d_side) && opposite(a_side, b_side)) return true;
    }
  }
  return false;
}

class EarCutter {
 public:
  explicit EarCutter(const FlatPolygon& polygon)
      : corners_(polygon.corners), least_(1e-12 * polygon.extent * polygon.extent), left_(corners_.size()) {
    std::iota(left_.begin(), left_.end(), 0);
  }

  std::optional<CornerTriples> cut() {
    CornerTriples triangles;
    std::size_t at = 0;
    while (left_.size() > 3) {
      const auto ear = find_ear(at);
      if (!ear) return std::nullopt;
      triangles.push_back({left_[before(*ear)], left_[*ear], left_[after(*ear)]});
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(*ear));
      // The search continues behind this ear, which avoids fans of narrow triangles.
      at = *ear % left_.size();
    }
    triangles.push_back({left_[0], left_[1], left_[2]});
    return triangles;
  }

 private:
  std::size_t before(std::size_t i) const { return (i + left_.size() - 1) % left_.size(); }
  std::size_t after(std::size_t i) const { return (i + 1) % left_.size(); }
  const Vector2d& corner(std::size_t i) const { return corners_[left_[i]]; }
  double turn(std::size_t i) const { return cross(corner(before(i)), corner(i), corner(after(i))); }

  // Finds an ear, beginning at `start`. Takes one without area (on a straight side) only if there is no other.
  std::optional<std::size_t> find_ear(std::size_t start) const {
    std::optional<std::size_t> flat;
    for (std::size_t k = 0; k < left_.size(); ++k) {
      const std::size_t i = (start + k) % left_.size();
      const double area = turn(i);
      if (area > least_ && is_free(i)) return i;
      if (!flat && std::abs(area) <= least_) flat = i;
    }
    return flat;
  }

  // Whether no other corner is inside the ear. Corners that coincide with its own do not count.
  bool is_free(std::size_t i) const {
    const Vector2d &a = corner(before(i)), &b = corner(i), &c = corner(after(i));
    for (std::size_t k = 0; k < left_.size(); ++k) {
      const Vector2d& p = corner(k);
      if (p == a || p == b || p == c || turn(k) > least_) continue;
      if (cross(a, b, p) >= -least_ && cross(b, c, p) >= -least_ && cross(c, a, p) >= -least_) return false;
    }
    return true;
  }

  const std::vector<Vector2d>& corners_;
  double least_;  // m^2
  std::vector<std::int32_t> left_;
};

}  // namespace

std::variant<CornerTriples, std::string> triangulate(std::span<const Vector3d> corners) {
  if (corners.size() < 3) return std::string("a face has fewer than three corners");
  if (corners.size() > kMostPolygonCorners) {
    return fmt::format("a face has {} corners; {} are allowed", corners.size(), kMostPolygonCorners);
  }
  if (corners.size() == 3) return fan(3);
  for (const Vector3d& corner : corners) {
    if (!corner.allFinite()) return fan(static_cast<std::int32_t>(corners.size()));  // number_fault() will report it
  }
  auto flat = flatten(corners);
  if (auto* problem = std::get_if<std::string>(&flat)) return std::move(*problem);
  const auto& polygon = std::get<FlatPolygon>(flat);
  if (polygon.corners.empty() || is_convex(polygon)) return fan(static_cast<std::int32_t>(corners.size()));
  if (crosses_itself(polygon)) return std::string("a face crosses itself");
  if (auto triangles = EarCutter(polygon).cut()) return std::move(*triangles);
  return std::string("a face crosses itself");
}

}  // namespace netpocket
