#pragma once
// Kicks and drifts blocks of coordinates and notes their speeds, for the kernels. Only sources that are compiled once
// per instruction set may include this header.

#include "engine/dynamics/assembly/update_kernel.h"
#include "engine/math/simd.h"

namespace netpocket::simd {
namespace {

// All forces but those of elements.
NETPOCKET_INLINE SimdVector applied_force(const update_kernel::UpdateView& view, std::int32_t block, int part) {
  if (view.loaded[block] == 0) return SimdVector{SimdDouble{}, SimdDouble{}, SimdDouble{}};
  const double* rows = view.applied.first + static_cast<std::ptrdiff_t>(block) * (kVectorRows * kBlock);
  return {load(rows, part), load(rows + kBlock, part), load(rows + 2 * kBlock, part)};
}

// Returns the new velocity.
NETPOCKET_INLINE SimdDouble move(double* coordinate, double* velocity, int part, const SimdDouble& change,
                                 const SimdDouble& drift) {
  const SimdDouble v = load(velocity, part) + change;
  store(velocity, part, v);
  store(coordinate, part, load(coordinate, part) + drift * v);
  return v;
}

// Moves the rows x, y and z of a block. `gain`: kick over mass. Returns the square of the new velocity.
NETPOCKET_INLINE SimdDouble move(double* coordinates, double* velocities, int part, const SimdDouble& gain,
                                 const SimdVector& force, const SimdDouble& drift) {
  const SimdDouble vx = move(coordinates, velocities, part, gain * force.x, drift);
  const SimdDouble vy = move(coordinates + kBlock, velocities + kBlock, part, gain * force.y, drift);
  const SimdDouble vz = move(coordinates + 2 * kBlock, velocities + 2 * kBlock, part, gain * force.z, drift);
  return (vx * vx + vz * vz) + vy * vy;
}

// Of positions or of gradients. A maximum may miss a NaN, a sum does not.
struct LargestSquare {
  SimdDouble largest = {}, sum = {};
};
NETPOCKET_INLINE void note(LargestSquare& of, const SimdDouble& square) {
  of.largest = larger(of.largest, square);
  of.sum = of.sum + square;
}
NETPOCKET_INLINE void note_weighted(LargestSquare& of, const SimdDouble& weight, const SimdDouble& square) {
  note(of, (weight * weight) * square);
}
NETPOCKET_INLINE double value(const LargestSquare& of) {
  double largest = 0, sum = 0;
  for (int lane = 0; lane < kWidth; ++lane) {
    largest = of.largest[lane] > largest ? of.largest[lane] : largest;
    sum += of.sum[lane];
  }
  return sum != sum ? sum : largest;
}

}  // namespace
}  // namespace netpocket::simd
