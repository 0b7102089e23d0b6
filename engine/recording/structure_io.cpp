#include "engine/recording/structure_io.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <sstream>
#include <utility>

#include "engine/bodies/triangle_mesh.h"
#include "engine/recording/hdf5_output.h"
#include "engine/recording/layout.h"
#include "engine/state/pocket_groups.h"

namespace netpocket {

namespace {

constexpr char kStructureGroup[] = "/structure";

enum ShapeKind : std::uint8_t { kSphere, kBox, kCylinder, kSatellite, kMesh };

// A shape as it is stored: kind, sizes and, for a mesh, the row of the mesh.
struct StoredShape {
  std::uint8_t kind;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  Eigen::Vector3d detail = Eigen::Vector3d::Zero();
  std::int32_t mesh = -1;
};

using MeshPointer = std::shared_ptr<const TriangleMesh>;

StoredShape store(const Shape& shape) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return {kSphere, {sphere->radius, 0, 0}};
  if (const auto* box = std::get_if<Box>(&shape)) return {kBox, box->size};
  if (const auto* cylinder = std::get_if<Cylinder>(&shape)) return {kCylinder, {cylinder->radius, cylinder->length, 0}};
  if (const auto* satellite = std::get_if<Satellite>(&shape)) {
    const Satellite::Dimensions& d = satellite->dimensions();
    return {kSatellite, d.bus, {d.span, d.panel_width, d.dish_diameter}};
  }
  return {kMesh};
}

Shape restore(const StoredShape& stored, const std::vector<MeshPointer>& meshes) {
  switch (stored.kind) {
    case kSphere:
      return Sphere{stored.size.x()};
    case kBox:
      return Box{stored.size};
    case kCylinder:
      return Cylinder{stored.size.x(), stored.size.y()};
    case kSatellite:
      return Satellite({stored.size, stored.detail.x(), stored.detail.y(), stored.detail.z()});
    case kMesh:
      if (stored.mesh < 0 || stored.mesh >= static_cast<std::int32_t>(meshes.size()))
        throw Hdf5Error("a body names a mesh that does not exist");
      return MeshShape{meshes[stored.mesh]};
  }
  throw Hdf5Error("a body has an unknown shape");
}

// Stores each mesh once, however many bodies have it.
class MeshRows {
 public:
  std::int32_t row(const Shape& shape) {
    const auto* mesh = std::get_if<MeshShape>(&shape);
    if (!mesh) return -1;
    const auto found = std::find(meshes_.begin(), meshes_.end(), mesh->mesh);
    if (found != meshes_.end()) return static_cast<std::int32_t>(found - meshes_.begin());
    meshes_.push_back(mesh->mesh);
    return static_cast<std::int32_t>(meshes_.size() - 1);
  }
  const std::vector<MeshPointer>& meshes() const { return meshes_; }

