#pragma once
// The instruction-set variants of the slot update: sum the element forces on each slot, kick, drift.

#include <cstdint>

#include "engine/ancf/element_batch.h"

namespace netpocket::slot_kernel {

// The force rows of a whole element block act on a whole slot block: lane i of the slots takes lane
// (i + rotation) mod 8 of the elements.
struct BlockContribution {
  std::int32_t first_row;  // of the three force rows, counted through all element blocks
  std::uint8_t rotation;
  bool reaction;  // position2, whose force is minus that on position1
};

// First of the three force rows of a corner of an element block, counted through all blocks.
constexpr std::int32_t first_force_row(std::int32_t element_block, Corner corner) {
  constexpr std::int32_t kRow[4] = {0, 3, 0, 6};  // the force on position2 is minus that on position1
  return element_block * kForceRows + kRow[static_cast<int>(corner)];
}

// One element's force on one slot.
struct LaneContribution {
  std::int32_t element_block;
  Corner corner;
  std::uint8_t element_lane;
  std::uint8_t slot_lane;
};

// Contributions to eight consecutive slots, in the order in which they are summed.
struct SlotBlock {
  std::int32_t first = 0;
  std::int32_t count = 0;
  bool regular = false;  // BlockContribution or LaneContribution
};

struct UpdateView {
  const SlotBlock* blocks;
  const BlockContribution* block_contributions;
  const LaneContribution* lane_contributions;
  const double* element_forces;
  const double* inverse_mass;  // 1/kg (positions), 1/(kg m^2) (gradients); 0: does not move by itself
  SlotArrays applied;          // N or N m: everything but element forces
  const std::uint8_t* loaded;  // by block: 0 where `applied` is zero, so that it need not be read
  SlotArrays coordinates;
  SlotArrays velocities;
};

using Kernel = void (*)(const UpdateView& view, int first, int last, double kick, double drift);

namespace baseline {
void update(const UpdateView& view, int first, int last, double kick, double drift);
}
namespace avx2 {
void update(const UpdateView& view, int first, int last, double kick, double drift);
}
namespace avx512 {
void update(const UpdateView& view, int first, int last, double kick, double drift);
}

}  // namespace netpocket::slot_kernel
