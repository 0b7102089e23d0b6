// Compiled once per instruction set, NETPOCKET_ISA_NAME being the variant's namespace.

#include "engine/dynamics/slot_kernel.h"

#include "engine/ancf/lanes.h"

namespace netpocket::slot_kernel::NETPOCKET_ISA_NAME {
namespace {

using namespace lanes;

// First force row of each corner; the force on position2 is minus that on position1.
constexpr int kFirstRow[4] = {0, 3, 0, 6};

NETPOCKET_INLINE const double* rows_of(const UpdateView& view, std::int32_t element_block, Corner corner) {
  return view.element_forces +
         (static_cast<std::ptrdiff_t>(element_block) * kForceRows + kFirstRow[static_cast<int>(corner)]) * kLanes;
}

NETPOCKET_INLINE void add_regular(const UpdateView& view, const SlotBlock& block, Lanes3& force) {
  const BlockContribution* contribution = view.block_contributions + block.first;
  for (std::int32_t i = 0; i < block.count; ++i, ++contribution) {
    const double* rows = rows_of(view, contribution->element_block, contribution->corner);
    const Lanes3 resisting = {rotated(load(rows), contribution->rotation),
                              rotated(load(rows + kLanes), contribution->rotation),
                              rotated(load(rows + 2 * kLanes), contribution->rotation)};
    force = contribution->corner == Corner::position2 ? force + resisting : force - resisting;
  }
}

NETPOCKET_INLINE void add_irregular(const UpdateView& view, const SlotBlock& block, Lanes3& force) {
  const LaneContribution* contribution = view.lane_contributions + block.first;
  for (std::int32_t i = 0; i < block.count; ++i, ++contribution) {
    const double* rows = rows_of(view, contribution->element_block, contribution->corner) + contribution->element_lane;
    const double sign = contribution->corner == Corner::position2 ? 1.0 : -1.0;
    const int lane = contribution->slot_lane;
    force.x[lane] += sign * rows[0];
    force.y[lane] += sign * rows[kLanes];
    force.z[lane] += sign * rows[2 * kLanes];
  }
}

NETPOCKET_INLINE void move(double* coordinate, double* velocity, const Lanes& change, const Lanes& drift) {
  const Lanes v = load(velocity) + change;
  store(velocity, v);
  store(coordinate, load(coordinate) + drift * v);
}

}  // namespace

void update(const UpdateView& view, int first, int last, double kick, double drift) {
  for (int i = first; i < last; ++i) {
    const std::ptrdiff_t slot = static_cast<std::ptrdiff_t>(i) * kLanes;
    const SlotBlock& block = view.blocks[i];
    Lanes3 force = {load(view.applied.x + slot), load(view.applied.y + slot), load(view.applied.z + slot)};
    if (block.regular) {
      add_regular(view, block, force);
    } else {
      add_irregular(view, block, force);
    }
    const Lanes gain = broadcast(kick) * load(view.inverse_mass + slot);
    move(view.coordinates.x + slot, view.velocities.x + slot, gain * force.x, broadcast(drift));
    move(view.coordinates.y + slot, view.velocities.y + slot, gain * force.y, broadcast(drift));
    move(view.coordinates.z + slot, view.velocities.z + slot, gain * force.z, broadcast(drift));
  }
}

}  // namespace netpocket::slot_kernel::NETPOCKET_ISA_NAME
