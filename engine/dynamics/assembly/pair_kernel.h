#pragma once
// Instruction-set variants of the fused pass over pairs of elements (strain_pair.h). The middle of a pair touches no
// other element. So it can be moved as soon as the pair's forces are known, and these forces need not be stored.

#include <cstdint>

#include "engine/ancf/element_batch.h"
#include "engine/dynamics/assembly/update_kernel.h"
#include "engine/math/instruction_set.h"

namespace netpocket::pair_kernel {

// Blocks of coordinates in the middle of a pair of element blocks; -1: the pass does not move them.
struct PairMiddle {
  std::int32_t position = -1, gradient = -1;
};

// Rows of eight lanes for each element block: power dissipated and fed (BatchPower).
inline constexpr int kPowerRows = 2;

struct PairView {
  BatchView batch;
  const PairMiddle* middles;  // by element block
  const std::uint8_t* known;  // by element block: whether forces and powers are known already
  double* element_forces;     // kForceRows by element block
  double* powers;             // kPowerRows by element block, where known
};

struct PairSums {
  BatchPower power;
  update_kernel::Fastest fastest;
};

// Computes the forces of element blocks [first, last) that are not known, at the coordinates and velocities of
// `motion`. Where a pair has a middle it moves the middle and stores only the forces on its ends. Returns the power of
// all these blocks and the largest speeds of the moved middles.
using MoveKernel = PairSums (*)(const PairView& view, const update_kernel::UpdateView& motion, int first, int last,
                                double kick, double drift);
// Stores forces and powers of `count` element blocks, none of which is the second of a pair. Of pairs it stores those
// of both blocks.
using ForceKernel = void (*)(const PairView& view, const CoordinateRows& coordinates, const CoordinateRows& velocities,
                             const std::int32_t* element_blocks, std::size_t count);

NETPOCKET_VARIANTS(PairSums move(const PairView& view, const update_kernel::UpdateView& motion, int first, int last,
                                 double kick, double drift);
                   void forces(const PairView& view, const CoordinateRows& coordinates,
                               const CoordinateRows& velocities, const std::int32_t* element_blocks,
                               std::size_t count);)

}  // namespace netpocket::pair_kernel
