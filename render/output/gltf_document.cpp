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
constexpr int kFloat = 5126, kUnsignedInt = 5125, kArrayBuffer = 34962, kElementArrayBuffer = 34963;
constexpr int kLines = 1, kTriangles = 4;

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

GltfDocument::GltfDocument() {
  json_["asset"] = {{"version", "2.0"}, {"generator", "netpocket"}};
  json_["extensionsUsed"] = {"KHR_materials_unlit"};
  json_["scene"] = 0;
  json_["scenes"] = {{{"nodes", nlohmann::ordered_json::array()}}};
  for (const char* list : {"nodes", "meshes", "materials", "accessors", "bufferViews"}) {
    json_[list] = nlohmann::ordered_json::array();
  }
}

void GltfDocument::add(const std::string& name, vtkActor& actor) {
  auto* mesh = vtkPolyDataMapper::SafeDownCast(actor.GetMapper())->GetInput();
  auto* normals = mesh->GetPointData()->GetNormals();
  auto* colors = mesh->GetPointData()->GetScalars();
  const bool solid = mesh->GetNumberOfPolys() > 0;
  const Corners corners(solid ? triangles(*mesh->GetPolys(), normals) : line_pieces(*mesh->GetLines()),
                        mesh->GetNumberOfPoints());
  if (corners.indices.empty()) return;
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
  nlohmann::ordered_json attributes;
  attributes["POSITION"] = add_floats(positions, 3, true);
  if (!directions.empty()) attributes["NORMAL"] = add_floats(directions, 3, false);
  if (!shades.empty()) attributes["COLOR_0"] = add_floats(shades, 3, false);
  nlohmann::ordered_json primitive = {{"attributes", attributes},
                                      {"indices", add_indices(corners.indices)},
                                      {"material", add_material(actor, !shades.empty(), !solid)},
                                      {"mode", solid ? kTriangles : kLines}};
  nlohmann::ordered_json node = {{"name", name}, {"mesh", json_["meshes"].size()}};
  actor.ComputeMatrix();
  const auto* matrix = actor.GetMatrix();
  auto columns = nlohmann::ordered_json::array();
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) columns.push_back(matrix->GetElement(row, column));
  }
  node["matrix"] = columns;
  json_["scenes"][0]["nodes"].push_back(json_["nodes"].size());
  json_["nodes"].push_back(node);
  json_["meshes"].push_back({{"name", name}, {"primitives", {primitive}}});
}

int GltfDocument::add_material(vtkActor& actor, bool colored, bool lines) {
  auto* property = actor.GetProperty();
  const double* color = property->GetColor();
  auto factor = nlohmann::ordered_json::array();
  for (int c = 0; c < 3; ++c) factor.push_back(colored ? 1.0F : linear(color[c]));
  factor.push_back(property->GetOpacity());
  nlohmann::ordered_json material;
  material["pbrMetallicRoughness"] = {{"baseColorFactor", factor}, {"metallicFactor", 0}, {"roughnessFactor", 0.6}};
  if (property->GetOpacity() < 1) material["alphaMode"] = "BLEND";
  if (lines) material["extensions"] = {{"KHR_materials_unlit", nlohmann::ordered_json::object()}};
  json_["materials"].push_back(material);
  return static_cast<int>(json_["materials"].size()) - 1;
}

int GltfDocument::add_floats(const std::vector<float>& values, int components, bool with_limits) {
  const auto count = values.size() / static_cast<std::size_t>(components);
  nlohmann::ordered_json accessor = {{"bufferView", add_view(values.data(), 4 * values.size(), kArrayBuffer)},
                                     {"componentType", kFloat},
                                     {"count", count},
                                     {"type", "VEC3"}};
  if (with_limits) {
    auto low = nlohmann::ordered_json::array(), high = low;
    for (int c = 0; c < components; ++c) {
      float smallest = values[c], largest = values[c];
      for (std::size_t i = static_cast<std::size_t>(c); i < values.size(); i += static_cast<std::size_t>(components)) {
        smallest = std::min(smallest, values[i]);
        largest = std::max(largest, values[i]);
      }
      low.push_back(smallest);
      high.push_back(largest);
    }
    accessor["min"] = low;
    accessor["max"] = high;
  }
  json_["accessors"].push_back(accessor);
  return static_cast<int>(json_["accessors"].size()) - 1;
}

int GltfDocument::add_indices(const std::vector<std::uint32_t>& indices) {
  json_["accessors"].push_back({{"bufferView", add_view(indices.data(), 4 * indices.size(), kElementArrayBuffer)},
                                {"componentType", kUnsignedInt},
                                {"count", indices.size()},
                                {"type", "SCALAR"}});
  return static_cast<int>(json_["accessors"].size()) - 1;
}

int GltfDocument::add_view(const void* data, std::size_t size, int target) {
  json_["bufferViews"].push_back(
      {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", size}, {"target", target}});
  buffer_.append(static_cast<const char*>(data), size);
  return static_cast<int>(json_["bufferViews"].size()) - 1;
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
