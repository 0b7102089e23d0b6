#include "engine/bodies/mesh_output.h"

#include <fmt/format.h>

#include <bit>
#include <iterator>

namespace netpocket {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");

template <typename Number>
void append(std::string& bytes, const Number& number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
}

void append(std::string& bytes, const Eigen::Vector3d& v) {
  for (const double number : v) append(bytes, static_cast<float>(number));
}

}  // namespace

std::string obj_text(const MeshData& mesh) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (const Eigen::Vector3d& v : mesh.vertices) fmt::format_to(out, "v {} {} {}\n", v.x(), v.y(), v.z());
  for (const Triangle& t : mesh.triangles) fmt::format_to(out, "f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return text;
}

std::string binary_stl(const MeshData& mesh) {
  std::string bytes = "netpocket";
  bytes.resize(80, ' ');
  append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles) {
    append(bytes, Eigen::Vector3d(area_vector(mesh, t).normalized()));
    for (const std::int32_t corner : t) append(bytes, mesh.vertices[corner]);
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

}  // namespace netpocket
