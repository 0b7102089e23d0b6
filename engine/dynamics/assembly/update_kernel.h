#pragma once
// The instruction-set variants of the coordinate update: sum the element forces on each coordinate, kick, drift.

#include <cstddef>
#include <cstdint>

#include "engine/ancf/element_batch.h"

namespace netpocket::update_kernel {

// The force rows of a whole element block act on a whole coordinate block: lane i of the coordinates takes lane
// (i + rotation) mod 8 of the elements.
struct BlockContribution {
  double sign;             // of the rows: they hold what an element resists with, and on position2 minus that
  std::int32_t first_row;  // of the three force rows, counted through all element blocks
  std::int32_t rotation;
};

// First of the three force rows of a corner of an element block, counted through all blocks.
constexpr std::int32_t first_force_row(std::int32_t element_block, Corner corner) {
  constexpr std::int32_t kRow[4] = {0, 3, 0, 6};  // the force on position2 is minus that on position1
  return element_block * kForceRows + kRow[static_cast<int>(corner)];
}

// Forces that exceed the cache are fetched ahead of their use: this many entries stand behind the last contribution,
// too.
inline constexpr int kContributionsAhead = 8;

// One element's force on one coordinate.
struct LaneContribution {
  std::int32_t element_block;
  Corner corner;
  std::uint8_t element_lane;
  std::uint8_t coordinate_lane;
};

// Contributions to eight consecutive coordinates, in the order in which they are summed.
struct CoordinateBlock {
  std::int32_t coordinate_block = 0;  // the coordinates are slot_block * 8 to slot_block * 8 + 7
  std::int32_t first = 0;
  std::int32_t count = 0;
  bool regular = false;  // BlockContribution or LaneContribution
};

struct UpdateView {
  const CoordinateBlock* blocks;
  const std::int32_t* place;  // in `blocks`, by block of coordinates
  const BlockContribution* block_contributions;
  const LaneContribution* lane_contributions;
  const double* element_forces;
  bool exceeds_cache;          // what a step reads, that of a processor
  const double* inverse_mass;  // 1/kg (positions), 1/(kg m^2) (gradients); 0: does not move by itself
  CoordinateRows applied;      // N or N m: everything but element forces
  const std::uint8_t* loaded;  // by block of coordinates: 0 where `applied` is zero, so that it need not be read
  double* coordinates;         // CoordinateRows
  double* velocities;
  const double* weight;         // by coordinate, for Fastest
  std::int32_t gradient_block;  // the first block of coordinates that are gradients
};

// The largest (weight |v|)^2 of positions and of gradients; not a number where one of them is none.
struct Fastest {
  double position = 0, gradient = 0;
};

// v += kick M^-1 F, x += drift v on view.blocks [first, last). Returns the fastest of these.
using Kernel = Fastest (*)(const UpdateView& view, int first, int last, double kick, double drift);
// Sums all forces on each of `count` blocks of coordinates into three rows of `forces` (64-byte aligned).
using SumKernel = void (*)(const UpdateView& view, const std::int32_t* coordinate_blocks, std::size_t count,
                           double* forces);

namespace baseline {
Fastest update(const UpdateView& view, int first, int last, double kick, double drift);
void sum_forces(const UpdateView& view, const std::int32_t* coordinate_blocks, std::size_t count, double* forces);
}  // namespace baseline
namespace avx2 {
Fastest update(const UpdateView& view, int first, int last, double kick, double drift);
void sum_forces(const UpdateView& view, const std::int32_t* coordinate_blocks, std::size_t count, double* forces);
}  // namespace avx2
namespace avx512 {
Fastest update(const UpdateView& view, int first, int last, double kick, double drift);
void sum_forces(const UpdateView& view, const std::int32_t* coordinate_blocks, std::size_t count, double* forces);
}  // namespace avx512

}  // namespace netpocket::update_kernel
