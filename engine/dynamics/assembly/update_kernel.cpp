// Compiled once per instruction set; NETPOCKET_ISA_NAME is the variant's namespace.

#include "engine/dynamics/assembly/update_kernel.h"

#include "engine/dynamics/assembly/move_block.h"
#include "engine/math/simd.h"

namespace netpocket::update_kernel::NETPOCKET_ISA_NAME {
namespace {

using namespace simd;

NETPOCKET_INLINE const double* row_at(const UpdateView& view, std::int32_t row) {
  return view.element_forces + static_cast<std::ptrdiff_t>(row) * kBlock;
}

template <bool kPrefetches>
NETPOCKET_INLINE void add_regular(const UpdateView& view, const CoordinateBlock& block, int part, SimdVector& force) {
  const BlockContribution* contribution = view.block_contributions + block.whole.first;
  for (std::int32_t i = 0; i < block.whole.count; ++i, ++contribution) {
    if (kPrefetches && part == 0) {
      const double* later = row_at(view, contribution[kContributionsAhead].first_row);
      __builtin_prefetch(later);
      __builtin_prefetch(later + kBlock);
      __builtin_prefetch(later + 2 * kBlock);
    }
    const double* rows = row_at(view, contribution->first_row);
    const SimdVector resisting = {load_rotated(rows, part, contribution->rotation),
                                  load_rotated(rows + kBlock, part, contribution->rotation),
                                  load_rotated(rows + 2 * kBlock, part, contribution->rotation)};
    force = force + broadcast(contribution->sign) * resisting;
  }
}

NETPOCKET_INLINE void add_parts(const UpdateView& view, const CoordinateBlock& block, int part, SimdVector& force) {
  const PartContribution* contribution = view.part_contributions + block.parts.first;
  for (std::int32_t i = 0; i < block.parts.count; ++i, ++contribution) {
    const double* rows = row_at(view, contribution->first_row);
    const SimdVector resisting = {load_rotated(rows, part, contribution->rotation),
                                  load_rotated(rows + kBlock, part, contribution->rotation),
                                  load_rotated(rows + 2 * kBlock, part, contribution->rotation)};
    force = force + load(contribution->sign, part) * resisting;
  }
}

// Not inline, because lanes that are written one by one would keep the forces of all blocks in memory.
[[gnu::noinline]] void add_irregular(const UpdateView& view, const CoordinateBlock& block, int part,
                                     SimdVector& force) {
  const LaneContribution* contribution = view.lane_contributions + block.lanes.first;
  for (std::int32_t i = 0; i < block.lanes.count; ++i, ++contribution) {
    if (contribution->coordinate_lane / kWidth != part) continue;
    const double* rows =
        row_at(view, first_force_row(contribution->element_block, contribution->corner)) + contribution->element_lane;
    const double sign = contribution->corner == Corner::position2 ? 1.0 : -1.0;
    const int lane = contribution->coordinate_lane % kWidth;
    force.x[lane] += sign * rows[0];
    force.y[lane] += sign * rows[kBlock];
    force.z[lane] += sign * rows[2 * kBlock];
  }
}

template <bool kPrefetches>
NETPOCKET_INLINE SimdVector force_on(const UpdateView& view, const CoordinateBlock& block, int part) {
  SimdVector force = applied_force(view, block.coordinate_block, part);
  add_regular<kPrefetches>(view, block, part, force);
  if (block.parts.count > 0) add_parts(view, block, part, force);
  if (block.lanes.count == 0) return force;
  SimdVector irregular = force;
  add_irregular(view, block, part, irregular);
  return irregular;
}

template <bool kPrefetches, bool kPositions>
NETPOCKET_INLINE void move_block(const UpdateView& view, const CoordinateBlock& block, double kick, double drift,
                                 LargestSquare& largest) {
  const std::ptrdiff_t coordinate = static_cast<std::ptrdiff_t>(block.coordinate_block) * kBlock,
                       row = coordinate * kVectorRows;
  double *x = view.coordinates + row, *v = view.velocities + row;
  for (int part = 0; part < kParts; ++part) {
    const SimdVector force = force_on<kPrefetches>(view, block, part);
    const SimdDouble gain = broadcast(kick) * load(view.inverse_mass + coordinate, part);
    const SimdDouble square = move(x, v, part, gain, force, broadcast(drift));
    if constexpr (kPositions) {
      note(largest, square);
    } else {
      note_weighted(largest, load(view.weight + coordinate, part), square);
    }
  }
}

template <bool kPrefetches>
NETPOCKET_INLINE Fastest move_blocks(const UpdateView& view, int first, int last, double kick, double drift) {
  LargestSquare position, gradient;
  const auto holds_positions = [&](int i) { return view.blocks[i].coordinate_block < view.gradient_block; };
  for (int i = first; i < last;) {
    LargestSquare largest = position;  // local copies, to be kept in registers
    for (; i < last && holds_positions(i); ++i) {
      move_block<kPrefetches, true>(view, view.blocks[i], kick, drift, largest);
    }
    position = largest;
    largest = gradient;
    for (; i < last && !holds_positions(i); ++i) {
      move_block<kPrefetches, false>(view, view.blocks[i], kick, drift, largest);
    }
    gradient = largest;
  }
  return {value(position), value(gradient)};
}

}  // namespace

void sum_forces(const UpdateView& view, const std::int32_t* coordinate_blocks, std::size_t count, double* forces) {
  for (std::size_t i = 0; i < count; ++i) {
    const CoordinateBlock& block = view.blocks[view.place[coordinate_blocks[i]]];
    for (int part = 0; part < kParts; ++part) {
      const SimdVector force = force_on<false>(view, block, part);
      store(forces, part, force.x);
      store(forces + kBlock, part, force.y);
      store(forces + 2 * kBlock, part, force.z);
    }
    forces += kVectorRows * kBlock;
  }
}

Fastest update(const UpdateView& view, int first, int last, double kick, double drift) {
  return view.exceeds_cache ? move_blocks<true>(view, first, last, kick, drift)
                            : move_blocks<false>(view, first, last, kick, drift);
}

}  // namespace netpocket::update_kernel::NETPOCKET_ISA_NAME
