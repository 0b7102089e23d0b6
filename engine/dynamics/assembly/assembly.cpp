#include "engine/dynamics/assembly/assembly.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "engine/base/thread_team.h"

namespace netpocket {
namespace {

using update_kernel::LaneContribution;
using update_kernel::PartContribution;

int rotation_of(const LaneContribution& c) { return (c.element_lane - c.coordinate_lane + kBlockSize) % kBlockSize; }

// Fewer lanes than this are added one by one.
constexpr std::size_t kLeastLanesOfAPart = 4;

// Element block, corner and rotation: lanes that agree in these are added together.
auto group_of(const LaneContribution& c) { return std::make_tuple(c.element_block, c.corner, rotation_of(c)); }

double sign_of(Corner corner) { return corner == Corner::position2 ? 1.0 : -1.0; }

PartContribution part_of(std::span<const LaneContribution> group) {
  const LaneContribution& head = group.front();
  PartContribution part{.sign = {},
                        .first_row = update_kernel::first_force_row(head.element_block, head.corner),
                        .rotation = rotation_of(head)};
  for (const LaneContribution& c : group) part.sign[c.coordinate_lane] = sign_of(c.corner);
  return part;
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
  std::vector<LaneContribution> sorted(contributions.begin(), contributions.end());
  std::ranges::stable_sort(
      sorted, {}, [](const LaneContribution& c) { return std::tuple_cat(group_of(c), std::tuple(c.coordinate_lane)); });
  const auto size = [](const auto& list) { return static_cast<std::int32_t>(list.size()); };
  update_kernel::CoordinateBlock block{.coordinate_block = coordinate_block,
                                       .whole = {.first = size(block_contributions_)},
                                       .parts = {.first = size(part_contributions_)},
                                       .lanes = {.first = size(lane_contributions_)}};
  for (auto first = sorted.begin(); first != sorted.end();) {
    const auto last = std::find_if(first, sorted.end(), [&](const auto& c) { return group_of(c) != group_of(*first); });
    const std::span<const LaneContribution> group(first, last);
    if (group.size() == kBlockSize) {
      block_contributions_.push_back({.sign = sign_of(first->corner),
                                      .first_row = update_kernel::first_force_row(first->element_block, first->corner),
                                      .rotation = rotation_of(*first)});
    } else if (group.size() >= kLeastLanesOfAPart) {
      part_contributions_.push_back(part_of(group));
    } else {
      lane_contributions_.insert(lane_contributions_.end(), first, last);
    }
    first = last;
  }
  block.whole.count = size(block_contributions_) - block.whole.first;
  block.parts.count = size(part_contributions_) - block.parts.first;
  block.lanes.count = size(lane_contributions_) - block.lanes.first;
  blocks_.push_back(block);
}

void Assembly::describe(update_kernel::UpdateView& view) const {
  view.blocks = blocks_.data();
  view.place = place_.data();
  view.block_contributions = block_contributions_.data();
  view.part_contributions = part_contributions_.data();
  view.lane_contributions = lane_contributions_.data();
}

}  // namespace netpocket
