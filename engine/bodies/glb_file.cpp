#include "engine/bodies/glb_file.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/bodies/mesh_text.h"

namespace netpocket {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

using GltfJson = nlohmann::json;

constexpr int kGltfByte = 5121, kGltfShort = 5123, kGltfInt = 5125, kGltfFloat = 5126;  // unsigned but for the last
constexpr std::size_t kChunkHeader = 8, kFileHeader = 12;
constexpr int kTriangleList = 4, kTriangleStrip = 5, kTriangleFan = 6;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + at, sizeof(number));
  return number;
}

// The content of the chunk at the front of the bytes, which it takes away.
std::string_view take_chunk(std::string_view& bytes, std::uint32_t type) {
  if (bytes.size() < kChunkHeader) throw MeshFileError("is cut off: a chunk of it is missing");
  const std::size_t size = number_at(bytes, 0);
  if (number_at(bytes, 4) != type) throw MeshFileError("is not binary glTF: its chunks are none of that format");
  if (bytes.size() - kChunkHeader < size) throw MeshFileError("is cut off: a chunk of it is shorter than it states");
  const std::string_view content = bytes.substr(kChunkHeader, size);
  bytes.remove_prefix(kChunkHeader + size);
  return content;
}

// A whole number that is not below zero; `fallback` if there is none of that name.
std::size_t count_in(const GltfJson& object, const char* key, std::size_t fallback) {
  const auto found = object.find(key);
  if (found == object.end()) return fallback;
  if (!found->is_number_unsigned()) throw MeshFileError(fmt::format("cannot be read: {} is no whole number", key));
  return found->get<std::size_t>();
}

std::size_t required_count(const GltfJson& object, const char* key) {
  if (!object.is_object() || !object.contains(key)) {
    throw MeshFileError(fmt::format("cannot be read: a part of it has no {}", key));
  }
  return count_in(object, key, 0);
}

class GlbFile {
 public:
  GlbFile(GltfJson json, std::string_view binary, double scale)
      : json_(std::move(json)), binary_(binary), scale_(scale) {}

  MeshData read() {
    refuse_compression();
    const GltfJson& nodes = list("nodes");
    visited_.assign(nodes.size(), false);
    for (const GltfJson& root : item("scenes", count_in(json_, "scene", 0)).value("nodes", GltfJson::array())) {
      add_nodes(root);
    }
    return std::move(mesh_);
  }

 private:
  struct Placed {
    std::size_t node;
    Eigen::Affine3d parent;
  };

  void refuse_compression() const {
    for (const GltfJson& name : json_.value("extensionsRequired", GltfJson::array())) {
      const std::string text = name.get<std::string>();
      if (text.find("compression") == text.npos && text.find("quantization") == text.npos) continue;
      throw MeshFileError(fmt::format("is compressed ({:.40}): save it without compression", text));
    }
  }

  const GltfJson& list(const char* name) const {
    const auto found = json_.find(name);
    if (found == json_.end() || !found->is_array())
      throw MeshFileError(fmt::format("cannot be read: it has no {}", name));
    return *found;
  }
  const GltfJson& item(const char* name, std::size_t index) const {
    const GltfJson& items = list(name);
    if (index >= items.size()) throw MeshFileError(fmt::format("cannot be read: it names {} that do not exist", name));
    return items[index];
  }

  static Eigen::Affine3d place_of(const GltfJson& node) {
    Eigen::Affine3d place = Eigen::Affine3d::Identity();
    if (node.contains("matrix")) {
      const auto columns = node["matrix"].get<std::array<double, 16>>();
      place.matrix() = Eigen::Map<const Eigen::Matrix4d>(columns.data());
      place.matrix().row(3) << 0, 0, 0, 1;
      return place;
    }
    const auto move = node.value("translation", std::array<double, 3>{0, 0, 0});
    const auto turn = node.value("rotation", std::array<double, 4>{0, 0, 0, 1});
    const auto stretch = node.value("scale", std::array<double, 3>{1, 1, 1});
    place.translate(Eigen::Map<const Eigen::Vector3d>(move.data()));
    place.rotate(Eigen::Quaterniond(turn[3], turn[0], turn[1], turn[2]).normalized());
    place.scale(Eigen::Map<const Eigen::Vector3d>(stretch.data()));
    return place;
  }

  // A node with all below it. Nodes are a forest; whoever meets one twice goes round in a circle.
  void add_nodes(const GltfJson& root) {
    std::vector<Placed> open = {{root.get<std::size_t>(), Eigen::Affine3d::Identity()}};
    while (!open.empty()) {
      const Placed next = open.back();
      open.pop_back();
      const GltfJson& node = item("nodes", next.node);
      if (visited_[next.node]) throw MeshFileError("cannot be read: a node of it has two parents");
      visited_[next.node] = true;
      const Eigen::Affine3d place = next.parent * place_of(node);
      if (node.contains("mesh")) add_mesh(item("meshes", required_count(node, "mesh")), place);
      for (const GltfJson& child : node.value("children", GltfJson::array())) {
        open.push_back({child.get<std::size_t>(), place});
      }
    }
  }

