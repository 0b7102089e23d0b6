#pragma once
// STL, binary and ASCII.

#include <string_view>

#include "engine/bodies/mesh_data.h"

namespace netpocket {

// Each triangle with corners of its own, coordinates times `scale`. Throws MeshFileError.
MeshData parse_stl(std::string_view bytes, double scale);

}  // namespace netpocket
