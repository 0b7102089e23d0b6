#pragma once
// Stanford PLY (the Polygon File Format, Turk 1994), ASCII and binary: vertices and faces.

#include <string_view>

#include "engine/bodies/mesh_data.h"

namespace netpocket {

// Reads faces as triangles, with coordinates multiplied by `scale`. Every other element and property is ignored. Throws
// MeshFileError if the file cannot be read.
MeshData parse_ply(std::string_view bytes, double scale);

}  // namespace netpocket
