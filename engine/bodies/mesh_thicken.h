#pragma once
// Turns open surfaces into plates. Any thread may call these functions.

#include "engine/bodies/mesh_data.h"

namespace netpocket {

// Replaces each part that has open edges by two sides, half of `thickness` before and behind it, and walls along its
// open edges. `thickness` is in the unit of the mesh. Where faces meet at an angle, the sides keep this distance from
// each face. Neighbours must face the same way. Closed parts stay unchanged. Returns the number of thickened parts.
std::size_t thicken_open_parts(MeshData& mesh, double thickness);

}  // namespace netpocket
