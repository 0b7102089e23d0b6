#pragma once
// Reads triangle meshes from untrusted files: STL (binary and ASCII), Wavefront OBJ and Stanford PLY (vertices and
// faces; plane polygons become triangles) and binary glTF (triangles of the scene). Everything else in a file is
// ignored; other files that it names, such as materials, are not opened. Any thread may call these functions.

#include <string>
#include <string_view>
#include <variant>

#include "engine/bodies/mesh_data.h"

namespace netpocket {

// Larger files are refused without reading them.
inline constexpr std::size_t kLargestMeshFile = 500'000'000;  // bytes

// Returns the triangles as they are in the file, with coordinates multiplied by `scale`. If the file cannot be read,
// returns the rest of a sentence that begins with the file's name ("is empty"). The name must end in .stl, .obj, .ply
// or .glb.
std::variant<MeshData, std::string> read_mesh_file(const std::string& path, double scale);

// The same for the bytes of a file.
std::variant<MeshData, std::string> read_stl(std::string_view bytes, double scale);
std::variant<MeshData, std::string> read_obj(std::string_view bytes, double scale);
std::variant<MeshData, std::string> read_ply(std::string_view bytes, double scale);
std::variant<MeshData, std::string> read_glb(std::string_view bytes, double scale);

}  // namespace netpocket
