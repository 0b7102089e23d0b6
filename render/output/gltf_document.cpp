#include "render/output/gltf_document.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace netpocket {
namespace {

// Names of numbers in the specification (OpenGL's).
constexpr int kFloat = 5126, kUnsignedInt = 5125, kUnsignedShort = 5123, kUnsignedByte = 5121;
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963, kNoTarget = 0;
constexpr int kLines = 1, kTriangles = 4;
constexpr double kRoughness = 0.6;

using Json = nlohmann::ordered_json;

std::size_t components_of(std::string_view type) {
  if (type == "SCALAR") return 1;
  return type == "VEC3" ? 3 : type == "VEC4" ? 4 : 16;
}

// glTF's colours are linear; ours are sRGB (IEC 61966-2-1).
float linear(double srgb) {
  return static_cast<float>(srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4));
}

bool has_normal(vtkDataArray* normals, vtkIdType point) {
  const double* n = normals->GetTuple3(point);
  return n[0] != 0 || n[1] != 0 || n[2] != 0;
}

std::vector<vtkIdType> triangles(vtkCellArray& polygons, vtkDataArray* normals) {
  std::vector<vtkIdType> corners;
  const auto cells = vtk::TakeSmartPointer(polygons.NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    cells->GetCurrentCell(count, points);
    // What is shrunk to a point has no normal.
    if (normals && !std::all_of(points, points + count, [&](vtkIdType p) { return has_normal(normals, p); })) continue;
    for (vtkIdType i = 1; i + 1 < count; ++i) corners.insert(corners.end(), {points[0], points[i], points[i + 1]});
  }
  return corners;
}

std::vector<vtkIdType> line_pieces(vtkCellArray& lines) {
  std::vector<vtkIdType> ends;
  const auto cells = vtk::TakeSmartPointer(lines.NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    cells->GetCurrentCell(count, points);
    for (vtkIdType i = 0; i + 1 < count; ++i) ends.insert(ends.end(), {points[i], points[i + 1]});
  }
  return ends;
}

std::string little_endian(std::uint32_t number) {
  std::string bytes;
  for (const int shift : {0, 8, 16, 24}) bytes += static_cast<char>(number >> shift & 0xFF);
  return bytes;
}

void pad(std::string& bytes, char filler) { bytes.resize((bytes.size() + 3) / 4 * 4, filler); }

}  // namespace

struct GltfDocument::Corners {
  std::vector<vtkIdType> points;
  std::vector<std::uint32_t> indices;

  Corners(const std::vector<vtkIdType>& corners, vtkIdType point_count) {
    constexpr auto kUnused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> place(static_cast<std::size_t>(point_count), kUnused);
    for (const auto point : corners) {
      auto& index = place[static_cast<std::size_t>(point)];
      if (index == kUnused) {
        index = static_cast<std::uint32_t>(points.size());
        points.push_back(point);
      }
      indices.push_back(index);
    }
  }
};

void GltfTrack::add(const Eigen::Vector3d& position) {
  for (int c = 0; c < 3; ++c) translations.push_back(static_cast<float>(position[c]));
}

void GltfTrack::add(const Eigen::Vector3d& position, const Eigen::Quaterniond& attitude) {
  add(position);
  Eigen::Vector4f turn = attitude.normalized().coeffs().cast<float>();
  if (!rotations.empty() && Eigen::Map<const Eigen::Vector4f>(rotations.data() + rotations.size() - 4).dot(turn) < 0) {
    turn = -turn;
  }
  rotations.insert(rotations.end(), turn.begin(), turn.end());
}

GltfDocument::GltfDocument() {
  json_["asset"] = {{"version", "2.0"}, {"generator", "netpocket"}};
  json_["extensionsUsed"] = {"KHR_materials_unlit"};
  json_["scene"] = 0;
  json_["scenes"] = {{{"nodes", Json::array()}}};
  for (const char* list : {"nodes", "meshes", "materials", "accessors", "bufferViews"}) json_[list] = Json::array();
}

