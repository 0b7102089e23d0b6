#pragma once
// Wavefront OBJ: vertices and faces.

#include <string_view>

#include "engine/bodies/mesh_data.h"

namespace netpocket {

// Faces as triangles, coordinates times `scale`. Nothing else that the file names is followed. Throws MeshFileError.
MeshData parse_obj(std::string_view bytes, double scale);

}  // namespace netpocket
