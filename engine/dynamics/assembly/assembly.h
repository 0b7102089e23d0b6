#pragma once
// The map from element forces to coordinates. Forces are summed coordinate by coordinate: first those of element blocks
// that act on the whole block of coordinates, then those that act on most of it, then the others, each in ascending
// order. So the sum does not depend on the number of threads and is the same in every sector.

#include <span>
#include <vector>

#include "engine/base/aligned_vector.h"
#include "engine/dynamics/assembly/coordinate_vectors.h"
#include "engine/dynamics/assembly/update_kernel.h"

namespace netpocket {

class Assembly {
 public:
  // `threads`: number of threads that share the coordinate blocks. `is_last`: by block of coordinates, whether the
  // block comes after all others (0: no); empty: none.
  Assembly(std::span<const BatchElement> elements, std::int32_t coordinate_count, int threads,
           std::span<const std::uint8_t> is_last = {});

  int block_count() const { return static_cast<int>(blocks_.size()); }
  // Fills the first five members of `view`. They point into this object, which must outlive the view.
  void describe(update_kernel::UpdateView& view) const;
  const update_kernel::CoordinateBlock& block(std::int32_t coordinate_block) const {
    return blocks_[static_cast<std::size_t>(place_[static_cast<std::size_t>(coordinate_block)])];
  }

 private:
  void add_block(std::int32_t coordinate_block, std::span<const update_kernel::LaneContribution> contributions);

  std::vector<update_kernel::CoordinateBlock> blocks_;
  std::vector<std::int32_t> place_;  // by block of coordinates: index into blocks_
  std::vector<update_kernel::BlockContribution> block_contributions_;
  AlignedVector<update_kernel::PartContribution> part_contributions_;
  std::vector<update_kernel::LaneContribution> lane_contributions_;
};

}  // namespace netpocket