std::optional<std::size_t> GltfDocument::add_mesh(const std::string& name, vtkActor& actor) {
  auto* mesh = vtkPolyDataMapper::SafeDownCast(actor.GetMapper())->GetInput();
  auto* normals = mesh->GetPointData()->GetNormals();
  auto* colors = mesh->GetPointData()->GetScalars();
  const bool solid = mesh->GetNumberOfPolys() > 0;
  const Corners corners(solid ? triangles(*mesh->GetPolys(), normals) : line_pieces(*mesh->GetLines()),
                        mesh->GetNumberOfPoints());
  if (corners.indices.empty()) return std::nullopt;
  std::vector<float> positions, directions, shades;
  for (const auto point : corners.points) {
    const double* position = mesh->GetPoint(point);
    for (int c = 0; c < 3; ++c) positions.push_back(static_cast<float>(position[c]));
    if (solid && normals) {
      const double* n = normals->GetTuple3(point);
      const double length = std::hypot(n[0], n[1], n[2]);
      for (int c = 0; c < 3; ++c) directions.push_back(static_cast<float>(n[c] / length));
    }
    if (colors) {
      for (int c = 0; c < 3; ++c) shades.push_back(linear(colors->GetComponent(point, c) / 255));
    }
  }
  Json attributes;
  attributes["POSITION"] = add_floats(positions, "VEC3", true);
  if (!directions.empty()) attributes["NORMAL"] = add_floats(directions, "VEC3", false);
  if (!shades.empty()) attributes["COLOR_0"] = add_floats(shades, "VEC3", false);
  const Json primitive = {{"attributes", attributes},
                          {"indices", add_indices(corners.indices)},
                          {"material", add_material(actor, !shades.empty(), !solid)},
                          {"mode", solid ? kTriangles : kLines}};
  json_["meshes"].push_back({{"name", name}, {"primitives", {primitive}}});
  return json_["meshes"].size() - 1;
}

void GltfDocument::add(const std::string& name, vtkActor& actor) {
  const auto mesh = add_mesh(name, actor);
  if (!mesh) return;
  actor.ComputeMatrix();
  const auto* matrix = actor.GetMatrix();
  auto columns = Json::array();
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) columns.push_back(matrix->GetElement(row, column));
  }
  json_["scenes"][0]["nodes"].push_back(add_node({{"name", name}, {"mesh", *mesh}, {"matrix", columns}}));
}

void GltfDocument::set_keys(const std::vector<float>& times) {
  keys_ = add_floats(times, "SCALAR", true, false);
  json_["animations"] = {{{"name", "capture"}, {"channels", Json::array()}, {"samplers", Json::array()}}};
}

void GltfDocument::add_moving(const GltfTrack& track, const std::vector<std::size_t>& meshes) {
  auto children = Json::array();
  for (const std::size_t mesh : meshes) children.push_back(add_node({{"mesh", mesh}}));
  json_["scenes"][0]["nodes"].push_back(add_track(track, {{"name", track.name}, {"children", children}}));
}

void GltfDocument::add_skinned(const std::string& name, const std::vector<GltfTrack>& joints,
                               const std::vector<GltfSkinnedPart>& parts) {
  auto nodes = Json::array(), primitives = Json::array();
  std::vector<float> unplaced;  // from the first key to the joint's own axes
  for (const GltfTrack& joint : joints) {
    Eigen::Isometry3f place = Eigen::Isometry3f::Identity();
    place.translation() = Eigen::Map<const Eigen::Vector3f>(joint.translations.data());
    if (!joint.rotations.empty()) place.linear() = Eigen::Quaternionf(joint.rotations.data()).toRotationMatrix();
    const Eigen::Matrix4f inverse = place.inverse().matrix();
    unplaced.insert(unplaced.end(), inverse.data(), inverse.data() + inverse.size());
    nodes.push_back(add_track(joint, {{"name", joint.name}}));
  }
  for (const GltfSkinnedPart& part : parts) primitives.push_back(skinned_primitive(part));
  const std::size_t skeleton = add_node({{"name", name + " joints"}, {"children", nodes}});
  if (!json_.contains("skins")) json_["skins"] = Json::array();
  json_["skins"].push_back({{"name", name},
                            {"inverseBindMatrices", add_floats(unplaced, "MAT4", false, false)},
                            {"joints", nodes},
                            {"skeleton", skeleton}});
  json_["meshes"].push_back({{"name", name}, {"primitives", primitives}});
  const std::size_t shown =
      add_node({{"name", name}, {"mesh", json_["meshes"].size() - 1}, {"skin", json_["skins"].size() - 1}});
  for (const std::size_t node : {skeleton, shown}) json_["scenes"][0]["nodes"].push_back(node);
}

Json GltfDocument::skinned_primitive(const GltfSkinnedPart& part) {
  Json attributes;
  attributes["POSITION"] = add_floats(part.positions, "VEC3", true);
  if (!part.normals.empty()) attributes["NORMAL"] = add_floats(part.normals, "VEC3", false);
  // Each point follows one joint alone; the format has places for four.
  std::vector<std::uint16_t> joints;
  std::vector<std::uint8_t> weights;
  for (const std::uint16_t joint : part.joints) {
    joints.insert(joints.end(), {joint, 0, 0, 0});
    weights.insert(weights.end(), {255, 0, 0, 0});
  }
  const std::size_t count = part.joints.size();
  attributes["JOINTS_0"] =
      add_accessor(add_view(joints.data(), 2 * joints.size(), kArrayBuffer), kUnsignedShort, count, "VEC4");
  attributes["WEIGHTS_0"] =
      add_accessor(add_view(weights.data(), weights.size(), kArrayBuffer), kUnsignedByte, count, "VEC4");
  json_["accessors"].back()["normalized"] = true;
  auto factor = Json::array();
  for (const double c : part.color) factor.push_back(linear(c));
  factor.push_back(1);
  Json material = {
      {"pbrMetallicRoughness", {{"baseColorFactor", factor}, {"metallicFactor", 0}, {"roughnessFactor", kRoughness}}}};
  if (part.normals.empty()) {
    material["doubleSided"] = true;
    material["extensions"] = {{"KHR_materials_unlit", Json::object()}};
  }
  return {{"attributes", attributes},
          {"indices", add_indices(part.triangles)},
          {"material", add_material(material)},
          {"mode", kTriangles}};
}

