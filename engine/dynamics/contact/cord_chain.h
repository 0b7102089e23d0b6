#pragma once
// Finds which elements continue each other along a cord: they share a gradient, at the end of one and the start of the
// other.

#include <cstdint>
#include <vector>

#include "engine/model/model.h"

namespace netpocket {

// For each element, the element that continues its cord at the second end, or -1. Elements without thickness, which
// touch nothing, continue none.
inline std::vector<std::int32_t> next_elements(const Model& model) {
  std::vector<std::int32_t> starting(model.gradients.size(), -1), next;
  const auto original = [&](std::int32_t gradient) {
    const std::int32_t copied = model.gradients[static_cast<std::size_t>(gradient)].copy_of;
    return static_cast<std::size_t>(copied < 0 ? gradient : copied);
  };
  for (std::size_t i = model.elements.size(); i-- > 0;) {
    const auto index = static_cast<std::int32_t>(i);
    if (model.radius_of(index) > 0) starting[original(model.elements[i].gradient1)] = index;
  }
  next.reserve(model.elements.size());
  for (const ModelElement& element : model.elements) {
    next.push_back(starting[original(element.gradient2)]);
  }
  return next;
}

// For each element, the element before it on its cord, or -1.
inline std::vector<std::int32_t> previous_elements(const std::vector<std::int32_t>& next) {
  std::vector<std::int32_t> previous(next.size(), -1);
  for (std::size_t i = 0; i < next.size(); ++i) {
    if (next[i] >= 0) previous[static_cast<std::size_t>(next[i])] = static_cast<std::int32_t>(i);
  }
  return previous;
}

}  // namespace netpocket
