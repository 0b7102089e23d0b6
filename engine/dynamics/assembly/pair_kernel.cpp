// Compiled once per instruction set; NETPOCKET_ISA_NAME is the variant's namespace.

#include "engine/dynamics/assembly/pair_kernel.h"

#include "engine/ancf/element_formulas.h"
#include "engine/dynamics/assembly/move_block.h"
#include "engine/math/simd.h"

namespace netpocket::pair_kernel::NETPOCKET_ISA_NAME {
namespace {

using namespace simd;
using update_kernel::UpdateView;

struct Largest {
  LargestSquare position, gradient;
};

NETPOCKET_INLINE SimdVector load3(const double* rows, int part) {
  return {load(rows, part), load(rows + kBlock, part), load(rows + 2 * kBlock, part)};
}

NETPOCKET_INLINE void add_known(const PairView& view, int block, int part, PowerSimd& power) {
  const double* rows = view.powers + static_cast<std::ptrdiff_t>(block) * kPowerRows * kBlock;
  power.dissipated = power.dissipated + load(rows, part);
  power.fed = power.fed + load(rows + kBlock, part);
}

NETPOCKET_INLINE void store_power(const PairView& view, int block, int part, const PowerSimd& power) {
  double* rows = view.powers + static_cast<std::ptrdiff_t>(block) * kPowerRows * kBlock;
  store(rows, part, power.dissipated);
  store(rows + kBlock, part, power.fed);
}

// Vectors at the ends of the first and of the second element of a pair, of which `node` and `slope` are in the middle.
NETPOCKET_INLINE Corners first_corners(const double* all, const ElementBlock& block, const double* node,
                                       const double* slope, int part) {
  return {load_run({all}, block, 0, part), load_run({all}, block, 1, part), load3(node, part), load3(slope, part)};
}
NETPOCKET_INLINE Corners second_corners(const double* all, const ElementBlock& block, const double* node,
                                        const double* slope, int part) {
  return {load3(node, part), load3(slope, part), load_run({all}, block, 2, part), load_run({all}, block, 3, part)};
}

// Sums in the order of update_kernel.h: the first element, then the second.
template <bool kVariable>
NETPOCKET_INLINE void move_middle(const PairView& view, const UpdateView& motion, int first, int part, double kick,
                                  double drift, PowerSimd& power, Largest& largest) {
  const ElementBlock* block = view.batch.blocks + first;
  const PairMiddle middle = view.middles[first];
  const std::ptrdiff_t position = static_cast<std::ptrdiff_t>(middle.position) * kBlock,
                       gradient = static_cast<std::ptrdiff_t>(middle.gradient) * kBlock;
  double *x = motion.coordinates + position * kVectorRows, *x_gradient = motion.coordinates + gradient * kVectorRows;
  double *v = motion.velocities + position * kVectorRows, *v_gradient = motion.velocities + gradient * kVectorRows;

  const Corners q_one = first_corners(motion.coordinates, *block, x, x_gradient, part);
  const Corners v_one = first_corners(motion.velocities, *block, v, v_gradient, part);
  const Kinematics one = kinematics<kVariable>(*block, part, q_one, v_one);
  const Corners q_other = second_corners(motion.coordinates, block[1], x, x_gradient, part);
  const Corners v_other = second_corners(motion.velocities, block[1], v, v_gradient, part);
  const Kinematics other = kinematics<kVariable>(block[1], part, q_other, v_other);
  const PairResistance pair = resist_as_pair<kVariable>(view.batch, block, part, one, other, power, power);
  double* out = view.element_forces + static_cast<std::ptrdiff_t>(first) * kForceRows * kBlock;
  store3(out, 0, part, pair.first.position1);
  store3(out, 3, part, pair.first.gradient1);
  store3(out + kForceRows * kBlock, 0, part, pair.second.position1);
  store3(out + kForceRows * kBlock, 6, part, pair.second.gradient2);

  const SimdVector force =
      (applied_force(motion, middle.position, part) + pair.first.position1) - pair.second.position1;
  const SimdVector moment =
      (applied_force(motion, middle.gradient, part) - pair.first.gradient2) - pair.second.gradient1;
  const SimdDouble square =
      move(x, v, part, broadcast(kick) * load(motion.inverse_mass + position, part), force, broadcast(drift));
  note(largest.position, square);
  const SimdDouble gradient_square =
      move(x_gradient, v_gradient, part, broadcast(kick) * load(motion.inverse_mass + gradient, part), moment,
           broadcast(drift));
  note_weighted(largest.gradient, load(motion.weight + gradient, part), gradient_square);
}

template <bool kVariable>
NETPOCKET_INLINE void move_or_store(const PairView& view, const UpdateView& motion, int block, int part, double kick,
                                    double drift, PowerSimd& power, Largest& largest) {
  if (view.middles[block].position >= 0) {
    move_middle<kVariable>(view, motion, block, part, kick, drift, power, largest);
  } else {
    any_block_forces<kVariable>(view.batch, view.batch.blocks + block, part, {motion.coordinates}, {motion.velocities},
                                view.element_forces + static_cast<std::ptrdiff_t>(block) * kForceRows * kBlock, power,
                                power);
  }
}

}  // namespace

PairSums move(const PairView& view, const UpdateView& motion, int first, int last, double kick, double drift) {
  PowerSimd power[kParts] = {};
  Largest largest;
  for (int i = first; i < last; ++i) {
    const ElementBlock& block = view.batch.blocks[i];
    if (block.pairing == Pairing::second) continue;
    if (view.known[i] != 0) {
      for (int part = 0; part < kParts; ++part) {
        add_known(view, i, part, power[part]);
        if (block.pairing == Pairing::first) add_known(view, i + 1, part, power[part]);
      }
      continue;
    }
    for (int part = 0; part < kParts; ++part) {
      if (block.variable) {
        move_or_store<true>(view, motion, i, part, kick, drift, power[part], largest);
      } else {
        move_or_store<false>(view, motion, i, part, kick, drift, power[part], largest);
      }
    }
  }
  return {total_of(power), {value(largest.position), value(largest.gradient)}};
}

void forces(const PairView& view, const CoordinateRows& coordinates, const CoordinateRows& velocities,
            const std::int32_t* element_blocks, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::int32_t first = element_blocks[i];
    const ElementBlock* block = view.batch.blocks + first;
    double* out = view.element_forces + static_cast<std::ptrdiff_t>(first) * kForceRows * kBlock;
    for (int part = 0; part < kParts; ++part) {
      PowerSimd power = {}, next_power = {};
      if (block->variable) {
        any_block_forces<true>(view.batch, block, part, coordinates, velocities, out, power, next_power);
      } else {
        any_block_forces<false>(view.batch, block, part, coordinates, velocities, out, power, next_power);
      }
      store_power(view, first, part, power);
      if (block->pairing == Pairing::first) store_power(view, first + 1, part, next_power);
    }
  }
}

}  // namespace netpocket::pair_kernel::NETPOCKET_ISA_NAME
