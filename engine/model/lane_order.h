#pragma once
// Orders items (nodes, gradients or elements of a model) so that kernels read eight at a time without gathering.
// Kernels do so where the items of a block of eight are in the same places of eight parts of a structure: part i in
// lane i (model.h, "Speed"). Here not every part needs to have every place.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace netpocket {

struct LaneItem {
  std::int32_t part = -1;               // 0 to 7; -1: the item belongs to no part
  std::array<std::int32_t, 4> place{};  // in its part, anything that tells places apart
};

// Indices of the items in their new order. A place that most parts have fills a block of eight, part i in lane i, in
// the order in which places first appear. Lanes of parts that lack the place take items of no part and of rare places.
// What remains follows. Two items of one part must not have the same place.
std::vector<std::int32_t> lane_order(std::span<const LaneItem> items);

}  // namespace netpocket
