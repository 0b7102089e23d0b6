#pragma once
// Instruction-set variants of the coordinate update: summing the element forces on each coordinate, kick, drift.

#include <cstddef>
#include <cstdint>

#include "engine/ancf/element_batch.h"
#include "engine/math/instruction_set.h"

namespace netpocket::update_kernel {

// The force rows of an element block act on a coordinate block. Lane i of the coordinates takes lane (i + rotation) mod
// 8 of the elements.
struct BlockContribution {
  double sign;             // -1, as rows hold internal forces; +1 for position2, which uses minus the rows of position1
  std::int32_t first_row;  // index of the first of three force rows, over all element blocks
  std::int32_t rotation;
};

// The same in some lanes only.
struct alignas(64) PartContribution {
  double sign[kBlockSize];  // by lane of the coordinates: as BlockContribution::sign, or 0
  std::int32_t first_row;
  std::int32_t rotation;
};

// Index, over all element blocks, of the first of the three force rows of a corner of a block.
constexpr std::int32_t first_force_row(std::int32_t element_block, Corner corner) {
  constexpr std::int32_t kRow[4] = {0, 3, 0, 6};  // the force on position2 is minus that on position1
  return element_block * kForceRows + kRow[static_cast<int>(corner)];
}

// Forces that exceed the cache are prefetched this many contributions ahead, so as many entries follow the last one.
inline constexpr int kContributionsAhead = 8;

// The force of one element on one coordinate.
struct LaneContribution {
  std::int32_t element_block;
  Corner corner;
  std::uint8_t element_lane;
  std::uint8_t coordinate_lane;
};

// Part of a list.
struct Section {
  std::int32_t first = 0, count = 0;
};

// The contributions to eight consecutive coordinates. They are summed in this order.
struct CoordinateBlock {
  std::int32_t coordinate_block = 0;  // the coordinates are coordinate_block * 8 to coordinate_block * 8 + 7
  Section whole, parts, lanes;        // of the lists in UpdateView
};

struct UpdateView {
  const CoordinateBlock* blocks;
  const std::int32_t* place;  // by block of coordinates: index into `blocks`
  const BlockContribution* block_contributions;
  const PartContribution* part_contributions;
  const LaneContribution* lane_contributions;
  const double* element_forces;
  bool exceeds_cache;          // whether the data of a step exceeds a processor's cache
  const double* inverse_mass;  // 1/kg (positions), 1/(kg m^2) (gradients); 0: not free
  CoordinateRows applied;      // N or N m: all forces but those of elements
  const std::uint8_t* loaded;  // by block of coordinates: 0 where `applied` is zero, so that it need not be read
  double* coordinates;         // CoordinateRows
  double* velocities;
  const double* weight;         // by gradient's coordinate, as in Fastest
  std::int32_t gradient_block;  // number of the first block of coordinates that holds gradients
};

// Largest |v|^2 of positions and (weight |v|)^2 of gradients; NaN if any value is NaN.
struct Fastest {
  double position = 0, gradient = 0;
};

// v += kick M^-1 F, x += drift v on view.blocks [first, last). Returns the largest speeds among these.
using Kernel = Fastest (*)(const UpdateView& view, int first, int last, double kick, double drift);
// Sums all forces on each of `count` blocks of coordinates. Writes three rows per block to `forces` (64-byte aligned).
using SumKernel = void (*)(const UpdateView& view, const std::int32_t* coordinate_blocks, std::size_t count,
                           double* forces);

NETPOCKET_VARIANTS(Fastest update(const UpdateView& view, int first, int last, double kick, double drift);
                   void sum_forces(const UpdateView& view, const std::int32_t* coordinate_blocks, std::size_t count,
                                   double* forces);)

}  // namespace netpocket::update_kernel
