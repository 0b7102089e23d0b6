#pragma once
// Binary glTF 2.0 (.glb, Khronos specification): the triangles of its scene.

#include <string_view>

#include "engine/bodies/mesh_data.h"

namespace netpocket {

// Reads the triangles of every mesh in the default scene, where its nodes place them, with coordinates multiplied by
// `scale` (glTF itself is in metres). Materials, skins, animations and lines are ignored; no other file is opened.
// Throws MeshFileError if the file cannot be read.
MeshData parse_glb(std::string_view bytes, double scale);

}  // namespace netpocket
