#pragma once
// Which parts of a mesh lie in which. Any thread may call these functions.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/bodies/mesh_review.h"

namespace netpocket {

// How the triangles of a part lie to the other closed parts: a triangle is in its place when the part faces outwards
// and an even number of parts hold it, or when the part is a hollow and an odd number do.
struct PartNesting {
  std::size_t in_place = 0;
  std::size_t misplaced = 0;
  std::optional<Eigen::Vector3d> place;  // of the first that is not, m
  std::optional<std::int32_t> holder;    // the smallest part that holds the first triangle, if any
};

// Of closed parts that enclose a volume; the others have no entry of interest. Overlaps of less than `tolerance` (m)
// count as touching.
std::vector<PartNesting> find_nesting(const MeshData& mesh, const std::vector<std::int32_t>& part_of,
                                      const std::vector<MeshPart>& parts, double tolerance);

}  // namespace netpocket