 private:
  std::vector<MeshPointer> meshes_;
};

void write_meshes(hid_t group, const std::vector<MeshPointer>& meshes, ChunkCodec& codec) {
  if (meshes.empty()) return;
  std::vector<std::int32_t> sizes, triangles;
  std::vector<double> vertices;
  for (const MeshPointer& mesh : meshes) {
    sizes.push_back(static_cast<std::int32_t>(mesh->vertices().size()));
    sizes.push_back(static_cast<std::int32_t>(mesh->triangles().size()));
    for (const Eigen::Vector3d& v : mesh->vertices()) vertices.insert(vertices.end(), v.begin(), v.end());
    for (const Triangle& t : mesh->triangles()) triangles.insert(triangles.end(), t.begin(), t.end());
  }
  write_array(group, {"mesh_size", "", "vertices and triangles of each mesh", {2}}, sizes, codec);
  write_array(group, {"mesh_vertices", "m", "of all meshes, body axes", {3}}, vertices, codec);
  write_array(group, {"mesh_triangles", "", "corners, counted from the mesh's first vertex", {3}}, triangles, codec);
}

void write_elements(hid_t group, const std::vector<StructureElement>& elements, ChunkCodec& codec) {
  std::vector<std::int32_t> nodes, gradients, groups, threads, ropes;
  std::vector<double> lengths, radii;
  for (const StructureElement& e : elements) {
    nodes.insert(nodes.end(), {e.node[0], e.node[1]});
    gradients.insert(gradients.end(), {e.gradient[0], e.gradient[1]});
    groups.push_back(e.group);
    threads.push_back(e.thread);
    ropes.push_back(e.rope);
    lengths.push_back(e.length);
    radii.push_back(e.radius);
  }
  write_array(group, {"element_nodes", "", "columns of frames/position of both ends", {2}}, nodes, codec);
  write_array(group, {"element_gradients", "", "columns of frames/gradient of both ends", {2}}, gradients, codec);
  write_array(group, {"element_group", "", "row of group_names"}, groups, codec);
  write_array(group, {"element_thread", "", "row of thread_names"}, threads, codec);
  write_array(group, {"element_rope", "", "column of frames/rope_element_length, -1 for fixed length"}, ropes, codec);
  write_array(group, {"element_length", "m", "material length, at the start for variable length"}, lengths, codec);
  write_array(group, {"element_radius", "m", "outer radius of the cord or rod"}, radii, codec);
}

void write_bodies(hid_t group, const std::vector<StructureBody>& bodies, ChunkCodec& codec) {
  std::vector<std::string> names;
  std::vector<std::uint8_t> roles, shapes;
  std::vector<double> sizes, details, masses;
  std::vector<std::int32_t> rows;
  MeshRows meshes;
  for (const StructureBody& body : bodies) {
    const StoredShape shape = store(body.shape);
    rows.push_back(meshes.row(body.shape));
    names.push_back(body.name);
    roles.push_back(static_cast<std::uint8_t>(body.role));
    shapes.push_back(shape.kind);
    sizes.insert(sizes.end(), shape.size.begin(), shape.size.end());
    details.insert(details.end(), shape.detail.begin(), shape.detail.end());
    masses.push_back(body.mass);
  }
  write_texts(group, {"body_names", "", "names of the bodies"}, names, codec);
  write_array(group, {"body_role", "", "0 spacecraft, 1 target, 2 other"}, roles, codec);
  write_array(group, {"body_shape", "", "0 sphere, 1 box, 2 cylinder along y, 3 satellite, 4 mesh"}, shapes, codec);
  write_array(group, {"body_size", "m", "sphere: radius; box: edges; cylinder: radius, length; satellite: bus", {3}},
              sizes, codec);
  write_array(group, {"body_detail", "m", "satellite: span, panel width, dish diameter", {3}}, details, codec);
  write_array(group, {"body_mesh", "", "row of mesh_size, -1 for other shapes"}, rows, codec);
  write_array(group, {"body_mass", "kg", "mass"}, masses, codec);
  write_meshes(group, meshes.meshes(), codec);
}

void write_element_groups(hid_t group, const std::vector<ElementGroup>& groups, ChunkCodec& codec) {
  std::vector<std::string> names, members;
  std::vector<std::uint8_t> looks;
  for (const ElementGroup& g : groups) {
    names.push_back(g.name);
    members.push_back(g.member);
    looks.push_back(static_cast<std::uint8_t>(g.look));
  }
  write_texts(group, {"group_names", "", "of all elements of each group"}, names, codec);
  write_texts(group, {"group_members", "", "of one element of each group, with its article"}, members, codec);
  write_array(group, {"group_look", "", "0 thin line, 1 tube, 2 broad line"}, looks, codec);
}

void write_node_groups(hid_t group, const std::vector<NodeGroup>& groups, ChunkCodec& codec) {
  std::vector<std::string> names;
  std::vector<std::uint8_t> looks;
  std::vector<std::int32_t> sizes, nodes;
  for (const NodeGroup& g : groups) {
    names.push_back(g.name);
    looks.push_back(static_cast<std::uint8_t>(g.look));
    sizes.push_back(static_cast<std::int32_t>(g.nodes.size()));
    nodes.insert(nodes.end(), g.nodes.begin(), g.nodes.end());
  }
  write_texts(group, {"node_group_names", "", "of each group of nodes"}, names, codec);
  write_array(group, {"node_group_look", "", "0 nothing, 1 joint, 2 reel, 3 adapter"}, looks, codec);
  write_array(group, {"node_group_size", "", "nodes of each group"}, sizes, codec);
  write_array(group, {"node_group_nodes", "", "nodes of all groups, one after the other"}, nodes, codec);
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
  return text;
}

std::vector<std::string> split(const std::string& text) {
  std::istringstream words(text);
  return {std::istream_iterator<std::string>(words), {}};
}

// Texts of the loops, with their datasets.
struct LoopText {
  const char* dataset;
  const char* help;
  std::string ControlLoopInfo::*text;
};

constexpr LoopText kLoopTexts[] = {
    {"loop_names", "of each control loop", &ControlLoopInfo::name},
    {"loop_acts_on", "what each loop acts on", &ControlLoopInfo::acts_on},
    {"loop_quantity", "what each loop controls", &ControlLoopInfo::quantity},
    {"loop_table", "table of the scenario with each loop's parameters", &ControlLoopInfo::table}};

std::string loop_dataset(const LoopQuantity& quantity) { return std::string("loop_") + quantity.name; }

void write_loops(hid_t group, const std::vector<ControlLoopInfo>& loops, ChunkCodec& codec) {
  if (loops.empty()) return;
  const auto column = [&](const auto& text_of) {
    std::vector<std::string> texts;
    for (const ControlLoopInfo& loop : loops) texts.push_back(text_of(loop));
    return texts;
  };
  for (const LoopText& text : kLoopTexts) {
    write_texts(group, {text.dataset, "", text.help}, column([&](const auto& loop) { return loop.*text.text; }), codec);
  }
  for (const LoopQuantity& quantity : kLoopQuantities) {
    const std::string name = loop_dataset(quantity), help = std::string("channels of each loop: ") + quantity.words;
    write_texts(group, {name.c_str(), "", help.c_str()},
                column([&](const auto& loop) { return joined(loop.*quantity.channels); }), codec);
  }
}

std::string at(const char* name) { return std::string(kStructureGroup) + "/" + name; }

template <typename T>
std::vector<T> read_rows(const InputFile& file, const char* name, std::size_t rows,
                         const std::vector<hsize_t>& shape = {}) {
  auto values = read_array<T>(file, at(name), shape);
  if (values.size() != rows * (shape.empty() ? 1 : shape[0])) throw Hdf5Error(at(name) + " has the wrong length");
  return values;
}

// Version 2 stores one of four kinds for each element.
std::vector<std::int32_t> read_element_groups(const InputFile& file, std::size_t count, std::int32_t version) {
  if (version > layout::kVersionWithKinds) return read_rows<std::int32_t>(file, "element_group", count);
  const auto kinds = read_rows<std::uint8_t>(file, "element_kind", count);
  return {kinds.begin(), kinds.end()};
}

std::vector<StructureElement> read_elements(const InputFile& file, std::int32_t version) {
  const auto nodes = read_array<std::int32_t>(file, at("element_nodes"), {2});
  const std::size_t count = nodes.size() / 2;
  const auto gradients = read_rows<std::int32_t>(file, "element_gradients", count, {2});
  const auto groups = read_element_groups(file, count, version);
  const auto threads = read_rows<std::int32_t>(file, "element_thread", count);
  const auto ropes = read_rows<std::int32_t>(file, "element_rope", count);
  const auto lengths = read_rows<double>(file, "element_length", count);
  const auto radii = read_rows<double>(file, "element_radius", count);
  std::vector<StructureElement> elements(count);
  for (std::size_t i = 0; i < count; ++i) {
    elements[i] = {{nodes[2 * i], nodes[2 * i + 1]},
                   {gradients[2 * i], gradients[2 * i + 1]},
                   groups[i],
                   threads[i],
                   ropes[i],
                   lengths[i],
                   radii[i]};
  }
  return elements;
}

std::vector<ElementGroup> read_element_groups(const InputFile& file, std::int32_t version) {
  if (version <= layout::kVersionWithKinds) {
    std::vector<ElementGroup> groups = pocket_groups();
    groups.push_back({"cables", "a cable", CableLook::cord});
    return groups;
  }
  const auto names = read_texts(file, at("group_names"));
  const auto members = read_texts(file, at("group_members"));
  const auto looks = read_rows<std::uint8_t>(file, "group_look", names.size());
  if (members.size() != names.size()) throw Hdf5Error(at("group_members") + " has the wrong length");
  std::vector<ElementGroup> groups;
  for (std::size_t i = 0; i < names.size(); ++i) {
    groups.push_back({names[i], members[i], static_cast<CableLook>(looks[i])});
  }
  return groups;
}

std::vector<NodeGroup> read_node_groups(const InputFile& file, std::int32_t version) {
  if (version <= layout::kVersionWithKinds) {
    return {{kRodRoots, NodeLook::adapter, read_array<std::int32_t>(file, at("rod_roots"))},
            {kRodKinks, NodeLook::joint, read_array<std::int32_t>(file, at("rod_kinks"))},
            {kRodTips, NodeLook::reel, read_array<std::int32_t>(file, at("rod_tips"))}};
  }
  const auto names = read_texts(file, at("node_group_names"));
  const auto looks = read_rows<std::uint8_t>(file, "node_group_look", names.size());
  const auto sizes = read_rows<std::int32_t>(file, "node_group_size", names.size());
  const auto nodes = read_array<std::int32_t>(file, at("node_group_nodes"));
  std::vector<NodeGroup> groups;
  std::size_t first = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (sizes[i] < 0 || nodes.size() - first < static_cast<std::size_t>(sizes[i])) {
      throw Hdf5Error("a group of nodes is larger than what is stored of it");
    }
    const auto begin = nodes.begin() + static_cast<std::ptrdiff_t>(first);
    groups.push_back({names[i], static_cast<NodeLook>(looks[i]), {begin, begin + sizes[i]}});
    first += static_cast<std::size_t>(sizes[i]);
  }
  return groups;
}

