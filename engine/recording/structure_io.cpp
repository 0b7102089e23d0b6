#include "engine/recording/structure_io.h"

#include <cmath>

#include "engine/recording/hdf5_output.h"

namespace netpocket {

namespace {

constexpr char kGroup[] = "/structure";

// A shape is stored as its kind and three numbers.
struct StoredShape {
  std::uint8_t kind;
  Eigen::Vector3d size;
};

StoredShape store(const Shape& shape) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return {0, {sphere->radius, 0, 0}};
  if (const auto* box = std::get_if<Box>(&shape)) return {1, box->size};
  const auto& cylinder = std::get<Cylinder>(shape);
  return {2, {cylinder.radius, cylinder.length, 0}};
}

Shape restore(const StoredShape& stored) {
  switch (stored.kind) {
    case 0:
      return Sphere{stored.size.x()};
    case 1:
      return Box{stored.size};
    case 2:
      return Cylinder{stored.size.x(), stored.size.y()};
  }
  throw Hdf5Error("a body has an unknown shape");
}

void write_elements(hid_t group, const std::vector<StructureElement>& elements, ChunkCodec& codec) {
  std::vector<std::int32_t> nodes, gradients, threads, ropes;
  std::vector<std::uint8_t> kinds;
  std::vector<double> lengths, radii;
  for (const StructureElement& e : elements) {
    nodes.insert(nodes.end(), {e.node[0], e.node[1]});
    gradients.insert(gradients.end(), {e.gradient[0], e.gradient[1]});
    kinds.push_back(static_cast<std::uint8_t>(e.kind));
    threads.push_back(e.thread);
    ropes.push_back(e.rope);
    lengths.push_back(e.length);
    radii.push_back(e.radius);
  }
  write_array(group, {"element_nodes", "", "columns of frames/position of both ends", {2}}, nodes, codec);
  write_array(group, {"element_gradients", "", "columns of frames/gradient of both ends", {2}}, gradients, codec);
  write_array(group, {"element_kind", "", "0 net, 1 rod, 2 closing rope, 3 cable"}, kinds, codec);
  write_array(group, {"element_thread", "", "row of thread_names"}, threads, codec);
  write_array(group, {"element_rope", "", "column of frames/rope_element_length, -1 for fixed length"}, ropes, codec);
  write_array(group, {"element_length", "m", "material length, at the start for variable length"}, lengths, codec);
  write_array(group, {"element_radius", "m", "outer radius of the cord or rod"}, radii, codec);
}

void write_bodies(hid_t group, const std::vector<StructureBody>& bodies, ChunkCodec& codec) {
  std::vector<std::string> names;
  std::vector<std::uint8_t> roles, shapes;
  std::vector<double> sizes, masses;
  for (const StructureBody& body : bodies) {
    const StoredShape shape = store(body.shape);
    names.push_back(body.name);
    roles.push_back(static_cast<std::uint8_t>(body.role));
    shapes.push_back(shape.kind);
    sizes.insert(sizes.end(), shape.size.begin(), shape.size.end());
    masses.push_back(body.mass);
  }
  write_texts(group, {"body_names", "", "names of the bodies"}, names, codec);
  write_array(group, {"body_role", "", "0 spacecraft, 1 target, 2 other"}, roles, codec);
  write_array(group, {"body_shape", "", "0 sphere, 1 box, 2 cylinder along y"}, shapes, codec);
  write_array(group, {"body_size", "m", "sphere: radius; box: edges; cylinder: radius, length", {3}}, sizes, codec);
  write_array(group, {"body_mass", "kg", "mass"}, masses, codec);
}

std::string at(const char* name) { return std::string(kGroup) + "/" + name; }

template <typename T>
std::vector<T> read_rows(const InputFile& file, const char* name, std::size_t rows,
                         const std::vector<hsize_t>& shape = {}) {
  auto values = read_array<T>(file, at(name), shape);
  if (values.size() != rows * (shape.empty() ? 1 : shape[0])) throw Hdf5Error(at(name) + " has the wrong length");
  return values;
}

std::vector<StructureElement> read_elements(const InputFile& file) {
  const auto nodes = read_array<std::int32_t>(file, at("element_nodes"), {2});
  const std::size_t count = nodes.size() / 2;
  const auto gradients = read_rows<std::int32_t>(file, "element_gradients", count, {2});
  const auto kinds = read_rows<std::uint8_t>(file, "element_kind", count);
  const auto threads = read_rows<std::int32_t>(file, "element_thread", count);
  const auto ropes = read_rows<std::int32_t>(file, "element_rope", count);
  const auto lengths = read_rows<double>(file, "element_length", count);
  const auto radii = read_rows<double>(file, "element_radius", count);
  std::vector<StructureElement> elements(count);
  for (std::size_t i = 0; i < count; ++i) {
    elements[i] = {{nodes[2 * i], nodes[2 * i + 1]},
                   {gradients[2 * i], gradients[2 * i + 1]},
                   static_cast<ElementKind>(kinds[i]),
                   threads[i],
                   ropes[i],
                   lengths[i],
                   radii[i]};
  }
  return elements;
}

std::vector<StructureBody> read_bodies(const InputFile& file) {
  const auto names = read_texts(file, at("body_names"));
  const auto roles = read_rows<std::uint8_t>(file, "body_role", names.size());
  const auto shapes = read_rows<std::uint8_t>(file, "body_shape", names.size());
  const auto sizes = read_rows<double>(file, "body_size", names.size(), {3});
  const auto masses = read_rows<double>(file, "body_mass", names.size());
  std::vector<StructureBody> bodies(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const StoredShape shape = {shapes[i], Eigen::Vector3d(sizes[3 * i], sizes[3 * i + 1], sizes[3 * i + 2])};
    bodies[i] = {names[i], static_cast<BodyRole>(roles[i]), restore(shape), masses[i]};
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
  if (e.kind > ElementKind::cable) return "has an unknown kind";
  if (!is_index(e.thread, structure.threads.size())) return "names a thread that does not exist";
  if (e.rope != -1 && !is_index(e.rope, ropes)) return "names a rope that does not exist";
  if (!is_size(e.length) || !is_size(e.radius)) return "has an impossible length or radius";
  return "";
}

bool has_valid_size(const StructureBody& body) {
  const Eigen::Vector3d size = store(body.shape).size;
  return size.allFinite() && size.minCoeff() >= 0 && is_size(body.mass);
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
  for (const auto* rods : {&structure.rod_roots, &structure.rod_kinks, &structure.rod_tips}) {
    for (const std::int32_t node : *rods) {
      if (!is_index(node, static_cast<std::size_t>(structure.node_count)))
        return "a rod names a node that does not exist";
    }
  }
  return "";
}

void write_structure(hid_t file, const Structure& structure, ChunkCodec& codec) {
  const Handle group = create_group(file, kGroup);
  write_attribute(group.get(), "node_count", std::int64_t{structure.node_count});
  write_attribute(group.get(), "gradient_count", std::int64_t{structure.gradient_count});
  write_attribute(group.get(), "rope_count", std::int64_t{structure.rope_count});
  write_elements(group.get(), structure.elements, codec);
  write_bodies(group.get(), structure.bodies, codec);
  write_texts(group.get(), {"thread_names", "", "names of rods, cords and ropes"}, structure.threads, codec);
  write_array(group.get(), {"rod_roots", "", "node of each rod's clamped end"}, structure.rod_roots, codec);
  write_array(group.get(), {"rod_kinks", "", "node of each rod's kink"}, structure.rod_kinks, codec);
  write_array(group.get(), {"rod_tips", "", "node of each rod's tip"}, structure.rod_tips, codec);
}

Structure read_structure(const InputFile& file) {
  Structure structure;
  structure.node_count = file.read_count_attribute(kGroup, "node_count");
  structure.gradient_count = file.read_count_attribute(kGroup, "gradient_count");
  structure.rope_count = file.read_count_attribute(kGroup, "rope_count");
  structure.elements = read_elements(file);
  structure.threads = read_texts(file, at("thread_names"));
  structure.bodies = read_bodies(file);
  structure.rod_roots = read_array<std::int32_t>(file, at("rod_roots"));
  structure.rod_kinks = read_array<std::int32_t>(file, at("rod_kinks"));
  structure.rod_tips = read_array<std::int32_t>(file, at("rod_tips"));
  const std::string fault = find_fault(structure);
  if (!fault.empty()) throw Hdf5Error(fault);
  return structure;
}

}  // namespace netpocket
