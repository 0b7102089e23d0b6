#pragma once
// STL, binary and ASCII.

#include <string_view>

#include "engine/bodies/mesh_data.h"

namespace netpocket {

// Reads triangles, each with corners of its own, with coordinates multiplied by `scale`. Throws MeshFileError if the
// file cannot be read.
MeshData parse_stl(std::string_view bytes, double scale);

}  // namespace netpocket
