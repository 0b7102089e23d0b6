#pragma once
// Reading an element block's coordinates and writing its forces, for the kernels. To be included only by sources that
// are compiled once per instruction set.

#include "engine/ancf/element_batch.h"
#include "engine/ancf/lanes.h"

namespace netpocket::lanes {
namespace {

// Vectors of the slots of part `part` of a list of eight.
NETPOCKET_INLINE Lanes3 gather_slots(const double* rows, const std::int32_t* slots, int part) {
  std::ptrdiff_t place[kWidth];
  for (int i = 0; i < kWidth; ++i) {
    const std::ptrdiff_t slot = slots[part * kWidth + i];
    place[i] = slot / kBlock * (kSlotRows * kBlock) + slot % kBlock;
  }
  return gather3(rows, place);
}

NETPOCKET_INLINE Lanes3 load_slot(const SlotRows& rows, const ElementBlock& block, int corner, int part) {
  if (block.base[corner] >= 0) {
    const double* row = rows.first + static_cast<std::ptrdiff_t>(block.base[corner]) * kSlotRows;
    const int rotation = block.rotation[corner];
    return {load_rotated(row, part, rotation), load_rotated(row + kBlock, part, rotation),
            load_rotated(row + 2 * kBlock, part, rotation)};
  }
  return gather_slots(rows.first, block.slot[corner], part);
}

// `row`: the first of the three force rows of a corner.
NETPOCKET_INLINE void store3(double* out, int row, int part, const Lanes3& value) {
  store(out + row * kBlock, part, value.x);
  store(out + (row + 1) * kBlock, part, value.y);
  store(out + (row + 2) * kBlock, part, value.z);
}

}  // namespace
}  // namespace netpocket::lanes
