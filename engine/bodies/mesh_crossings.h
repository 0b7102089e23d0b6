#pragma once
// Finds triangles that go through each other. Any thread may call these functions.

#include <optional>
#include <utility>
#include <vector>

#include "engine/bodies/mesh_data.h"

namespace netpocket {

using Corners = std::array<Eigen::Vector3d, 3>;

// The middle of the line along which two triangles go through each other, if it lies inside both, farther than
// `tolerance` (m) from their edges. Otherwise empty: triangles that merely touch, even with their faces, do not cross.
// After Moeller (1997), A Fast Triangle-Triangle Intersection Test, J. Graphics Tools 2(2),
// doi:10.1080/10867651.1997.10487472.
std::optional<Eigen::Vector3d> crossing(const Corners& a, const Corners& b, double tolerance);

struct Crossing {
  std::int32_t a, b;      // triangles, a < b
  Eigen::Vector3d place;  // m
};

enum class CrossingPairs { of_different_parts, of_same_part };

// Crossings between triangles of different parts or of the same part, at most the first `most` in the order of the
// triangles. `parts`: part by triangle; -1: ignored. Triangles that share a corner are not compared. `tolerance` in m.
std::vector<Crossing> find_crossings(const MeshData& mesh, const std::vector<std::int32_t>& parts, CrossingPairs pairs,
                                     double tolerance, std::size_t most);

}  // namespace netpocket
