#include "engine/dynamics/assembly.h"

#include <algorithm>
#include <optional>
#include <tuple>

namespace netpocket {
namespace {

using slot_kernel::BlockContribution;
using slot_kernel::LaneContribution;

int rotation_of(const LaneContribution& c) { return (c.element_lane - c.slot_lane + kBlockSize) % kBlockSize; }

// The contributions as whole blocks, if they are: every group of eight equal (element block, corner, rotation) covers
// all slot lanes.
std::optional<std::vector<BlockContribution>> as_whole_blocks(std::span<const LaneContribution> contributions) {
  std::vector<LaneContribution> sorted(contributions.begin(), contributions.end());
  std::ranges::stable_sort(sorted, {}, [](const LaneContribution& c) {
    return std::make_tuple(c.element_block, c.corner, rotation_of(c), c.slot_lane);
  });
  if (sorted.size() % kBlockSize != 0) return std::nullopt;
  std::vector<BlockContribution> blocks;
  for (std::size_t i = 0; i < sorted.size(); i += kBlockSize) {
    const LaneContribution& head = sorted[i];
    for (int lane = 0; lane < kBlockSize; ++lane) {
      const LaneContribution& c = sorted[i + lane];
      if (c.element_block != head.element_block || c.corner != head.corner || c.slot_lane != lane ||
          rotation_of(c) != rotation_of(head)) {
        return std::nullopt;
      }
    }
    blocks.push_back({slot_kernel::first_force_row(head.element_block, head.corner),
                      static_cast<std::uint8_t>(rotation_of(head)), head.corner == Corner::position2});
  }
  return blocks;
}

}  // namespace

Assembly::Assembly(std::span<const BatchElement> elements, std::int32_t slot_count) {
  std::vector<std::vector<LaneContribution>> by_block(slot_count / kBlockSize);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    for (int corner = 0; corner < 4; ++corner) {
      const std::int32_t slot = elements[i].slot[corner];
      by_block[slot / kBlockSize].push_back({.element_block = static_cast<std::int32_t>(i / kBlockSize),
                                             .corner = static_cast<Corner>(corner),
                                             .element_lane = static_cast<std::uint8_t>(i % kBlockSize),
                                             .slot_lane = static_cast<std::uint8_t>(slot % kBlockSize)});
    }
  }
  for (const auto& contributions : by_block) add_block(contributions);
}

void Assembly::add_block(std::span<const LaneContribution> contributions) {
  slot_kernel::SlotBlock block;
  if (const auto whole = as_whole_blocks(contributions)) {
    block = {static_cast<std::int32_t>(block_contributions_.size()), static_cast<std::int32_t>(whole->size()), true};
    block_contributions_.insert(block_contributions_.end(), whole->begin(), whole->end());
  } else {
    block = {static_cast<std::int32_t>(lane_contributions_.size()), static_cast<std::int32_t>(contributions.size()),
             false};
    lane_contributions_.insert(lane_contributions_.end(), contributions.begin(), contributions.end());
  }
  blocks_.push_back(block);
}

void Assembly::describe(slot_kernel::UpdateView& view) const {
  view.blocks = blocks_.data();
  view.block_contributions = block_contributions_.data();
  view.lane_contributions = lane_contributions_.data();
}

Eigen::Vector3d Assembly::element_force(std::int32_t slot, const double* element_forces) const {
  const slot_kernel::SlotBlock& block = blocks_[slot / kBlockSize];
  const int slot_lane = slot % kBlockSize;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  const auto add = [&](std::int32_t first_row, bool reaction, int element_lane) {
    const double* row = element_forces + static_cast<std::ptrdiff_t>(first_row) * kBlockSize + element_lane;
    const Eigen::Vector3d resisting(row[0], row[kBlockSize], row[2 * kBlockSize]);
    if (reaction) {
      force += resisting;
    } else {
      force -= resisting;
    }
  };
  for (std::int32_t i = block.first; i < block.first + block.count; ++i) {
    if (block.regular) {
      const BlockContribution& c = block_contributions_[i];
      add(c.first_row, c.reaction, (slot_lane + c.rotation) % kBlockSize);
    } else if (lane_contributions_[i].slot_lane == slot_lane) {
      const LaneContribution& c = lane_contributions_[i];
      add(slot_kernel::first_force_row(c.element_block, c.corner), c.corner == Corner::position2, c.element_lane);
    }
  }
  return force;
}

}  // namespace netpocket
