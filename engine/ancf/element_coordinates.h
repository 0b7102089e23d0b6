#pragma once
// Reads the coordinates of an element block and writes its forces, for the kernels. Only sources that are compiled once
// per instruction set may include this header.

#include "engine/ancf/element_batch.h"
#include "engine/math/simd.h"

namespace netpocket::simd {
namespace {

// Vectors of the coordinates whose indices are part `part` of a list of eight.
NETPOCKET_INLINE SimdVector gather_coordinates(const double* rows, const std::int32_t* indices, int part) {
  std::ptrdiff_t place[kWidth];
  for (int i = 0; i < kWidth; ++i) {
    const std::ptrdiff_t coordinate = indices[part * kWidth + i];
    place[i] = coordinate / kBlock * (kVectorRows * kBlock) + coordinate % kBlock;
  }
  return gather3(rows, place);
}

// Of a corner that reads a run, at least in most lanes.
NETPOCKET_INLINE SimdVector load_run(const CoordinateRows& rows, const ElementBlock& block, int corner, int part) {
  const double* row = rows.first + static_cast<std::ptrdiff_t>(block.base[corner]) * kVectorRows;
  const int rotation = block.rotation[corner];
  return {load_rotated(row, part, rotation), load_rotated(row + kBlock, part, rotation),
          load_rotated(row + 2 * kBlock, part, rotation)};
}

NETPOCKET_INLINE SimdVector load_coordinate(const CoordinateRows& rows, const ElementBlock& block, int corner,
                                            int part) {
  if (block.base[corner] < 0) return gather_coordinates(rows.first, block.coordinate[corner], part);
  SimdVector value = load_run(rows, block, corner, part);
  const unsigned odd = block.odd[corner] >> (part * kWidth) & ((1U << kWidth) - 1);
  for (unsigned left = odd; left != 0; left &= left - 1) {
    const int lane = __builtin_ctz(left);
    const std::ptrdiff_t coordinate = block.coordinate[corner][part * kWidth + lane];
    const double* row = rows.first + (coordinate / kBlock * (kVectorRows * kBlock) + coordinate % kBlock);
    value.x = with_lane(value.x, lane, row[0]);
    value.y = with_lane(value.y, lane, row[kBlock]);
    value.z = with_lane(value.z, lane, row[2 * kBlock]);
  }
  return value;
}

// Stores a vector in three force rows, of which `row` is the first.
NETPOCKET_INLINE void store3(double* out, int row, int part, const SimdVector& value) {
  store(out + row * kBlock, part, value.x);
  store(out + (row + 1) * kBlock, part, value.y);
  store(out + (row + 2) * kBlock, part, value.z);
}

}  // namespace
}  // namespace netpocket::simd
