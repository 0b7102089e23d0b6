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

// Returns the dissipated power of each lane.
template <bool kVariable>
NETPOCKET_INLINE Lanes part_forces(const ElementBlock& block, int part, const SlotArrays& coordinates,
                                   const SlotArrays& velocities, double* out) {
  const Lanes length = load(block.length, part);
  const Lanes inverse_length = load(block.inverse_length, part);

  const Lanes3 r1 = load_slot(coordinates, block, 0, part), g1 = load_slot(coordinates, block, 1, part);
  const Lanes3 r2 = load_slot(coordinates, block, 2, part), g2 = load_slot(coordinates, block, 3, part);
  const Lanes3 e = inverse_length * (r2 - r1);
  const Lanes3 h1 = g1 - e, h2 = g2 - e;
  const Lanes3 s = h1 - h2, a = h1 + h2;

  const Lanes3 v1 = load_slot(velocities, block, 0, part), w1 = load_slot(velocities, block, 1, part);
  const Lanes3 v2 = load_slot(velocities, block, 2, part), w2 = load_slot(velocities, block, 3, part);
  const Lanes3 e_rate = inverse_length * (v2 - v1);

  // Derivatives of the mean strain: with respect to e at fixed g (the force on r2 is N times it), g1/L and g2/L.
  const Lanes3 strain_e = e - broadcast(0.1) * a;
  const Lanes3 strain_g1 = broadcast(1.0 / 30.0) * (broadcast(4.0) * h1 - h2);
  const Lanes3 strain_g2 = broadcast(1.0 / 30.0) * (broadcast(4.0) * h2 - h1);

  const Lanes bow = broadcast(2.0) * (dot(h1, h1) + dot(h2, h2)) - dot(h1, h2);
  const Lanes strain = broadcast(0.5) * (dot(e, e) + broadcast(1.0 / 15.0) * bow - broadcast(1.0));
  Lanes strain_rate = (dot(strain_e, e_rate) + dot(strain_g1, w1)) + dot(strain_g2, w2);
  Lanes3 s_rate = w1 - w2, a_rate = (w1 + w2) - broadcast(2.0) * e_rate;
  if constexpr (kVariable) {
    // e = (r2 - r1)/L also changes because L does.
    const Lanes length_rate = load(block.length_rate, part);
    strain_rate = strain_rate - length_rate * dot(strain_e, e);
    a_rate = a_rate + (broadcast(2.0) * length_rate) * e;
  }

  const Lanes stiffness =
      strain < broadcast(0.0) ? load(block.compression_stiffness, part) : load(block.axial_stiffness, part);
  const Lanes viscous_tension = (stiffness * load(block.axial_damping, part)) * strain_rate;
  const Lanes tension = stiffness * strain + viscous_tension;

  const Lanes bending = load(block.bending_stiffness, part);
  const Lanes damping = load(block.bending_damping, part);
  // Relative rates of |s| and |a|: two quotients from one division, which is by far the slowest operation here.
  const Lanes s_square = dot(s, s) + broadcast(kVanishing), a_square = dot(a, a) + broadcast(kVanishing);
  const Lanes reciprocal = broadcast(1.0) / (s_square * a_square);
  const Lanes s_work = dot(s, s_rate), a_work = dot(a, a_rate);
  const Lanes s_growth = s_work * (a_square * reciprocal), a_growth = a_work * (s_square * reciprocal);
  const Lanes3 moment_s = (bending * (broadcast(1.0) + damping * s_growth)) * s;
  const Lanes3 moment_a = (broadcast(3.0) * (bending * (broadcast(1.0) + damping * a_growth))) * a;

  const Lanes tension_length = tension * length;
  const Lanes3 force2 = tension * strain_e - (broadcast(2.0) * inverse_length) * moment_a;
  store3(out, 0, part, broadcast(-1.0) * force2);
  store3(out, 3, part, tension_length * strain_g1 + (moment_s + moment_a));
  store3(out, 6, part, tension_length * strain_g2 + (moment_a - moment_s));

  const Lanes bending_power = (bending * damping) * (s_growth * s_work + broadcast(3.0) * (a_growth * a_work));
  return viscous_tension * strain_rate * length + bending_power;
}

}  // namespace

double element_forces(const ElementBlock* blocks, const std::uint8_t* variable, int first, int last,
                      const SlotArrays& coordinates, const SlotArrays& velocities, double* forces) {
  Lanes power[kParts] = {};
  for (int i = first; i < last; ++i) {
    double* out = forces + static_cast<std::ptrdiff_t>(i) * kForceRows * kBlock;
    for (int part = 0; part < kParts; ++part) {
      power[part] = power[part] + (variable[i] ? part_forces<true>(blocks[i], part, coordinates, velocities, out)
                                               : part_forces<false>(blocks[i], part, coordinates, velocities, out));
    }
  }
  double sum = 0;
  for (int lane = 0; lane < kBlock; ++lane) sum += power[lane / kWidth][lane % kWidth];
  return sum;
}

}  // namespace netpocket::element_kernel::NETPOCKET_ISA_NAME
