// This file is compiled once per instruction set; NETPOCKET_ISA_NAME is the namespace of the variant. The formulas and
// the notation are those of mean_strain_element.h.

#include "engine/ancf/element_kernel.h"

#include "engine/ancf/element_coordinates.h"
#include "engine/ancf/strain_pair.h"
#include "engine/math/simd.h"

namespace netpocket::element_kernel::NETPOCKET_ISA_NAME {
namespace {

using namespace simd;

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

template <bool kVariable>
NETPOCKET_INLINE Kinematics kinematics(const ElementBlock& block, int part, const CoordinateRows& coordinates,
                                       const CoordinateRows& velocities) {
  Kinematics k;
  const SimdDouble inverse_length = load(block.inverse_length, part);
  const SimdVector r1 = load_coordinate(coordinates, block, 0, part), g1 = load_coordinate(coordinates, block, 1, part);
  const SimdVector r2 = load_coordinate(coordinates, block, 2, part), g2 = load_coordinate(coordinates, block, 3, part);
  k.e = inverse_length * (r2 - r1);
  k.s = g1 - g2;
  k.a = (g1 + g2) - broadcast(2.0) * k.e;

  const SimdVector v1 = load_coordinate(velocities, block, 0, part), w1 = load_coordinate(velocities, block, 1, part);
  const SimdVector v2 = load_coordinate(velocities, block, 2, part), w2 = load_coordinate(velocities, block, 3, part);
  SimdVector e_rate = inverse_length * (v2 - v1);
  // A changing L changes e = (r2 - r1)/L as well.
  if constexpr (kVariable) e_rate = e_rate - load(block.length_rate, part) * k.e;
  k.s_work = dot(k.s, w1 - w2);
  k.a_work = dot(k.a, (w1 + w2) - broadcast(2.0) * e_rate);

  // In the modes s and a, 2 h1.h1 - h1.h2 + 2 h2.h2 is (5 s.s + 3 a.a)/4. This saves operations.
  k.s_square = dot(k.s, k.s);
  k.a_square = dot(k.a, k.a);
  k.strain = broadcast(0.5) * (dot(k.e, k.e) - broadcast(1.0)) +
             (broadcast(1.0 / 24) * k.s_square + broadcast(1.0 / 40) * k.a_square);
  k.strain_rate = dot(k.e, e_rate) + (broadcast(1.0 / 12) * k.s_work + broadcast(1.0 / 20) * k.a_work);
  return k;
}

// `strain`, `strain_rate`: those that determine the tension, of the element alone or of its pair.
template <bool kVariable>
NETPOCKET_INLINE void resist(const ElementBlock& block, const SectionRows& section, int part, const Kinematics& k,
                             const SimdDouble& strain, const SimdDouble& strain_rate, double* out, PowerSimd& power) {
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
  store3(out, 0, part, force1);
  store3(out, 3, part, along_a + along_s);
  store3(out, 6, part, along_a - along_s);

  const SimdDouble bending_power = bending * (s_growth * k.s_work + broadcast(3.0) * (a_growth * k.a_work));
  power.dissipated = power.dissipated + (viscous_tension * k.strain_rate * length + bending_power);
  // At fixed coordinates a longer element has a shorter e, whose conjugate is -L force1. The length also scales the
  // axial energy and, inversely, the bending energy.
  if constexpr (kVariable) {
    const SimdDouble axial = broadcast(0.5) * (stiffness * (strain * k.strain)) + dot(force1, k.e);
    const SimdDouble curvature = broadcast(0.5) * (bending * (k.s_square + broadcast(3.0) * k.a_square));
    power.fed = power.fed + load(block.length_rate, part) * (length * axial - curvature);
  }
}

NETPOCKET_INLINE SimdDouble mixed(const SimdDouble& own, const SimdDouble& strain_partner) {
  return broadcast(kOwnShare) * own + broadcast(kPartnerShare) * strain_partner;
}

// Computes the block and, if it is the first of a pair, the next block as well.
template <bool kVariable>
NETPOCKET_INLINE void block_forces(const BatchView& batch, const ElementBlock* block, int part,
                                   const CoordinateRows& coordinates, const CoordinateRows& velocities, double* out,
                                   PowerSimd& power) {
  const SectionRows& section = batch.sections[block->section];
  const Kinematics k = kinematics<kVariable>(*block, part, coordinates, velocities);
  if (block->pairing == Pairing::first) {
    const Kinematics next = kinematics<kVariable>(block[1], part, coordinates, velocities);
    resist<kVariable>(*block, section, part, k, mixed(k.strain, next.strain), mixed(k.strain_rate, next.strain_rate),
                      out, power);
    resist<kVariable>(block[1], section, part, next, mixed(next.strain, k.strain),
                      mixed(next.strain_rate, k.strain_rate), out + kForceRows * kBlock, power);
  } else if (block->pairing == Pairing::elsewhere) {
    const Kinematics strain_partner =
        kinematics<kVariable>(batch.strain_partners[block->strain_partners], part, coordinates, velocities);
    resist<kVariable>(*block, section, part, k, mixed(k.strain, strain_partner.strain),
                      mixed(k.strain_rate, strain_partner.strain_rate), out, power);
  } else {
    resist<kVariable>(*block, section, part, k, k.strain, k.strain_rate, out, power);
  }
}

NETPOCKET_INLINE const ElementBlock& strain_partner_of(const BatchView& batch, const ElementBlock& block) {
  if (block.pairing == Pairing::elsewhere) return batch.strain_partners[block.strain_partners];
  return block.pairing == Pairing::first ? *(&block + 1) : *(&block - 1);
}

NETPOCKET_INLINE SimdVector chord_of(const ElementBlock& block, int part, const CoordinateRows& coordinates) {
  return load(block.inverse_length, part) *
         (load_coordinate(coordinates, block, 2, part) - load_coordinate(coordinates, block, 0, part));
}

}  // namespace

BatchPower element_forces(const BatchView& batch, int first, int last, const CoordinateRows& coordinates,
                          const CoordinateRows& velocities, double* forces) {
  PowerSimd power[kParts] = {};
  for (int i = first; i < last; ++i) {
    const ElementBlock* block = batch.blocks + i;
    if (block->pairing == Pairing::second) continue;
    double* out = forces + static_cast<std::ptrdiff_t>(i) * kForceRows * kBlock;
    for (int part = 0; part < kParts; ++part) {
      if (block->variable) {
        block_forces<true>(batch, block, part, coordinates, velocities, out, power[part]);
      } else {
        block_forces<false>(batch, block, part, coordinates, velocities, out, power[part]);
      }
    }
  }
  BatchPower sum;
  for (int lane = 0; lane < kBlock; ++lane) {
    sum.dissipated += power[lane / kWidth].dissipated[lane % kWidth];
    sum.fed += power[lane / kWidth].fed[lane % kWidth];
  }
  return sum;
}

void element_states(const BatchView& batch, int first, int last, const CoordinateRows& coordinates,
                    const CoordinateRows& velocities, double* states) {
  for (int i = first; i < last; ++i) {
    const ElementBlock& block = batch.blocks[i];
    double* out = states + static_cast<std::ptrdiff_t>(i) * kStateRows * kBlock;
    for (int part = 0; part < kParts; ++part) {
      const Kinematics k = block.variable ? kinematics<true>(block, part, coordinates, velocities)
                                          : kinematics<false>(block, part, coordinates, velocities);
      const SimdDouble stiffness =
          load(batch.sections[block.section].bending_rigidity, part) * load(block.inverse_length, part);
      store(out, part, k.strain);
      store(out + kBlock, part, k.strain_rate);
      store(out + 2 * kBlock, part, broadcast(0.5) * (stiffness * (k.s_square + broadcast(3.0) * k.a_square)));
      SimdDouble bends = broadcast(78.0 / 1800) * (broadcast(25.0) * k.s_square + broadcast(9.0) * k.a_square);
      if (block.pairing != Pairing::none) {
        const SimdVector fold = k.e - chord_of(strain_partner_of(batch, block), part, coordinates);
        bends = bends + broadcast(0.5) * dot(fold, fold);
      }
      store(out + 3 * kBlock, part, bends);
    }
  }
}

}  // namespace netpocket::element_kernel::NETPOCKET_ISA_NAME
