#include "engine/dynamics/assembly/assembly.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

#include "engine/base/thread_team.h"

namespace netpocket {
namespace {

using update_kernel::BlockContribution;
using update_kernel::LaneContribution;

int rotation_of(const LaneContribution& c) { return (c.element_lane - c.coordinate_lane + kBlockSize) % kBlockSize; }

// The contributions as whole blocks if possible, else nothing. It is possible if every group of eight with equal
// element block, corner and rotation covers all coordinate lanes.
std::optional<std::vector<BlockContribution>> as_whole_blocks(std::span<const LaneContribution> contributions) {
  std::vector<LaneContribution> sorted(contributions.begin(), contributions.end());
  std::ranges::stable_sort(sorted, {}, [](const LaneContribution& c) {
    return std::make_tuple(c.element_block, c.corner, rotation_of(c), c.coordinate_lane);
  });
  if (sorted.size() % kBlockSize != 0) return std::nullopt;
  std::vector<BlockContribution> blocks;
  for (std::size_t i = 0; i < sorted.size(); i += kBlockSize) {
    const LaneContribution& head = sorted[i];
    for (int lane = 0; lane < kBlockSize; ++lane) {
      const LaneContribution& c = sorted[i + lane];
      if (c.element_block != head.element_block || c.corner != head.corner || c.coordinate_lane != lane ||
          rotation_of(c) != rotation_of(head)) {
        return std::nullopt;
      }
    }
    blocks.push_back({.sign = head.corner == Corner::position2 ? 1.0 : -1.0,
                      .first_row = update_kernel::first_force_row(head.element_block, head.corner),
                      .rotation = rotation_of(head)});
  }
  return blocks;
}

// Divides the coordinate blocks into equal parts, one per thread. Each part holds the blocks on which its part of the
// elements acts, so that a thread finds most of what it reads in its own cache.
std::vector<std::int32_t> divide(const std::vector<std::vector<LaneContribution>>& by_block, int parts) {
  std::vector<double> middle(by_block.size(), 0.0);  // mean index of the element blocks that act on a block
  for (std::size_t i = 0; i < by_block.size(); ++i) {
    for (const LaneContribution& c : by_block[i]) middle[i] += c.element_block;
    if (!by_block[i].empty()) middle[i] /= static_cast<double>(by_block[i].size());
  }
  std::vector<std::int32_t> order(by_block.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::int32_t block) { return middle[block]; });
  for (int part = 0; part < parts; ++part) {
    std::sort(order.begin() + ThreadTeam::bound(static_cast<int>(order.size()), part, parts),
              order.begin() + ThreadTeam::bound(static_cast<int>(order.size()), part + 1, parts));
  }
  return order;
}

}  // namespace

Assembly::Assembly(std::span<const BatchElement> elements, std::int32_t coordinate_count, int threads,
                   std::span<const std::uint8_t> is_last) {
  std::vector<std::vector<LaneContribution>> by_block(coordinate_count / kBlockSize);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    for (int corner = 0; corner < 4; ++corner) {
      const std::int32_t coordinate = elements[i].coordinate[corner];
      by_block[coordinate / kBlockSize].push_back(
          {.element_block = static_cast<std::int32_t>(i / kBlockSize),
           .corner = static_cast<Corner>(corner),
           .element_lane = static_cast<std::uint8_t>(i % kBlockSize),
           .coordinate_lane = static_cast<std::uint8_t>(coordinate % kBlockSize)});
    }
  }
  place_.resize(by_block.size());
  std::vector<std::int32_t> order = divide(by_block, threads);
  if (!is_last.empty()) {
    std::ranges::stable_partition(order,
                                  [&](std::int32_t block) { return is_last[static_cast<std::size_t>(block)] == 0; });
  }
  for (const std::int32_t coordinate_block : order) {
    place_[coordinate_block] = static_cast<std::int32_t>(blocks_.size());
    add_block(coordinate_block, by_block[coordinate_block]);
  }
  block_contributions_.resize(block_contributions_.size() + update_kernel::kContributionsAhead);
}

void Assembly::add_block(std::int32_t coordinate_block, std::span<const LaneContribution> contributions) {
  update_kernel::CoordinateBlock block{.coordinate_block = coordinate_block};
  if (const auto whole = as_whole_blocks(contributions)) {
    block.first = static_cast<std::int32_t>(block_contributions_.size());
    block.count = static_cast<std::int32_t>(whole->size());
    block.regular = true;
    block_contributions_.insert(block_contributions_.end(), whole->begin(), whole->end());
  } else {
    block.first = static_cast<std::int32_t>(lane_contributions_.size());
    block.count = static_cast<std::int32_t>(contributions.size());
    lane_contributions_.insert(lane_contributions_.end(), contributions.begin(), contributions.end());
  }
  blocks_.push_back(block);
}

void Assembly::describe(update_kernel::UpdateView& view) const {
  view.blocks = blocks_.data();
  view.place = place_.data();
  view.block_contributions = block_contributions_.data();
  view.lane_contributions = lane_contributions_.data();
}

}  // namespace netpocket
