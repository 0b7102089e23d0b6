#include "engine/bodies/mesh_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "engine/bodies/mesh_text.h"
#include "engine/bodies/obj_file.h"
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

}  // namespace

std::variant<MeshData, std::string> read_stl(std::string_view bytes, double scale) {
  return guarded(&parse_stl, bytes, scale);
}

std::variant<MeshData, std::string> read_obj(std::string_view bytes, double scale) {
  return guarded(&parse_obj, bytes, scale);
}

std::variant<MeshData, std::string> read_mesh_file(const std::string& path, double scale) {
  const std::string extension = lower_case(std::filesystem::path(path).extension().string());
  if (extension != ".stl" && extension != ".obj") return std::string("must be a mesh file, .stl or .obj");
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
  return extension == ".stl" ? read_stl(bytes, scale) : read_obj(bytes, scale);
}

}  // namespace netpocket
