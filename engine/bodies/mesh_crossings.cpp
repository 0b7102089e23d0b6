#include "engine/bodies/mesh_crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "engine/bodies/box_tree.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

Corners corners_of(const MeshData& mesh, std::int32_t triangle) {
  const Triangle& t = mesh.triangles[triangle];
  return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

Vector3d unit_normal(const Corners& t) { return (t[1] - t[0]).cross(t[2] - t[0]).normalized(); }

// Signed distances of a triangle's corners from the plane of another triangle.
struct Heights {
  std::array<double, 3> of;

  Heights(const Corners& corners, const Vector3d& normal, const Vector3d& origin) {
    for (int i = 0; i < 3; ++i) of[i] = normal.dot(corners[i] - origin);
  }
  bool on_both_sides(double tolerance) const {
    const auto [low, high] = std::minmax_element(of.begin(), of.end());
    return *low<-tolerance&& * high> tolerance;
  }
};

// The segment in which a triangle meets the plane from which its corners have these heights.
struct Chord {
  Vector3d ends[2];
  int count = 0;

  Chord(const Corners& corners, const Heights& heights) {
    for (int i = 0; i < 3; ++i) {
      const double here = heights.of[i], there = heights.of[(i + 1) % 3];
      if (here == 0) add(corners[i]);
      if (here * there < 0) add(corners[i] + here / (here - there) * (corners[(i + 1) % 3] - corners[i]));
    }
  }
  void add(const Vector3d& point) {
    if (count < 2) ends[count++] = point;
  }
};

// Whether a point in the triangle's plane is inside it, farther than `tolerance` from its edges.
bool is_well_inside(const Vector3d& point, const Corners& t, const Vector3d& normal, double tolerance) {
  for (int i = 0; i < 3; ++i) {
    const Vector3d side = t[(i + 1) % 3] - t[i];
    if (normal.cross(side).dot(point - t[i]) <= tolerance * side.norm()) return false;
  }
  return true;
}

Eigen::AlignedBox3d box_of(const Corners& corners) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& corner : corners) box.extend(corner);
  return box;
}

bool share_corner(const Triangle& a, const Triangle& b) {
  return std::any_of(a.begin(), a.end(), [&](std::int32_t c) { return std::count(b.begin(), b.end(), c) > 0; });
}

// Triangles whose box intersects the box of another part. Only these can cross another part.
std::vector<std::int32_t> candidates(const MeshData& mesh, const std::vector<std::int32_t>& parts) {
  const std::int32_t count = parts.empty() ? 0 : *std::max_element(parts.begin(), parts.end()) + 1;
  std::vector<Eigen::AlignedBox3d> boxes(static_cast<std::size_t>(count));
  for (std::size_t t = 0; t < parts.size(); ++t) {
    if (parts[t] >= 0) boxes[parts[t]].extend(box_of(corners_of(mesh, static_cast<std::int32_t>(t))));
  }
  const BoxTree tree(boxes);
  std::vector<std::int32_t> found;
  for (std::size_t t = 0; t < parts.size(); ++t) {
    if (parts[t] < 0) continue;
    bool meets = false;
    tree.for_each_meeting(box_of(corners_of(mesh, static_cast<std::int32_t>(t))),
                          [&](std::int32_t part) { meets = meets || part != parts[t]; });
    if (meets) found.push_back(static_cast<std::int32_t>(t));
  }
  return found;
}

std::vector<std::int32_t> all_of(const std::vector<std::int32_t>& parts) {
  std::vector<std::int32_t> found;
  for (std::size_t t = 0; t < parts.size(); ++t) {
    if (parts[t] >= 0) found.push_back(static_cast<std::int32_t>(t));
  }
  return found;
}

}  // namespace

std::optional<Vector3d> crossing(const Corners& a, const Corners& b, double tolerance) {
  const Vector3d normal_a = unit_normal(a), normal_b = unit_normal(b);
  const Heights of_b(b, normal_a, a[0]);
  if (!of_b.on_both_sides(tolerance)) return std::nullopt;
  const Heights of_a(a, normal_b, b[0]);
  if (!of_a.on_both_sides(tolerance)) return std::nullopt;
  const Chord chord_a(a, of_a), chord_b(b, of_b);
  if (chord_a.count < 2 || chord_b.count < 2) return std::nullopt;
  // Both chords lie on the line in which the planes meet.
  const Vector3d line = normal_a.cross(normal_b).normalized();
  const Vector3d& origin = chord_a.ends[0];
  const auto place = [&](const Vector3d& point) { return line.dot(point - origin); };
  const auto [low_a, high_a] = std::minmax({place(chord_a.ends[0]), place(chord_a.ends[1])});
  const auto [low_b, high_b] = std::minmax({place(chord_b.ends[0]), place(chord_b.ends[1])});
  const double low = std::max(low_a, low_b), high = std::min(high_a, high_b);
  if (high - low <= 2 * tolerance) return std::nullopt;
  const Vector3d middle = origin + (low + high) / 2 * line;
  const bool inside = is_well_inside(middle, a, normal_a, tolerance) && is_well_inside(middle, b, normal_b, tolerance);
  return inside ? std::optional(middle) : std::nullopt;
}

std::vector<Crossing> find_crossings(const MeshData& mesh, const std::vector<std::int32_t>& parts, CrossingPairs pairs,
                                     double tolerance, std::size_t most) {
  const bool same = pairs == CrossingPairs::of_same_part;
  const std::vector<std::int32_t> triangles = same ? all_of(parts) : candidates(mesh, parts);
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(triangles.size());
  for (const std::int32_t t : triangles) boxes.push_back(box_of(corners_of(mesh, t)));
  const BoxTree tree(boxes);
  std::vector<Crossing> found;
  for (std::size_t i = 0; i < triangles.size() && found.size() < most; ++i) {
    const std::int32_t a = triangles[i];
    const std::size_t before = found.size();
    tree.for_each_meeting(boxes[i], [&](std::int32_t other) {
      const std::int32_t b = triangles[other];
      if (b <= a || (parts[a] == parts[b]) != same || share_corner(mesh.triangles[a], mesh.triangles[b])) return;
      if (const auto place = crossing(corners_of(mesh, a), corners_of(mesh, b), tolerance)) {
        found.push_back({a, b, *place});
      }
    });
    std::sort(found.begin() + static_cast<std::ptrdiff_t>(before), found.end(),
              [](const Crossing& p, const Crossing& q) { return p.b < q.b; });
  }
  if (found.size() > most) found.resize(most);
  return found;
}

}  // namespace netpocket
