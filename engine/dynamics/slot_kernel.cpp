// Compiled once per instruction set, NETPOCKET_ISA_NAME being the variant's namespace.

#include "engine/dynamics/slot_kernel.h"

#include "engine/ancf/lanes.h"

namespace netpocket::slot_kernel::NETPOCKET_ISA_NAME {
namespace {

using namespace lanes;

NETPOCKET_INLINE const double* row_at(const UpdateView& view, std::int32_t row) {
  return view.element_forces + static_cast<std::ptrdiff_t>(row) * kBlock;
}

NETPOCKET_INLINE void add_regular(const UpdateView& view, const SlotBlock& block, int part, Lanes3& force) {
  const BlockContribution* contribution = view.block_contributions + block.first;
  for (std::int32_t i = 0; i < block.count; ++i, ++contribution) {
    const double* rows = row_at(view, contribution->first_row);
    const Lanes3 resisting = {load_rotated(rows, part, contribution->rotation),
                              load_rotated(rows + kBlock, part, contribution->rotation),
                              load_rotated(rows + 2 * kBlock, part, contribution->rotation)};
    force = contribution->reaction ? force + resisting : force - resisting;
  }
}

NETPOCKET_INLINE void add_irregular(const UpdateView& view, const SlotBlock& block, int part, Lanes3& force) {
  const LaneContribution* contribution = view.lane_contributions + block.first;
  for (std::int32_t i = 0; i < block.count; ++i, ++contribution) {
    if (contribution->slot_lane / kWidth != part) continue;
    const double* rows =
        row_at(view, first_force_row(contribution->element_block, contribution->corner)) + contribution->element_lane;
    const double sign = contribution->corner == Corner::position2 ? 1.0 : -1.0;
    const int lane = contribution->slot_lane % kWidth;
    force.x[lane] += sign * rows[0];
    force.y[lane] += sign * rows[kBlock];
    force.z[lane] += sign * rows[2 * kBlock];
  }
}

NETPOCKET_INLINE void move(double* coordinate, double* velocity, int part, const Lanes& change, const Lanes& drift) {
  const Lanes v = load(velocity, part) + change;
  store(velocity, part, v);
  store(coordinate, part, load(coordinate, part) + drift * v);
}

}  // namespace

void update(const UpdateView& view, int first, int last, double kick, double drift) {
  for (int i = first; i < last; ++i) {
    const std::ptrdiff_t slot = static_cast<std::ptrdiff_t>(i) * kBlock;
    const SlotBlock& block = view.blocks[i];
    for (int part = 0; part < kParts; ++part) {
      Lanes3 force = {};
      if (view.loaded[i] != 0) {
        force = {load(view.applied.x + slot, part), load(view.applied.y + slot, part),
                 load(view.applied.z + slot, part)};
      }
      if (block.regular) {
        add_regular(view, block, part, force);
      } else {
        add_irregular(view, block, part, force);
      }
      const Lanes gain = broadcast(kick) * load(view.inverse_mass + slot, part);
      move(view.coordinates.x + slot, view.velocities.x + slot, part, gain * force.x, broadcast(drift));
      move(view.coordinates.y + slot, view.velocities.y + slot, part, gain * force.y, broadcast(drift));
      move(view.coordinates.z + slot, view.velocities.z + slot, part, gain * force.z, broadcast(drift));
    }
  }
}

}  // namespace netpocket::slot_kernel::NETPOCKET_ISA_NAME