std::vector<MeshPointer> read_meshes(const InputFile& file) {
  if (!file.has(at("mesh_size"))) return {};
  const auto sizes = read_array<std::int32_t>(file, at("mesh_size"), {2});
  const auto vertices = read_array<double>(file, at("mesh_vertices"), {3});
  const auto corners = read_array<std::int32_t>(file, at("mesh_triangles"), {3});
  std::vector<MeshPointer> meshes;
  std::size_t vertex = 0, triangle = 0;
  for (std::size_t i = 0; i < sizes.size(); i += 2) {
    if (sizes[i] < 0 || sizes[i + 1] < 0 || vertices.size() / 3 - vertex < static_cast<std::size_t>(sizes[i]) ||
        corners.size() / 3 - triangle < static_cast<std::size_t>(sizes[i + 1])) {
      throw Hdf5Error("a mesh is larger than what is stored of it");
    }
    MeshData data;
    for (std::int32_t k = 0; k < sizes[i]; ++k, ++vertex)
      data.vertices.emplace_back(vertices[3 * vertex], vertices[3 * vertex + 1], vertices[3 * vertex + 2]);
    for (std::int32_t k = 0; k < sizes[i + 1]; ++k, ++triangle)
      data.triangles.push_back({corners[3 * triangle], corners[3 * triangle + 1], corners[3 * triangle + 2]});
    auto mesh = TriangleMesh::restore(std::move(data));
    if (const auto* problem = std::get_if<std::string>(&mesh)) throw Hdf5Error("a mesh " + *problem);
    meshes.push_back(std::get<MeshPointer>(std::move(mesh)));
  }
  return meshes;
}

