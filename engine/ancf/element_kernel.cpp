// Compiled once per instruction set, NETPOCKET_ISA_NAME being the variant's namespace. The formulas are those of
// mean_strain_element.h, in the same notation.

#include "engine/ancf/element_kernel.h"

#include "engine/ancf/lanes.h"

namespace netpocket::element_kernel::NETPOCKET_ISA_NAME {
namespace {

using namespace lanes;

// Guards 0/0 where a bending mode vanishes, as in mean_strain_element.h.
constexpr double kVanishing = kBendingRoundOff * kBendingRoundOff;

NETPOCKET_INLINE Lanes load_component(const double* array, const ElementBlock& block, int corner, int part) {
  if (block.base[corner] >= 0) return load_rotated(array + block.base[corner], part, block.rotation[corner]);
  return gather(array, block.slot[corner], part);
}

NETPOCKET_INLINE Lanes3 load_slot(const SlotArrays& arrays, const ElementBlock& block, int corner, int part) {
  return {load_component(arrays.x, block, corner, part), load_component(arrays.y, block, corner, part),
          load_component(arrays.z, block, corner, part)};
}

// `row`: the first of the three force rows of a corner.
NETPOCKET_INLINE void store3(double* out, int row, int part, const Lanes3& value) {
  store(out + row * kBlock, part, value.x);
  store(out + (row + 1) * kBlock, part, value.y);
  store(out + (row + 2) * kBlock, part, value.z);
}

// Powers (BatchPower) of each lane.
struct PowerLanes {
  Lanes dissipated, fed;
};

template <bool kVariable>
NETPOCKET_INLINE void part_forces(const ElementBlock& block, const SectionRows& section, int part,
                                  const SlotArrays& coordinates, const SlotArrays& velocities, double* out,
                                  PowerLanes& power) {
  const Lanes length = load(block.length, part);
  const Lanes inverse_length = load(block.inverse_length, part);

  const Lanes3 r1 = load_slot(coordinates, block, 0, part), g1 = load_slot(coordinates, block, 1, part);
  const Lanes3 r2 = load_slot(coordinates, block, 2, part), g2 = load_slot(coordinates, block, 3, part);
  const Lanes3 e = inverse_length * (r2 - r1);
  const Lanes3 s = g1 - g2, a = (g1 + g2) - broadcast(2.0) * e;

  const Lanes3 v1 = load_slot(velocities, block, 0, part), w1 = load_slot(velocities, block, 1, part);
  const Lanes3 v2 = load_slot(velocities, block, 2, part), w2 = load_slot(velocities, block, 3, part);
  Lanes3 e_rate = inverse_length * (v2 - v1);
  // e = (r2 - r1)/L also changes because L does.
  if constexpr (kVariable) e_rate = e_rate - load(block.length_rate, part) * e;
  const Lanes3 s_rate = w1 - w2, a_rate = (w1 + w2) - broadcast(2.0) * e_rate;

  // In the modes s and a the bow 2 h1.h1 - h1.h2 + 2 h2.h2 is (5 s.s + 3 a.a)/4: few operations for strain and rate.
  const Lanes s_square = dot(s, s), a_square = dot(a, a);
  const Lanes s_work = dot(s, s_rate), a_work = dot(a, a_rate);
  const Lanes strain =
      broadcast(0.5) * (dot(e, e) - broadcast(1.0)) + (broadcast(1.0 / 24) * s_square + broadcast(1.0 / 40) * a_square);
  const Lanes strain_rate = dot(e, e_rate) + (broadcast(1.0 / 12) * s_work + broadcast(1.0 / 20) * a_work);

  const Lanes stiffness =
      strain < broadcast(0.0) ? load(section.compression_stiffness, part) : load(section.axial_stiffness, part);
  const Lanes viscous_tension = (stiffness * load(section.axial_damping, part)) * strain_rate;
  const Lanes tension = stiffness * strain + viscous_tension;

  const Lanes bending = load(section.bending_rigidity, part) * inverse_length;
  const Lanes damping = load(section.bending_damping, part);
  // Relative rates of |s| and |a|: two quotients from one division, which is by far the slowest operation here.
  const Lanes s_guarded = s_square + broadcast(kVanishing), a_guarded = a_square + broadcast(kVanishing);
  const Lanes reciprocal = broadcast(1.0) / (s_guarded * a_guarded);
  const Lanes s_growth = damping * (s_work * (a_guarded * reciprocal));
  const Lanes a_growth = damping * (a_work * (s_guarded * reciprocal));
  const Lanes moment_s = bending * (broadcast(1.0) + s_growth);
  const Lanes moment_a = broadcast(3.0) * (bending * (broadcast(1.0) + a_growth));

  // dU/ds and dU/da are multiples of s and a; e takes part in the strain and in a.
  const Lanes tension_length = tension * length;
  const Lanes3 along_s = (broadcast(1.0 / 12) * tension_length + moment_s) * s;
  const Lanes3 along_a = (broadcast(1.0 / 20) * tension_length + moment_a) * a;
  const Lanes3 force1 = (broadcast(2.0) * inverse_length) * along_a - tension * e;
  store3(out, 0, part, force1);
  store3(out, 3, part, along_a + along_s);
  store3(out, 6, part, along_a - along_s);

  const Lanes bending_power = bending * (s_growth * s_work + broadcast(3.0) * (a_growth * a_work));
  power.dissipated = power.dissipated + (viscous_tension * strain_rate * length + bending_power);
  // At fixed coordinates a longer element has a shorter e, whose conjugate is -L force1; and the energy per length is
  // spread over, and the curvature taken from, another length.
  if constexpr (kVariable) {
    const Lanes axial = broadcast(0.5) * (stiffness * (strain * strain)) + dot(force1, e);
    const Lanes curvature = broadcast(0.5) * (bending * (s_square + broadcast(3.0) * a_square));
    power.fed = power.fed + load(block.length_rate, part) * (length * axial - curvature);
  }
}

}  // namespace

BatchPower element_forces(const BatchView& batch, int first, int last, const SlotArrays& coordinates,
                          const SlotArrays& velocities, double* forces) {
  PowerLanes power[kParts] = {};
  for (int i = first; i < last; ++i) {
    const ElementBlock& block = batch.blocks[i];
    const SectionRows& section = batch.sections[block.section];
    double* out = forces + static_cast<std::ptrdiff_t>(i) * kForceRows * kBlock;
    for (int part = 0; part < kParts; ++part) {
      if (block.variable) {
        part_forces<true>(block, section, part, coordinates, velocities, out, power[part]);
      } else {
        part_forces<false>(block, section, part, coordinates, velocities, out, power[part]);
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

}  // namespace netpocket::element_kernel::NETPOCKET_ISA_NAME
