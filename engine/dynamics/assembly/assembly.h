#pragma once
// Which element forces act on which coordinate. Forces are gathered coordinate by coordinate, elements in ascending
// order, so that the sum does not depend on threads and repeats itself from sector to sector.

#include <span>
#include <vector>

#include "engine/dynamics/assembly/coordinate_vectors.h"
#include "engine/dynamics/assembly/update_kernel.h"

namespace netpocket {

class Assembly {
 public:
  // `threads`: that share the blocks.
  Assembly(std::span<const BatchElement> elements, std::int32_t coordinate_count, int threads);

  int block_count() const { return static_cast<int>(blocks_.size()); }
  // Fills the first four members of a view.
  void describe(update_kernel::UpdateView& view) const;

 private:
  void add_block(std::int32_t coordinate_block, std::span<const update_kernel::LaneContribution> contributions);

  std::vector<update_kernel::CoordinateBlock> blocks_;
  std::vector<std::int32_t> place_;  // in blocks_, by block of coordinates
  std::vector<update_kernel::BlockContribution> block_contributions_;
  std::vector<update_kernel::LaneContribution> lane_contributions_;
};

}  // namespace netpocket
