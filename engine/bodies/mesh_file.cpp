#include "engine/bodies/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "engine/bodies/glb_file.h"
#include "engine/bodies/mesh_text.h"
#include "engine/bodies/obj_file.h"
#include "engine/bodies/ply_file.h"
#include "engine/bodies/stl_file.h"

namespace netpocket {
namespace {

using Parser = MeshData (*)(std::string_view bytes, double scale);

std::variant<MeshData, std::string> guarded(Parser parser, std::string_view bytes, double scale) {
  try {
    return parser(bytes, scale);
  } catch (const MeshFileError& error) {
    return std::string(error.what());
  }
}

struct Format {
  std::string_view extension;
  Parser parser;
};
constexpr std::array kFormats = {Format{".stl", &parse_stl}, Format{".obj", &parse_obj}, Format{".ply", &parse_ply},
                                 Format{".glb", &parse_glb}};

// Why a file of another format is not read, with the way to go.
std::string refusal(std::string_view extension) {
  constexpr std::array<std::string_view, 4> kCad = {".step", ".stp", ".iges", ".igs"};
  if (std::ranges::find(kCad, extension) != kCad.end()) {
    return "is a CAD file with curved surfaces, not a mesh: make an STL file of it, for example with FreeCAD or with "
           "Gmsh (gmsh part.step -2 -o part.stl)";
  }
  if (extension == ".gltf") return "is glTF in several files: save it as one binary file, .glb";
  return "must be a mesh file, .stl, .obj, .ply or .glb";
}

}  // namespace

std::variant<MeshData, std::string> read_stl(std::string_view bytes, double scale) {
  return guarded(&parse_stl, bytes, scale);
}

std::variant<MeshData, std::string> read_obj(std::string_view bytes, double scale) {
  return guarded(&parse_obj, bytes, scale);
}

std::variant<MeshData, std::string> read_ply(std::string_view bytes, double scale) {
  return guarded(&parse_ply, bytes, scale);
}

std::variant<MeshData, std::string> read_glb(std::string_view bytes, double scale) {
  return guarded(&parse_glb, bytes, scale);
}

std::variant<MeshData, std::string> read_mesh_file(const std::string& path, double scale) {
  const std::string extension = lower_case(std::filesystem::path(path).extension().string());
  const auto format = std::ranges::find(kFormats, extension, &Format::extension);
  if (format == kFormats.end()) return refusal(extension);
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) return std::string("does not exist");
  if (!std::filesystem::is_regular_file(status)) return std::string("is not a file");
  const auto size = std::filesystem::file_size(path, error);
  if (error) return "cannot be read: " + error.message();
  if (size > kLargestMeshFile)
    return fmt::format("is larger than {} MB, the limit for a mesh", kLargestMeshFile / 1'000'000);
  std::ifstream file(path, std::ios::binary);
  std::string bytes(size, '\0');
  if (!file) return fmt::format("cannot be read: {}", std::strerror(errno));
  file.read(bytes.data(), static_cast<std::streamsize>(size));
  if (file.gcount() != static_cast<std::streamsize>(size)) return std::string("cannot be read: input error");
  return guarded(format->parser, bytes, scale);
}

}  // namespace netpocket