std::size_t GltfDocument::add_node(Json node) {
  json_["nodes"].push_back(std::move(node));
  return json_["nodes"].size() - 1;
}

// Whoever plays no animation sees the first key.
std::size_t GltfDocument::add_track(const GltfTrack& track, Json node) {
  node["translation"] = {track.translations[0], track.translations[1], track.translations[2]};
  if (!track.rotations.empty()) {
    node["rotation"] = std::vector<float>(track.rotations.begin(), track.rotations.begin() + 4);
  }
  const std::size_t index = add_node(std::move(node));
  animate(index, "translation", track.translations, "VEC3");
  if (!track.rotations.empty()) animate(index, "rotation", track.rotations, "VEC4");
  return index;
}

void GltfDocument::animate(std::size_t node, const char* path, const std::vector<float>& values, const char* type) {
  Json& animation = json_["animations"][0];
  animation["channels"].push_back(
      {{"sampler", animation["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
  animation["samplers"].push_back({{"input", keys_}, {"output", add_floats(values, type, false, false)}});
}

std::size_t GltfDocument::add_material(vtkActor& actor, bool colored, bool lines) {
  auto* property = actor.GetProperty();
  const double* color = property->GetColor();
  auto factor = Json::array();
  for (int c = 0; c < 3; ++c) factor.push_back(colored ? 1.0F : linear(color[c]));
  factor.push_back(property->GetOpacity());
  Json material;
  material["pbrMetallicRoughness"] = {
      {"baseColorFactor", factor}, {"metallicFactor", 0}, {"roughnessFactor", kRoughness}};
  if (property->GetOpacity() < 1) material["alphaMode"] = "BLEND";
  if (lines) material["extensions"] = {{"KHR_materials_unlit", Json::object()}};
  return add_material(std::move(material));
}

std::size_t GltfDocument::add_material(Json material) {
  json_["materials"].push_back(std::move(material));
  return json_["materials"].size() - 1;
}

std::size_t GltfDocument::add_floats(const std::vector<float>& values, const char* type, bool with_limits,
                                     bool of_points) {
  const std::size_t components = components_of(type);
  const std::size_t view = add_view(values.data(), 4 * values.size(), of_points ? kArrayBuffer : kNoTarget);
  const std::size_t index = add_accessor(view, kFloat, values.size() / components, type);
  if (!with_limits) return index;
  auto low = Json::array(), high = Json::array();
  for (std::size_t c = 0; c < components; ++c) {
    float smallest = values[c], largest = values[c];
    for (std::size_t i = c; i < values.size(); i += components) {
      smallest = std::min(smallest, values[i]);
      largest = std::max(largest, values[i]);
    }
    low.push_back(smallest);
    high.push_back(largest);
  }
  json_["accessors"][index]["min"] = low;
  json_["accessors"][index]["max"] = high;
  return index;
}

std::size_t GltfDocument::add_indices(const std::vector<std::uint32_t>& indices) {
  const std::size_t view = add_view(indices.data(), 4 * indices.size(), kElementArrayBuffer);
  return add_accessor(view, kUnsignedInt, indices.size(), "SCALAR");
}

std::size_t GltfDocument::add_accessor(std::size_t view, int component, std::size_t count, const char* type) {
  json_["accessors"].push_back({{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
  return json_["accessors"].size() - 1;
}

// Begins at a multiple of four bytes, as every component may ask for.
std::size_t GltfDocument::add_view(const void* data, std::size_t size, int target) {
  pad(buffer_, '\0');
  Json view = {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", size}};
  if (target != kNoTarget) view["target"] = target;
  json_["bufferViews"].push_back(std::move(view));
  buffer_.append(static_cast<const char*>(data), size);
  return json_["bufferViews"].size() - 1;
}

std::string GltfDocument::bytes() const {
  auto json = json_;
  json["buffers"] = {{{"byteLength", buffer_.size()}}};
  std::string text = json.dump(), data = buffer_;
  pad(text, ' ');
  pad(data, '\0');
  // A type has four characters; the last one of BIN is the zero that ends it.
  const auto chunk = [](const std::string& content, const char* type) {
    return little_endian(static_cast<std::uint32_t>(content.size())) + std::string(type, 4) + content;
  };
  const std::string chunks = chunk(text, "JSON") + chunk(data, "BIN");
  return "glTF" + little_endian(2) + little_endian(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

}  // namespace netpocket
