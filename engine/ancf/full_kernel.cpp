// Compiled once per instruction set, NETPOCKET_ISA_NAME being the variant's namespace. The formulas are those of
// full_element.cpp and strain_measure.cpp for the Green strain, in element units: with the chord slope
// e = (r2 - r1)/L the slope and bend at a point are
//   a = r' = ce e + c1 g1 + c2 g2          B = L r'' = de e + d1 g1 + d2 g2
// with weights that depend on xi only, and K = L^2 kappa^2 = |a x B|^2 (a.a)^-3.

#include "engine/ancf/full_kernel.h"

#include "engine/ancf/element_slots.h"
#include "engine/ancf/lanes.h"
#include "engine/ancf/quadrature.h"

namespace netpocket::full_kernel::NETPOCKET_ISA_NAME {
namespace {

using namespace lanes;

constexpr double kVanishing = kBendingRoundOff * kBendingRoundOff;
constexpr double kSmallestSquare = 0.81;  // FullElementOptions::smallest_stretch squared

// Weights of e, g1 and g2 in a vector at a point of the element.
struct Weights {
  double e, g1, g2;
};
constexpr Weights slope_weights(double xi) {
  return {1.5 * (1 - xi * xi), 0.25 * (xi - 1) * (3 * xi + 1), 0.25 * (xi + 1) * (3 * xi - 1)};
}
constexpr Weights bend_weights(double xi) { return {-6 * xi, 3 * xi - 1, 3 * xi + 1}; }

// Values of e, g1 and g2 in each lane, or anything conjugate to them.
struct Shape {
  Lanes3 e, g1, g2;
};

NETPOCKET_INLINE Lanes3 combine(const Weights& w, const Shape& q) {
  return (broadcast(w.e) * q.e + broadcast(w.g1) * q.g1) + broadcast(w.g2) * q.g2;
}
NETPOCKET_INLINE void add(Shape& force, const Weights& w, const Lanes3& density) {
  force.e = force.e + broadcast(w.e) * density;
  force.g1 = force.g1 + broadcast(w.g1) * density;
  force.g2 = force.g2 + broadcast(w.g2) * density;
}
NETPOCKET_INLINE Lanes3 cross(const Lanes3& a, const Lanes3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
NETPOCKET_INLINE Lanes larger(const Lanes& a, const Lanes& b) { return a < b ? b : a; }

// What the kernel knows of the elements of one part of a block.
struct Section {
  Lanes stiffness, compression_stiffness, axial_damping, bending_damping;
  Lanes length_rate, start_rate;  // of the material, in element lengths per second
};

// Rates of a and B at a material point because material moves through the element and its length changes.
NETPOCKET_INLINE Lanes xi_rate(const Section& section, double xi) {
  return broadcast(-2.0) * section.start_rate - broadcast(1 + xi) * section.length_rate;
}
NETPOCKET_INLINE Lanes3 convected_slope(const Section& section, double xi, const Shape& q, const Lanes3& bend) {
  return (broadcast(0.5) * xi_rate(section, xi)) * bend - (section.length_rate * broadcast(slope_weights(xi).e)) * q.e;
}
NETPOCKET_INLINE Lanes3 convected_bend(const Section& section, double xi, const Shape& q, const Lanes3& bend) {
  const Lanes3 third = combine({-6, 3, 3}, q);
  return xi_rate(section, xi) * third - section.length_rate * (bend + broadcast(bend_weights(xi).e) * q.e);
}

// Sums over the points of an element, each in the units its function says.
struct Sums {
  Shape force;
  Lanes dissipated, fed;
};

// Adds the axial force and powers of a point, without the factor L/2.
template <bool kVariable>
NETPOCKET_INLINE void axial_point(const QuadraturePoint& point, const Section& section, const Shape& q,
                                  const Shape& velocity, Sums& sums) {
  const Weights weights = slope_weights(point.xi);
  const Lanes3 a = combine(weights, q);
  Lanes3 flow{}, a_rate = combine(weights, velocity);
  if constexpr (kVariable) {
    flow = convected_slope(section, point.xi, q, combine(bend_weights(point.xi), q));
    a_rate = a_rate + flow;
  }
  const Lanes strain = broadcast(0.5) * (dot(a, a) - broadcast(1.0));
  const Lanes strain_rate = dot(a, a_rate);
  const Lanes stiffness =
      broadcast(point.weight) * (strain < broadcast(0.0) ? section.compression_stiffness : section.stiffness);
  const Lanes elastic = stiffness * strain, viscous = (stiffness * section.axial_damping) * strain_rate;
  add(sums.force, weights, (elastic + viscous) * a);
  sums.dissipated = sums.dissipated + viscous * strain_rate;
  // A longer element has a shorter e at fixed coordinates; damping also works on the flow.
  if constexpr (kVariable) {
    const Lanes lengthening = broadcast(0.5) * strain - broadcast(weights.e) * dot(a, q.e);
    sums.fed = sums.fed + (viscous * dot(a, flow) + section.length_rate * (elastic * lengthening));
  }
}

// The same for bending, without the factor EI/(4 L).
template <bool kVariable>
NETPOCKET_INLINE void bending_point(const QuadraturePoint& point, const Section& section, const Shape& q,
                                    const Shape& velocity, Sums& sums) {
  const Weights slope = slope_weights(point.xi), bend = bend_weights(point.xi);
  const Lanes3 a = combine(slope, q), B = combine(bend, q);
  Lanes3 a_flow{}, B_flow{}, a_rate = combine(slope, velocity), B_rate = combine(bend, velocity);
  if constexpr (kVariable) {
    a_flow = convected_slope(section, point.xi, q, B);
    B_flow = convected_bend(section, point.xi, q, B);
    a_rate = a_rate + a_flow;
    B_rate = B_rate + B_flow;
  }
  const Lanes3 w = cross(a, B);
  const Lanes A = dot(a, a), G = dot(w, w);

  // (a.a)^-3, where the cord is gathered its Taylor polynomial about A0 and the share of B.B; and the reciprocal of K.
  // Two quotients from one division, which is by far the slowest operation here.
  const Lanes A0 = larger(A, broadcast(kSmallestSquare)), step = A - A0;
  const Lanes A0_2 = A0 * A0, step_2 = step * step;
  const Lanes polynomial = (A0_2 - broadcast(3.0) * (step * A0)) + broadcast(6.0) * step_2;
  const Lanes spread_polynomial = broadcast(-6.0) * (step_2 * step), BB = dot(B, B);
  const Lanes A0_5 = A0_2 * (A0_2 * A0);
  const Lanes scaled_K = (G * polynomial + BB * spread_polynomial) + broadcast(kVanishing) * A0_5;  // (K + ...) A0^5
  const Lanes quotient = broadcast(1.0) / (A0 * scaled_K);
  const Lanes reciprocal = scaled_K * quotient, reciprocal_2 = reciprocal * reciprocal;  // 1/A0
  const Lanes reciprocal_4 = reciprocal_2 * reciprocal_2, reciprocal_5 = reciprocal_4 * reciprocal;
  const Lanes power = reciprocal_5 * polynomial, spread = reciprocal_5 * spread_polynomial;
  const Lanes power_slope = broadcast(-3.0) * (reciprocal_4 * (broadcast(1.0) - broadcast(4.0) * (step * reciprocal)));
  const Lanes spread_slope = broadcast(-18.0) * (reciprocal_5 * step_2);

  // Derivatives of K by a and B, halved.
  const Lanes3 K_a = power * cross(B, w) + (G * power_slope + BB * spread_slope) * a;
  const Lanes3 K_B = power * cross(w, a) + spread * B;
  const Lanes half_rate = dot(K_a, a_rate) + dot(K_B, B_rate);
  const Lanes growth = section.bending_damping * ((half_rate * (A0 * quotient)) * A0_5);  // c d(kappa)/dt / kappa
  const Lanes elastic = broadcast(2 * point.weight), viscous = elastic * growth;
  add(sums.force, slope, (elastic + viscous) * K_a);
  add(sums.force, bend, (elastic + viscous) * K_B);
  sums.dissipated = sums.dissipated + viscous * half_rate;
  if constexpr (kVariable) {
    const Lanes lengthening = (broadcast(slope.e) * dot(K_a, q.e) + broadcast(bend.e) * dot(K_B, q.e)) +
                              broadcast(0.5) * (G * power + BB * spread);
    sums.fed =
        sums.fed + (viscous * (dot(K_a, a_flow) + dot(K_B, B_flow)) - section.length_rate * (elastic * lengthening));
  }
}

NETPOCKET_INLINE Shape load_shape(const SlotArrays& arrays, const ElementBlock& block, const Lanes& inverse_length,
                                  int part) {
  const Lanes3 r1 = load_slot(arrays, block, 0, part), r2 = load_slot(arrays, block, 2, part);
  return {inverse_length * (r2 - r1), load_slot(arrays, block, 1, part), load_slot(arrays, block, 3, part)};
}

// Powers (BatchPower) of each lane.
struct PowerLanes {
  Lanes dissipated, fed;
};

template <bool kVariable>
NETPOCKET_INLINE void part_forces(const ElementBlock& block, const SectionRows& rows, const double* start_rates,
                                  int part, const SlotArrays& coordinates, const SlotArrays& velocities, double* out,
                                  PowerLanes& power) {
  const Lanes length = load(block.length, part), inverse_length = load(block.inverse_length, part);
  const Shape q = load_shape(coordinates, block, inverse_length, part);
  const Shape velocity = load_shape(velocities, block, inverse_length, part);
  Section section = {load(rows.axial_stiffness, part),
                     load(rows.compression_stiffness, part),
                     load(rows.axial_damping, part),
                     load(rows.bending_damping, part),
                     Lanes{},
                     Lanes{}};
  if constexpr (kVariable) {
    section.length_rate = load(block.length_rate, part);
    section.start_rate = inverse_length * load(start_rates, part);
  }

  Sums axial{}, bending{};
#pragma GCC unroll 5
  for (int i = 0; i < 5; ++i) axial_point<kVariable>(kGauss5[i], section, q, velocity, axial);
#pragma GCC unroll 3
  for (int i = 0; i < 3; ++i) bending_point<kVariable>(kGauss3[i], section, q, velocity, bending);

  const Lanes half = broadcast(0.5) * length;
  const Lanes quarter = broadcast(0.25) * (load(rows.bending_rigidity, part) * inverse_length);
  store3(out, 0, part, (broadcast(-1.0) * inverse_length) * (half * axial.force.e + quarter * bending.force.e));
  store3(out, 3, part, half * axial.force.g1 + quarter * bending.force.g1);
  store3(out, 6, part, half * axial.force.g2 + quarter * bending.force.g2);
  power.dissipated = power.dissipated + (half * axial.dissipated + quarter * bending.dissipated);
  if constexpr (kVariable) power.fed = power.fed + (half * axial.fed + quarter * bending.fed);
}

}  // namespace

BatchPower element_forces(const BatchView& batch, const StartRates* start_rates, int first, int last,
                          const SlotArrays& coordinates, const SlotArrays& velocities, double* forces) {
  PowerLanes power[kParts] = {};
  for (int i = first; i < last; ++i) {
    const ElementBlock& block = batch.blocks[i];
    const SectionRows& section = batch.sections[block.section];
    double* out = forces + static_cast<std::ptrdiff_t>(i) * kForceRows * kBlock;
    for (int part = 0; part < kParts; ++part) {
      if (block.variable) {
        part_forces<true>(block, section, start_rates[i].value, part, coordinates, velocities, out, power[part]);
      } else {
        part_forces<false>(block, section, start_rates[i].value, part, coordinates, velocities, out, power[part]);
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

}  // namespace netpocket::full_kernel::NETPOCKET_ISA_NAME
