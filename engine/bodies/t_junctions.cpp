#include "engine/bodies/t_junctions.h"

#include <algorithm>
#include <utility>

#include "engine/bodies/box_tree.h"
#include "engine/bodies/mesh_edges.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

// Corners at the ends of open edges.
std::vector<std::int32_t> border_corners(const MeshData& mesh, const std::vector<TriangleSide>& open) {
  std::vector<std::int32_t> corners;
  for (const TriangleSide& side : open) {
    const Triangle& t = mesh.triangles[side.triangle];
    corners.push_back(t[side.edge]);
    corners.push_back(t[(side.edge + 1) % 3]);
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

// Those of `corners` that lie between the ends of an edge, in order from its beginning.
std::vector<std::int32_t> corners_on(const MeshData& mesh, const Triangle& triangle, int edge,
                                     const std::vector<std::int32_t>& corners, const BoxTree& tree, double tolerance) {
  const Vector3d &from = mesh.vertices[triangle[edge]], &to = mesh.vertices[triangle[(edge + 1) % 3]];
  const Vector3d along = to - from;
  const double length = along.norm();
  std::vector<std::pair<double, std::int32_t>> found;
  Eigen::AlignedBox3d box(from.cwiseMin(to), from.cwiseMax(to));
  box.min().array() -= tolerance;
  box.max().array() += tolerance;
  tree.for_each_meeting(box, [&](std::int32_t i) {
    const std::int32_t corner = corners[i];
    if (std::count(triangle.begin(), triangle.end(), corner) > 0) return;
    const Vector3d arm = mesh.vertices[corner] - from;
    const double place = arm.dot(along) / length;
    if (place <= tolerance || place >= length - tolerance) return;
    if ((arm - place / length * along).norm() <= tolerance) found.emplace_back(place, corner);
  });
  std::sort(found.begin(), found.end());
  std::vector<std::int32_t> result;
  for (const auto& [place, corner] : found) result.push_back(corner);
  return result;
}

// Divides at most one edge of each triangle; the others are left for the next round.
std::vector<Vector3d> split_once(MeshData& mesh, double tolerance) {
  const std::vector<TriangleSide> open = find_edges(mesh).open;
  const std::vector<std::int32_t> corners = border_corners(mesh, open);
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const std::int32_t corner : corners) boxes.emplace_back(mesh.vertices[corner]);
  const BoxTree tree(std::move(boxes));
  std::vector<bool> divided(mesh.triangles.size());
  std::vector<Vector3d> places;
  for (const auto& [triangle, edge] : open) {
    if (divided[triangle]) continue;
    const Triangle whole = mesh.triangles[triangle];
    const std::vector<std::int32_t> on_it = corners_on(mesh, whole, edge, corners, tree, tolerance);
    if (on_it.empty()) continue;
    divided[triangle] = true;
    const std::int32_t opposite = whole[(edge + 2) % 3];
    std::int32_t from = whole[edge];
    for (const std::int32_t corner : on_it) {
      places.push_back(mesh.vertices[corner]);
      mesh.triangles.push_back({from, corner, opposite});
      from = corner;
    }
    mesh.triangles[triangle] = {from, whole[(edge + 1) % 3], opposite};
  }
  return places;
}

}  // namespace

std::vector<Vector3d> split_t_junctions(MeshData& mesh, double tolerance) {
  constexpr int kMostRounds = 8;
  std::vector<Vector3d> places;
  for (int round = 0; round < kMostRounds; ++round) {
    const std::vector<Vector3d> more = split_once(mesh, tolerance);
    if (more.empty()) break;
    places.insert(places.end(), more.begin(), more.end());
  }
  return places;
}

}  // namespace netpocket
