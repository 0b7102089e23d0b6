#pragma once
// Which element forces act on which slot. Forces are gathered slot by slot, elements in ascending order, so that the
// sum does not depend on threads and repeats itself from sector to sector.

#include <span>
#include <vector>

#include "engine/dynamics/slot_kernel.h"
#include "engine/dynamics/slot_state.h"

namespace netpocket {

class Assembly {
 public:
  // `threads`: that share the blocks.
  Assembly(std::span<const BatchElement> elements, std::int32_t slot_count, int threads);

  int block_count() const { return static_cast<int>(blocks_.size()); }
  // Fills the first four members of a view.
  void describe(slot_kernel::UpdateView& view) const;

 private:
  void add_block(std::int32_t slot_block, std::span<const slot_kernel::LaneContribution> contributions);

  std::vector<slot_kernel::SlotBlock> blocks_;
  std::vector<std::int32_t> place_;  // in blocks_, by block of slots
  std::vector<slot_kernel::BlockContribution> block_contributions_;
  std::vector<slot_kernel::LaneContribution> lane_contributions_;
};

}  // namespace netpocket