// Recordings from before loops were recorded have none.
std::vector<ControlLoopInfo> read_loops(const InputFile& file) {
  if (!file.has(at("loop_names"))) return {};
  std::vector<ControlLoopInfo> loops(read_texts(file, at("loop_names")).size());
  const auto column = [&](const char* name) {
    auto texts = read_texts(file, at(name));
    if (texts.size() != loops.size()) throw Hdf5Error(at(name) + " has the wrong length");
    return texts;
  };
  for (const LoopText& text : kLoopTexts) {
    const auto texts = column(text.dataset);
    for (std::size_t i = 0; i < loops.size(); ++i) loops[i].*text.text = texts[i];
  }
  for (const LoopQuantity& quantity : kLoopQuantities) {
    const auto texts = column(loop_dataset(quantity).c_str());
    for (std::size_t i = 0; i < loops.size(); ++i) loops[i].*quantity.channels = split(texts[i]);
  }
  return loops;
}

std::vector<StructureBody> read_bodies(const InputFile& file) {
  const auto names = read_texts(file, at("body_names"));
  const std::size_t count = names.size();
  const auto roles = read_rows<std::uint8_t>(file, "body_role", count);
  const auto shapes = read_rows<std::uint8_t>(file, "body_shape", count);
  const auto sizes = read_rows<double>(file, "body_size", count, {3});
  const auto masses = read_rows<double>(file, "body_mass", count);
  // Files made before satellites and meshes existed have neither table.
  const bool has_details = file.has(at("body_detail"));
  const auto details =
      has_details ? read_rows<double>(file, "body_detail", count, {3}) : std::vector<double>(3 * count);
  const auto rows = file.has(at("body_mesh")) ? read_rows<std::int32_t>(file, "body_mesh", count)
                                              : std::vector<std::int32_t>(count, -1);
  const std::vector<MeshPointer> meshes = read_meshes(file);
  std::vector<StructureBody> bodies(count);
  for (std::size_t i = 0; i < count; ++i) {
    const StoredShape shape = {shapes[i], Eigen::Vector3d(sizes[3 * i], sizes[3 * i + 1], sizes[3 * i + 2]),
                               Eigen::Vector3d(details[3 * i], details[3 * i + 1], details[3 * i + 2]), rows[i]};
    bodies[i] = {names[i], static_cast<BodyRole>(roles[i]), restore(shape, meshes), masses[i]};
  }
  return bodies;
}

