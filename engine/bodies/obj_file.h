#pragma once
// Wavefront OBJ: vertices and faces.

#include <string_view>

#include "engine/bodies/mesh_data.h"

namespace netpocket {

// Reads faces as triangles, with coordinates multiplied by `scale`. Everything else in the file is ignored. Throws
// MeshFileError if the file cannot be read.
MeshData parse_obj(std::string_view bytes, double scale);

}  // namespace netpocket