  void add_mesh(const GltfJson& mesh, const Eigen::Affine3d& place) {
    for (const GltfJson& primitive : mesh.value("primitives", GltfJson::array())) {
      const auto mode = primitive.value("mode", kTriangleList);
      if (mode < kTriangleList) continue;  // points and lines
      if (mode > kTriangleFan) throw MeshFileError("cannot be read: a mesh is of no known kind");
      const auto first = static_cast<std::int32_t>(mesh_.vertices.size());
      const GltfJson attributes = primitive.value("attributes", GltfJson::object());
      const std::size_t points = add_points(item("accessors", required_count(attributes, "POSITION")), place);
      std::vector<std::uint32_t> corners;
      if (primitive.contains("indices")) {
        corners = indices(item("accessors", required_count(primitive, "indices")), points);
      } else {
        for (std::uint32_t i = 0; i < points; ++i) corners.push_back(i);
      }
      add_triangles(corners, mode, first, place.linear().determinant() < 0);
    }
  }

  void add_triangles(const std::vector<std::uint32_t>& corners, int mode, std::int32_t first, bool mirrored) {
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      require_room_for_triangles(mesh_.triangles.size() + 1);
      if (mirrored) std::swap(b, c);  // so that it is seen from outside again
      const auto corner = [&](std::size_t i) { return first + static_cast<std::int32_t>(corners[i]); };
      mesh_.triangles.push_back({corner(a), corner(b), corner(c)});
    };
    for (std::size_t i = 0; i + 2 < corners.size(); i += mode == kTriangleList ? 3 : 1) {
      if (mode == kTriangleFan) {
        add(0, i + 1, i + 2);
      } else if (mode == kTriangleStrip && i % 2 == 1) {
        add(i + 1, i, i + 2);
      } else {
        add(i, i + 1, i + 2);
      }
    }
  }

  // Where the elements of an accessor are.
  struct Elements {
    const char* data;
    std::size_t count, stride;
    int type;
  };

  Elements elements(const GltfJson& accessor, const char* kind, std::size_t components) const {
    if (accessor.contains("sparse"))
      throw MeshFileError("cannot be read: its values are sparse, which is not supported");
    if (accessor.value("type", "") != kind) throw MeshFileError(fmt::format("cannot be read: values are not {}", kind));
    const auto type = static_cast<int>(required_count(accessor, "componentType"));
    const std::size_t bytes = type == kGltfByte ? 1 : type == kGltfShort ? 2 : 4, size = components * bytes;
    const GltfJson& view = item("bufferViews", required_count(accessor, "bufferView"));
    const GltfJson& buffer = item("buffers", count_in(view, "buffer", 0));
    if (buffer.contains("uri"))
      throw MeshFileError("names other files, which are not opened: save it as one .glb file");
    const std::size_t stride = count_in(view, "byteStride", size), count = required_count(accessor, "count");
    const std::size_t begin = count_in(view, "byteOffset", 0), length = required_count(view, "byteLength");
    const std::size_t offset = count_in(accessor, "byteOffset", 0);
    const bool fits = begin <= binary_.size() && length <= binary_.size() - begin && offset <= length &&
                      stride >= size && stride <= 255 && count <= binary_.size() &&
                      (count == 0 || (count - 1) * stride + size <= length - offset);
    if (!fits) throw MeshFileError("is cut off: values of it lie behind its end");
    return {binary_.data() + begin + offset, count, stride, type};
  }

  std::size_t add_points(const GltfJson& accessor, const Eigen::Affine3d& place) {
    const Elements points = elements(accessor, "VEC3", 3);
    if (points.type != kGltfFloat) throw MeshFileError("is compressed (quantized): save it without compression");
    require_room_for_triangles((mesh_.vertices.size() + points.count) / 3);
    for (std::size_t i = 0; i < points.count; ++i) {
      Eigen::Vector3f point;
      std::memcpy(point.data(), points.data + i * points.stride, 3 * sizeof(float));
      mesh_.vertices.push_back(scale_ * (place * point.cast<double>()));
    }
    return points.count;
  }

  std::vector<std::uint32_t> indices(const GltfJson& accessor, std::size_t points) const {
    const Elements values = elements(accessor, "SCALAR", 1);
    if (values.type != kGltfByte && values.type != kGltfShort && values.type != kGltfInt) {
      throw MeshFileError("cannot be read: corners are no whole numbers");
    }
    const std::size_t bytes = values.type == kGltfByte ? 1 : values.type == kGltfShort ? 2 : 4;
    std::vector<std::uint32_t> corners(values.count, 0);
    for (std::size_t i = 0; i < values.count; ++i) {
      std::memcpy(&corners[i], values.data + i * values.stride, bytes);
      if (corners[i] >= points) throw MeshFileError("cannot be read: a face names a vertex that does not exist");
    }
    return corners;
  }

  GltfJson json_;
  std::string_view binary_;
  double scale_;
  MeshData mesh_;
  std::vector<bool> visited_;  // by node
};

}  // namespace

MeshData parse_glb(std::string_view bytes, double scale) {
  if (bytes.empty()) throw MeshFileError("is empty");
  if (!bytes.starts_with("glTF") || bytes.size() < kFileHeader) {
    throw MeshFileError("is not binary glTF: it does not begin with \"glTF\"");
  }
  if (number_at(bytes, 4) != 2) throw MeshFileError("is not glTF 2.0: save it in that version");
  bytes.remove_prefix(kFileHeader);
  const std::string_view text = take_chunk(bytes, kJsonChunk);
  const std::string_view binary = bytes.empty() ? std::string_view() : take_chunk(bytes, kBinaryChunk);
  try {
    return GlbFile(GltfJson::parse(text), binary, scale).read();
  } catch (const GltfJson::exception&) {
    throw MeshFileError("is not glTF: what it says of itself is damaged");
  }
}

}  // namespace netpocket
