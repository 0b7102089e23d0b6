#pragma once
// Reading an element block's coordinates and writing its forces, for the kernels. To be included only by sources that
// are compiled once per instruction set.

#include "engine/ancf/element_batch.h"
#include "engine/ancf/lanes.h"

namespace netpocket::lanes {
namespace {

NETPOCKET_INLINE Lanes load_component(const double* array, const ElementBlock& block, int corner, int part) {
  if (block.base[corner] >= 0) return load_rotated(array + block.base[corner], part, block.rotation[corner]);
  return gather(array, block.slot[corner], part);
}

NETPOCKET_INLINE Lanes3 load_slot(const SlotArrays& arrays, const ElementBlock& block, int corner, int part) {
  return {load_component(arrays.x, block, corner, part), load_component(arrays.y, block, corner, part),
          load_component(arrays.z, block, corner, part)};
}

// `row`: the first of the three force rows of a corner.
NETPOCKET_INLINE void store3(double* out, int row, int part, const Lanes3& value) {
  store(out + row * kBlock, part, value.x);
  store(out + (row + 1) * kBlock, part, value.y);
  store(out + (row + 2) * kBlock, part, value.z);
}

}  // namespace
}  // namespace netpocket::lanes
