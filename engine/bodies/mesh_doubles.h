#pragma once
// Triangles that have the same three corners. Any thread may call these functions.

#include <vector>

#include "engine/bodies/mesh_data.h"

namespace netpocket {

// Triangles with the same corners as an earlier one and the same orientation, in ascending order.
std::vector<std::int32_t> find_doubles(const MeshData& mesh);

// By triangle: the one with the same corners and the opposite orientation; -1: none.
std::vector<std::int32_t> find_backs(const MeshData& mesh);

// Removes the marked triangles. `dropped`: by triangle.
void drop_triangles(MeshData& mesh, const std::vector<bool>& dropped);

}  // namespace netpocket
