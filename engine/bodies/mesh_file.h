#pragma once
// Triangle meshes from files that nobody vouches for: STL (binary and ASCII) and Wavefront OBJ (vertices and faces;
// plane polygons become triangles). Nothing else that a file names, such as materials, is followed. Any thread may call
// it.

#include <string>
#include <string_view>
#include <variant>

#include "engine/bodies/mesh_data.h"

namespace netpocket {

// Larger files are refused, unread.
inline constexpr std::size_t kLargestMeshFile = 500'000'000;  // bytes

// The triangles as they stand in the file, coordinates times `scale`; or the rest of a sentence that begins with the
// file's name ("is empty").
// The file's name must end in .stl or .obj.
std::variant<MeshData, std::string> read_mesh_file(const std::string& path, double scale);

// The same from the bytes of a file.
std::variant<MeshData, std::string> read_stl(std::string_view bytes, double scale);
std::variant<MeshData, std::string> read_obj(std::string_view bytes, double scale);

}  // namespace netpocket
