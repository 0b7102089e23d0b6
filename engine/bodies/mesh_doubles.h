#pragma once
// Triangles that lie on each other, corner on corner. Any thread may call these functions.

#include <vector>

#include "engine/bodies/mesh_data.h"

namespace netpocket {

// Triangles that have the corners of an earlier one and face the same way, in their order.
std::vector<std::int32_t> find_doubles(const MeshData& mesh);

// By triangle: the one that has the same corners and faces the other way; -1: none.
std::vector<std::int32_t> find_backs(const MeshData& mesh);

// Leaves out the triangles that are marked.
void drop_triangles(MeshData& mesh, const std::vector<bool>& dropped);

}  // namespace netpocket
