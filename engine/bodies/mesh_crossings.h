#pragma once
// Where triangles go through each other. Any thread may call these functions.

#include <optional>
#include <utility>
#include <vector>

#include "engine/bodies/mesh_data.h"

namespace netpocket {

using Corners = std::array<Eigen::Vector3d, 3>;

// The middle of the line along which two triangles go through each other, when it lies in the inside of both, farther
// than `tolerance` (m) from their edges. Triangles that touch, also with a face, do not. After Moeller (1997), A Fast
// Triangle-Triangle Intersection Test, J. Graphics Tools 2(2), doi:10.1080/10867651.1997.10487472.
std::optional<Eigen::Vector3d> crossing(const Corners& a, const Corners& b, double tolerance);

struct Crossing {
  std::int32_t a, b;  // triangles, a < b
  Eigen::Vector3d place;
};

enum class CrossingPairs { of_different_parts, of_same_part };

// Crossings of triangles of parts (by triangle; -1: not looked at), the first `most` by the order of the triangles.
// Triangles that share a corner are not compared.
std::vector<Crossing> find_crossings(const MeshData& mesh, const std::vector<std::int32_t>& parts, CrossingPairs pairs,
                                     double tolerance, std::size_t most);

}  // namespace netpocket
