#pragma once
// Finds which parts of a mesh lie inside others. Any thread may call these functions.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/bodies/mesh_review.h"

namespace netpocket {

// Nesting of a part in the other closed parts. A triangle is in its place if the part faces outwards and an even number
// of parts contain it, or if the part is a hollow (faces inwards) and an odd number contain it.
struct PartNesting {
  std::size_t in_place = 0;              // number of triangles
  std::size_t misplaced = 0;             // number of triangles
  std::optional<Eigen::Vector3d> place;  // m, centroid of the first misplaced triangle
  std::optional<std::int32_t> holder;    // the smallest part that contains the first triangle, if any
};

// Nesting of each part. Only closed parts that enclose a volume are examined; the entries of others are empty. Overlaps
// of less than `tolerance` (m) count as touching. `part_of`: part by triangle.
std::vector<PartNesting> find_nesting(const MeshData& mesh, const std::vector<std::int32_t>& part_of,
                                      const std::vector<MeshPart>& parts, double tolerance);

}  // namespace netpocket
