#include "engine/model/model.h"

#include <numeric>

namespace netpocket {

std::int32_t Model::add_node(const Eigen::Vector3d& position) {
  nodes.push_back({.position = position});
  return static_cast<std::int32_t>(nodes.size()) - 1;
}

std::int32_t Model::add_gradient(std::int32_t node, const Eigen::Vector3d& value) {
  gradients.push_back({.node = node, .value = value});
  return static_cast<std::int32_t>(gradients.size()) - 1;
}

std::int32_t Model::add_material(const CableMaterial& material) {
  materials.push_back(material);
  return static_cast<std::int32_t>(materials.size()) - 1;
}

std::int32_t Model::add_element(const ModelElement& element) {
  elements.push_back(element);
  return static_cast<std::int32_t>(elements.size()) - 1;
}

void Model::pair(std::int32_t first, std::int32_t second) {
  elements[first].strain_partner = second;
  elements[second].strain_partner = first;
}

std::int32_t Model::add_thread(const std::string& name) {
  threads.push_back(name);
  return static_cast<std::int32_t>(threads.size()) - 1;
}

std::int32_t Model::add_body(const ModelBody& body) {
  bodies.push_back(body);
  return static_cast<std::int32_t>(bodies.size()) - 1;
}

std::vector<std::int32_t> Model::add_straight_cable(std::int32_t begin, std::int32_t end, int count,
                                                    std::int32_t material, std::int32_t group, std::int32_t thread) {
  const Eigen::Vector3d from = nodes[begin].position, to = nodes[end].position;
  const double length = (to - from).norm();
  const Eigen::Vector3d direction = (to - from) / length;
  std::vector<std::int32_t> chain;
  std::int32_t node = begin;
  std::int32_t gradient = add_gradient(begin, direction);
  for (int i = 1; i <= count; ++i) {
    const std::int32_t next = i == count ? end : add_node(from + (to - from) * (static_cast<double>(i) / count));
    const std::int32_t next_gradient = add_gradient(next, direction);
    chain.push_back(add_element({node, gradient, next, next_gradient, length / count, material, group, thread}));
    node = next;
    gradient = next_gradient;
  }
  return chain;
}

void Model::clamp_to_body(std::int32_t node, std::int32_t gradient, std::int32_t body) {
  nodes[node].support = Support::body;
  nodes[node].body = body;
  gradients[gradient].support = Support::body;
  gradients[gradient].body = body;
}

Structure Model::structure() const {
  Structure result;
  result.node_count = static_cast<std::int32_t>(nodes.size());
  result.gradient_count = static_cast<std::int32_t>(gradients.size());
  result.element_groups = element_groups;
  result.node_groups = node_groups;
  result.threads = threads;
  result.rope_count = static_cast<std::int32_t>(ropes.size());
  result.elements.reserve(elements.size());
  for (const ModelElement& element : elements) {
    result.elements.push_back({.node = {element.node1, element.node2},
                               .gradient = {element.gradient1, element.gradient2},
                               .group = element.group,
                               .thread = element.thread,
                               .length = element.length,
                               .radius = materials[element.material].radius});
  }
  for (std::size_t rope = 0; rope < ropes.size(); ++rope) {
    for (const std::int32_t element : ropes[rope].elements) {
      result.elements[element].rope = static_cast<std::int32_t>(rope);
    }
  }
  for (const ModelBody& body : bodies) result.bodies.push_back({body.name, body.role, body.shape, body.mass});
  return result;
}

double Model::rope_length(std::size_t rope) const {
  if (rope < ropes.size()) return ropes[rope].motion.length;
  const std::vector<double>& lengths = ring_ropes.at(rope - ropes.size()).lengths;
  return std::accumulate(lengths.begin(), lengths.end(), 0.0);
}

double Model::cable_mass() const {
  double mass = 0;
  for (const ModelElement& element : elements) {
    mass += materials[element.material].section.mass_per_length * element.length;
  }
  for (const ModelNode& node : nodes) mass += node.point_mass;
  return mass;
}

}  // namespace netpocket
