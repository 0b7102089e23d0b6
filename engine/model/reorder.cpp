#include "engine/model/reorder.h"

#include <utility>

namespace netpocket {
namespace {

void renumber(std::int32_t& index, std::span<const std::int32_t> new_index) {
  if (index >= 0) index = new_index[static_cast<std::size_t>(index)];
}

std::vector<std::int32_t> inverse(std::span<const std::int32_t> order) {
  std::vector<std::int32_t> result(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    result[static_cast<std::size_t>(order[i])] = static_cast<std::int32_t>(i);
  }
  return result;
}

template <typename Item>
void permute(std::vector<Item>& items, std::span<const std::int32_t> order) {
  std::vector<Item> result;
  result.reserve(items.size());
  for (const std::int32_t old : order) result.push_back(std::move(items[static_cast<std::size_t>(old)]));
  items = std::move(result);
}

}  // namespace

void renumber(std::span<std::int32_t> indices, std::span<const std::int32_t> new_index) {
  for (std::int32_t& index : indices) renumber(index, new_index);
}

NewIndices reorder(Model& model, const ModelOrder& order) {
  const NewIndices to{inverse(order.nodes), inverse(order.gradients), inverse(order.elements)};
  permute(model.nodes, order.nodes);
  permute(model.gradients, order.gradients);
  permute(model.elements, order.elements);
  for (ModelGradient& gradient : model.gradients) renumber(gradient.node, to.nodes);
  for (ModelElement& element : model.elements) {
    renumber(element.node1, to.nodes);
    renumber(element.node2, to.nodes);
    renumber(element.gradient1, to.gradients);
    renumber(element.gradient2, to.gradients);
    renumber(element.strain_partner, to.elements);
  }
  for (Hinge& hinge : model.hinges) {
    renumber(hinge.gradient1, to.gradients);
    renumber(hinge.gradient2, to.gradients);
  }
  for (TensionLine& line : model.lines) {
    renumber(line.node1, to.nodes);
    renumber(line.node2, to.nodes);
  }
  for (VariableRope& rope : model.ropes) renumber(std::span(rope.elements), to.elements);
  for (RingRope& rope : model.ring_ropes) renumber(std::span(rope.nodes), to.nodes);
  for (NodeGroup& group : model.node_groups) renumber(std::span(group.nodes), to.nodes);
  return to;
}

}  // namespace netpocket