bool is_index(std::int64_t index, std::size_t count) { return index >= 0 && index < static_cast<std::int64_t>(count); }
bool is_size(double value) { return std::isfinite(value) && value >= 0; }

std::string find_element_fault(const StructureElement& e, const Structure& structure) {
  const auto nodes = static_cast<std::size_t>(structure.node_count);
  const auto gradients = static_cast<std::size_t>(structure.gradient_count);
  const auto ropes = static_cast<std::size_t>(structure.rope_count);
  if (!is_index(e.node[0], nodes) || !is_index(e.node[1], nodes)) return "names a node that does not exist";
  if (!is_index(e.gradient[0], gradients) || !is_index(e.gradient[1], gradients)) {
    return "names a gradient that does not exist";
  }
  if (!is_index(e.group, structure.element_groups.size())) return "names a group that does not exist";
  if (!is_index(e.thread, structure.threads.size())) return "names a thread that does not exist";
  if (e.rope != -1 && !is_index(e.rope, ropes)) return "names a rope that does not exist";
  if (!is_size(e.length) || !is_size(e.radius)) return "has an impossible length or radius";
  return "";
}

bool has_valid_size(const StructureBody& body) {
  const StoredShape shape = store(body.shape);
  for (const Eigen::Vector3d& size : {shape.size, shape.detail}) {
    if (!size.allFinite() || size.minCoeff() < 0) return false;
  }
  const bool folded = shape.kind == kSatellite && shape.detail.x() <= shape.size.x();
  return !folded && is_size(body.mass);
}

}  // namespace

std::string find_fault(const Structure& structure) {
  if (structure.node_count < 0 || structure.gradient_count < 0 || structure.rope_count < 0)
    return "a count is negative";
  for (std::size_t i = 0; i < structure.elements.size(); ++i) {
    const std::string fault = find_element_fault(structure.elements[i], structure);
    if (!fault.empty()) return "element " + std::to_string(i) + " " + fault;
  }
  for (const StructureBody& body : structure.bodies) {
    if (body.role > BodyRole::other) return "a body has an unknown role";
    if (!has_valid_size(body)) return "a body has an impossible size or mass";
  }
  for (const ElementGroup& group : structure.element_groups) {
    if (group.look > CableLook::rope) return "the group of " + group.name + " has an unknown look";
  }
  for (const NodeGroup& group : structure.node_groups) {
    if (group.look > NodeLook::rope) return "the group of " + group.name + " has an unknown look";
    for (const std::int32_t node : group.nodes) {
      if (!is_index(node, static_cast<std::size_t>(structure.node_count)))
        return "the group of " + group.name + " names a node that does not exist";
    }
  }
  return "";
}

void write_structure(hid_t file, const Structure& structure, ChunkCodec& codec) {
  const Handle group = create_group(file, kStructureGroup);
  write_attribute(group.get(), "node_count", std::int64_t{structure.node_count});
  write_attribute(group.get(), "gradient_count", std::int64_t{structure.gradient_count});
  write_attribute(group.get(), "rope_count", std::int64_t{structure.rope_count});
  write_elements(group.get(), structure.elements, codec);
  write_bodies(group.get(), structure.bodies, codec);
  write_texts(group.get(), {"thread_names", "", "names of rods, cords and ropes"}, structure.threads, codec);
  write_element_groups(group.get(), structure.element_groups, codec);
  write_node_groups(group.get(), structure.node_groups, codec);
  write_loops(group.get(), structure.loops, codec);
}

Structure read_structure(const InputFile& file, std::int32_t version) {
  Structure structure;
  structure.node_count = file.read_count_attribute(kStructureGroup, "node_count");
  structure.gradient_count = file.read_count_attribute(kStructureGroup, "gradient_count");
  structure.rope_count = file.read_count_attribute(kStructureGroup, "rope_count");
  structure.elements = read_elements(file, version);
  structure.element_groups = read_element_groups(file, version);
  structure.node_groups = read_node_groups(file, version);
  structure.threads = read_texts(file, at("thread_names"));
  structure.bodies = read_bodies(file);
  structure.loops = read_loops(file);
  const std::string fault = find_fault(structure);
  if (!fault.empty()) throw Hdf5Error(fault);
  return structure;
}

}  // namespace netpocket
