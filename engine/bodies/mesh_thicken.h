#pragma once
// Open surfaces as plates. Any thread may call these functions.

#include "engine/bodies/mesh_data.h"

namespace netpocket {

// Gives each part that has open edges two sides, half of `thickness` (m) before and behind it, and walls along its open
// edges. Where faces meet at an angle, both sides keep their distance from each of them. Neighbours must face the same
// way. The number of such parts; closed ones stay.
std::size_t thicken_open_parts(MeshData& mesh, double thickness);

}  // namespace netpocket
