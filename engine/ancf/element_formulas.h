#pragma once
// Forces of a block of mean-strain elements, for the kernels. The formulas and the notation are those of
// mean_strain_element.h. Only sources that are compiled once per instruction set may include this header.

#include "engine/ancf/element_batch.h"
#include "engine/ancf/element_coordinates.h"
#include "engine/ancf/strain_pair.h"
#include "engine/math/simd.h"

namespace netpocket::simd {
namespace {

// Prevents 0/0 where a bending mode vanishes, as in mean_strain_element.cpp.
constexpr double kVanishing = kBendingRoundOff * kBendingRoundOff;

// Powers (BatchPower) of each lane.
struct PowerSimd {
  SimdDouble dissipated, fed;
};

// Chord, bending modes and axial strain of each lane.
struct Kinematics {
  SimdVector e, s, a;
  SimdDouble s_square, a_square, s_work, a_work;  // s.s, a.a, s.ds/dt, a.da/dt
  SimdDouble strain, strain_rate;
};

// Vectors at the two ends of an element: of its nodes and of its gradients.
struct Corners {
  SimdVector position1, gradient1, position2, gradient2;
};

// `kWhole`: whether all corners read runs (ElementBlock::whole).
template <bool kWhole>
NETPOCKET_INLINE Corners load_corners(const CoordinateRows& rows, const ElementBlock& block, int part) {
  if constexpr (kWhole) {
    return {load_run(rows, block, 0, part), load_run(rows, block, 1, part), load_run(rows, block, 2, part),
            load_run(rows, block, 3, part)};
  } else {
    return {load_coordinate(rows, block, 0, part), load_coordinate(rows, block, 1, part),
            load_coordinate(rows, block, 2, part), load_coordinate(rows, block, 3, part)};
  }
}

// `q`, `v`: coordinates and velocities of the block's elements.
template <bool kVariable>
NETPOCKET_INLINE Kinematics kinematics(const ElementBlock& block, int part, const Corners& q, const Corners& v) {
  Kinematics k;
  const SimdDouble inverse_length = load(block.inverse_length, part);
  k.e = inverse_length * (q.position2 - q.position1);
  k.s = q.gradient1 - q.gradient2;
  k.a = (q.gradient1 + q.gradient2) - broadcast(2.0) * k.e;

  SimdVector e_rate = inverse_length * (v.position2 - v.position1);
  // A changing L changes e = (r2 - r1)/L as well.
  if constexpr (kVariable) e_rate = e_rate - load(block.length_rate, part) * k.e;
  k.s_work = dot(k.s, v.gradient1 - v.gradient2);
  k.a_work = dot(k.a, (v.gradient1 + v.gradient2) - broadcast(2.0) * e_rate);

  // In the modes s and a, 2 h1.h1 - h1.h2 + 2 h2.h2 is (5 s.s + 3 a.a)/4. This saves operations.
  k.s_square = dot(k.s, k.s);
  k.a_square = dot(k.a, k.a);
  k.strain = broadcast(0.5) * (dot(k.e, k.e) - broadcast(1.0)) +
             (broadcast(1.0 / 24) * k.s_square + broadcast(1.0 / 40) * k.a_square);
  k.strain_rate = dot(k.e, e_rate) + (broadcast(1.0 / 12) * k.s_work + broadcast(1.0 / 20) * k.a_work);
  return k;
}

template <bool kVariable, bool kWhole>
NETPOCKET_INLINE Kinematics kinematics(const ElementBlock& block, int part, const CoordinateRows& coordinates,
                                       const CoordinateRows& velocities) {
  return kinematics<kVariable>(block, part, load_corners<kWhole>(coordinates, block, part),
                               load_corners<kWhole>(velocities, block, part));
}

// Resisting forces of each lane. The force on position2 is minus that on position1.
struct Resistance {
  SimdVector position1, gradient1, gradient2;
};

// `strain`, `strain_rate`: those that determine the tension, of the element alone or of its pair.
template <bool kVariable>
NETPOCKET_INLINE Resistance resist(const ElementBlock& block, const SectionRows& section, int part, const Kinematics& k,
                                   const SimdDouble& strain, const SimdDouble& strain_rate, PowerSimd& power) {
  const SimdDouble length = load(block.length, part);
  const SimdDouble inverse_length = load(block.inverse_length, part);
  const SimdDouble stiffness =
      strain < broadcast(0.0) ? load(section.compression_stiffness, part) : load(section.axial_stiffness, part);
  const SimdDouble viscous_tension = (stiffness * load(section.axial_damping, part)) * strain_rate;
  const SimdDouble tension = stiffness * strain + viscous_tension;

  const SimdDouble bending = load(section.bending_rigidity, part) * inverse_length;
  const SimdDouble damping = load(section.bending_damping, part);
  // Relative rates of |s| and |a|. Both quotients share one division, by far the slowest operation here.
  const SimdDouble s_guarded = k.s_square + broadcast(kVanishing), a_guarded = k.a_square + broadcast(kVanishing);
  const SimdDouble reciprocal = broadcast(1.0) / (s_guarded * a_guarded);
  const SimdDouble s_growth = damping * (k.s_work * (a_guarded * reciprocal));
  const SimdDouble a_growth = damping * (k.a_work * (s_guarded * reciprocal));
  const SimdDouble moment_s = bending * (broadcast(1.0) + s_growth);
  const SimdDouble moment_a = broadcast(3.0) * (bending * (broadcast(1.0) + a_growth));

  // dU/ds and dU/da are multiples of s and a. e enters through the strain and through a.
  const SimdDouble tension_length = tension * length;
  const SimdVector along_s = (broadcast(1.0 / 12) * tension_length + moment_s) * k.s;
  const SimdVector along_a = (broadcast(1.0 / 20) * tension_length + moment_a) * k.a;
  const SimdVector force1 = (broadcast(2.0) * inverse_length) * along_a - tension * k.e;

  const SimdDouble bending_power = bending * (s_growth * k.s_work + broadcast(3.0) * (a_growth * k.a_work));
  power.dissipated = power.dissipated + (viscous_tension * k.strain_rate * length + bending_power);
  // At fixed coordinates a longer element has a shorter e, whose conjugate is -L force1. The length also scales the
  // axial energy and, inversely, the bending energy.
  if constexpr (kVariable) {
    const SimdDouble axial = broadcast(0.5) * (stiffness * (strain * k.strain)) + dot(force1, k.e);
    const SimdDouble curvature = broadcast(0.5) * (bending * (k.s_square + broadcast(3.0) * k.a_square));
    power.fed = power.fed + load(block.length_rate, part) * (length * axial - curvature);
  }
  return {force1, along_a + along_s, along_a - along_s};
}

NETPOCKET_INLINE void store_rows(double* out, int part, const Resistance& force) {
  store3(out, 0, part, force.position1);
  store3(out, 3, part, force.gradient1);
  store3(out, 6, part, force.gradient2);
}

NETPOCKET_INLINE SimdDouble mixed(const SimdDouble& own, const SimdDouble& strain_partner) {
  return broadcast(kOwnShare) * own + broadcast(kPartnerShare) * strain_partner;
}

// Forces of the two elements of a pair.
struct PairResistance {
  Resistance first, second;
};

// `first`: the first block of a pair (Pairing::first), `second` the next one.
template <bool kVariable>
NETPOCKET_INLINE PairResistance resist_as_pair(const BatchView& batch, const ElementBlock* block, int part,
                                               const Kinematics& first, const Kinematics& second,
                                               PowerSimd& first_power, PowerSimd& second_power) {
  const SectionRows& section = batch.sections[block->section];
  return {resist<kVariable>(*block, section, part, first, mixed(first.strain, second.strain),
                            mixed(first.strain_rate, second.strain_rate), first_power),
          resist<kVariable>(block[1], section, part, second, mixed(second.strain, first.strain),
                            mixed(second.strain_rate, first.strain_rate), second_power)};
}

// Computes the block and, if it is the first of a pair, the next block as well. `next_power` is that of the next block.
template <bool kVariable, bool kWhole>
NETPOCKET_INLINE void block_forces(const BatchView& batch, const ElementBlock* block, int part,
                                   const CoordinateRows& coordinates, const CoordinateRows& velocities, double* out,
                                   PowerSimd& power, PowerSimd& next_power) {
  const SectionRows& section = batch.sections[block->section];
  const Kinematics k = kinematics<kVariable, kWhole>(*block, part, coordinates, velocities);
  if (block->pairing == Pairing::first) {
    const Kinematics next = kinematics<kVariable, kWhole>(block[1], part, coordinates, velocities);
    const PairResistance pair = resist_as_pair<kVariable>(batch, block, part, k, next, power, next_power);
    store_rows(out, part, pair.first);
    store_rows(out + kForceRows * kBlock, part, pair.second);
    return;
  }
  if constexpr (!kWhole) {
    if (block->pairing == Pairing::elsewhere) {
      const Kinematics strain_partner =
          kinematics<kVariable, false>(batch.strain_partners[block->strain_partners], part, coordinates, velocities);
      store_rows(out, part,
                 resist<kVariable>(*block, section, part, k, mixed(k.strain, strain_partner.strain),
                                   mixed(k.strain_rate, strain_partner.strain_rate), power));
      return;
    }
  }
  store_rows(out, part, resist<kVariable>(*block, section, part, k, k.strain, k.strain_rate, power));
}

// Not inline, because their code is long.
template <bool kVariable>
[[gnu::noinline]] void irregular_block_forces(const BatchView& batch, const ElementBlock* block, int part,
                                              const CoordinateRows& coordinates, const CoordinateRows& velocities,
                                              double* out, PowerSimd& power, PowerSimd& next_power) {
  block_forces<kVariable, false>(batch, block, part, coordinates, velocities, out, power, next_power);
}

template <bool kVariable>
NETPOCKET_INLINE void any_block_forces(const BatchView& batch, const ElementBlock* block, int part,
                                       const CoordinateRows& coordinates, const CoordinateRows& velocities, double* out,
                                       PowerSimd& power, PowerSimd& next_power) {
  if (block->whole) {
    block_forces<kVariable, true>(batch, block, part, coordinates, velocities, out, power, next_power);
  } else {
    irregular_block_forces<kVariable>(batch, block, part, coordinates, velocities, out, power, next_power);
  }
}

// Sum over all lanes, in their order.
NETPOCKET_INLINE BatchPower total_of(const PowerSimd (&power)[kParts]) {
  BatchPower sum;
  for (int lane = 0; lane < kBlock; ++lane) {
    sum.dissipated += power[lane / kWidth].dissipated[lane % kWidth];
    sum.fed += power[lane / kWidth].fed[lane % kWidth];
  }
  return sum;
}

}  // namespace
}  // namespace netpocket::simd
