#pragma once
// Gives the nodes, gradients and elements of a model another order. The model stays the same but for round-off.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/model/model.h"

namespace netpocket {

// By new index, the old one. Each list names every item once.
struct ModelOrder {
  std::vector<std::int32_t> nodes, gradients, elements;
};

// By old index, the new one.
struct NewIndices {
  std::vector<std::int32_t> nodes, gradients, elements;
};

// Reorders the model and everything in it that names nodes, gradients or elements.
NewIndices reorder(Model& model, const ModelOrder& order);

// Replaces old indices by new ones; -1 stays.
void renumber(std::span<std::int32_t> indices, std::span<const std::int32_t> new_index);

}  // namespace netpocket
