#pragma once
// Writes meshes as the contents of files. Any thread may call these functions.

#include <string>

#include "engine/bodies/mesh_data.h"

namespace netpocket {

// Wavefront OBJ. Coordinates have the fewest digits that read back to the same number.
std::string obj_text(const MeshData& mesh);

// Binary STL. Coordinates are in single precision.
std::string binary_stl(const MeshData& mesh);

}  // namespace netpocket
