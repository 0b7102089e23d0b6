// This file is compiled once per instruction set; NETPOCKET_ISA_NAME is the namespace of the variant. The formulas are
// those of full_element.cpp and strain_measure.cpp for the Green strain, in element units and in modes. With the chord
// slope e = (r2 - r1)/L, s = (g2 - g1)/2 and h = (g1 + g2)/2 - e, the slope and the bend at a point are
//   a = r' = e + xi s + P2(xi) h          B = L r'' = 2 da/dxi = 2 s + 6 xi h          P2 = (3 xi^2 - 1)/2
// The contribution of a point needs only
//   a.a, B.B and their rates: polynomials in xi whose coefficients are products of the modes;
//   w = a x B = 2 e x s + 6 xi e x h + (3 xi^2 + 1) s x h: the only vector at the point.
// The forces on the modes follow from moments: sums over the points of stresses times powers of xi and P2. Points come
// in pairs +-xi, which share the terms that are even and odd in xi.

#include "engine/ancf/full_kernel.h"

#include "engine/ancf/element_coordinates.h"
#include "engine/ancf/quadrature.h"
#include "engine/math/simd.h"

namespace netpocket::full_kernel::NETPOCKET_ISA_NAME {
namespace {

using namespace simd;

constexpr double kVanishing = kBendingRoundOff * kBendingRoundOff;
constexpr double kSmallestSquare = 0.81;  // FullElementOptions::smallest_stretch squared

NETPOCKET_INLINE SimdVector scaled(double factor, const SimdVector& a) { return broadcast(factor) * a; }

// Modes of the slope, or quantities conjugate to them.
struct Modes {
  SimdVector e, s, h;
};
NETPOCKET_INLINE SimdDouble dot(const Modes& a, const Modes& b) {
  return (simd::dot(a.e, b.e) + simd::dot(a.s, b.s)) + simd::dot(a.h, b.h);
}

// A value at the points xi and -xi.
struct Pair {
  SimdDouble plus, minus;
};
NETPOCKET_INLINE Pair pair_of(const SimdDouble& even, const SimdDouble& odd) { return {even + odd, even - odd}; }

constexpr double legendre(double xi) { return (3 * xi * xi - 1) / 2; }

// Product of two slopes along the element, as coefficients of the modes. It also gives the product of their bends.
struct Product {
  SimdDouble ee, es, eh, ss, sh, hh;

  NETPOCKET_INLINE SimdDouble even(const Product& p, double xi) {
    const double P2 = legendre(xi);
    return (p.ee + broadcast(P2) * p.eh) + (broadcast(xi * xi) * p.ss + broadcast(P2 * P2) * p.hh);
  }
  NETPOCKET_INLINE Pair slopes(const Product& p, double xi) {
    return pair_of(even(p, xi), broadcast(xi) * (p.es + broadcast(legendre(xi)) * p.sh));
  }
  NETPOCKET_INLINE Pair bends(const Product& p, double xi) {
    return pair_of(broadcast(4.0) * p.ss + broadcast(36 * xi * xi) * p.hh, broadcast(12 * xi) * p.sh);
  }
};
NETPOCKET_INLINE Product square(const Modes& a) {
  const SimdDouble two = broadcast(2.0);
  return {simd::dot(a.e, a.e), two * simd::dot(a.e, a.s), two * simd::dot(a.e, a.h),
          simd::dot(a.s, a.s), two * simd::dot(a.s, a.h), simd::dot(a.h, a.h)};
}
NETPOCKET_INLINE Product product(const Modes& a, const Modes& b) {
  return {simd::dot(a.e, b.e), simd::dot(a.e, b.s) + simd::dot(a.s, b.e), simd::dot(a.e, b.h) + simd::dot(a.h, b.e),
          simd::dot(a.s, b.s), simd::dot(a.s, b.h) + simd::dot(a.h, b.s), simd::dot(a.h, b.h)};
}

// Products of the modes that make up w = a x B, or its rate.
struct Twist {
  SimdVector es, eh, sh;
};
struct Pair3 {
  SimdVector plus, minus;
};
NETPOCKET_INLINE SimdVector even(const Twist& t, double xi) {
  return scaled(2.0, t.es) + scaled(3 * xi * xi + 1, t.sh);
}
NETPOCKET_INLINE Pair3 at(const Twist& t, double xi) {
  const SimdVector middle = even(t, xi), odd = scaled(6 * xi, t.eh);
  return {middle + odd, middle - odd};
}

// Sums over the points of an element: stresses on a.a (and B.B) times products of 1, xi and P2; and stresses on w.w
// times w and the factors of its parts.
struct Moments {
  SimdDouble ee, es, eh, ss, sh, hh;
  Twist w;
};
NETPOCKET_INLINE void add_slopes(Moments& m, double xi, const Pair& stress) {
  const double P2 = legendre(xi);
  const SimdDouble sum = stress.plus + stress.minus, difference = broadcast(xi) * (stress.plus - stress.minus);
  const SimdDouble sum_P2 = broadcast(P2) * sum;
  m.ee = m.ee + sum;
  m.es = m.es + difference;
  m.eh = m.eh + sum_P2;
  m.ss = m.ss + broadcast(xi * xi) * sum;
  m.sh = m.sh + broadcast(P2) * difference;
  m.hh = m.hh + broadcast(P2) * sum_P2;
}
NETPOCKET_INLINE void add_middle_slope(Moments& m, const SimdDouble& stress) {
  m.ee = m.ee + stress;
  m.eh = m.eh - broadcast(0.5) * stress;
  m.hh = m.hh + broadcast(0.25) * stress;
}
NETPOCKET_INLINE void add_bends(Moments& m, double xi, const Pair& stress, const SimdDouble& middle) {
  const SimdDouble sum = stress.plus + stress.minus;
  m.ss = m.ss + broadcast(4.0) * (sum + middle);
  m.sh = m.sh + broadcast(12 * xi) * (stress.plus - stress.minus);
  m.hh = m.hh + broadcast(36 * xi * xi) * sum;
}
NETPOCKET_INLINE void add_twists(Moments& m, double xi, const Pair& stress, const SimdDouble& middle_stress,
                                 const Pair3& w, const SimdVector& middle) {
  const SimdVector plus = stress.plus * w.plus, minus = stress.minus * w.minus, at_middle = middle_stress * middle;
  const SimdVector sum = plus + minus;
  m.w.es = m.w.es + scaled(2.0, sum + at_middle);
  m.w.eh = m.w.eh + scaled(6 * xi, plus - minus);
  m.w.sh = m.w.sh + (scaled(3 * xi * xi + 1, sum) + at_middle);
}

NETPOCKET_INLINE Modes forces(const Moments& m, const Modes& q) {
  return {(m.ee * q.e + m.es * q.s + m.eh * q.h) + (cross(q.s, m.w.es) + cross(q.h, m.w.eh)),
          (m.es * q.e + m.ss * q.s + m.sh * q.h) + (cross(m.w.es, q.e) + cross(q.h, m.w.sh)),
          (m.eh * q.e + m.sh * q.s + m.hh * q.h) + (cross(m.w.eh, q.e) + cross(m.w.sh, q.s))};
}

// Section properties of the elements of one part of a block. Stiffnesses are those of the whole element: EA L/2 and
// EI/(4 L).
struct Section {
  SimdDouble stiffness, compression_stiffness, axial_damping, bending_stiffness, bending_damping;
};

// Moments of all points. Elastic and viscous moments are kept apart only for elements of variable length, whose feeding
// power needs them; otherwise `elastic` holds both.
template <bool kApart>
struct Sums {
  Moments elastic, viscous;
  SimdDouble dissipated;
  SimdDouble growth;  // L d(energy)/dL at fixed modes; only if kept apart
};

// Stress at one point: conjugate to a.a/2 for stretching, to K/2 (Curvature) for bending.
struct Stress {
  SimdDouble elastic, viscous;
};
template <bool kApart>
NETPOCKET_INLINE Stress axial_stress(double weight, const Section& section, const SimdDouble& square,
                                     const SimdDouble& half_rate, Sums<kApart>& sums) {
  const SimdDouble strain = broadcast(0.5) * (square - broadcast(1.0));
  const SimdDouble stiffness =
      broadcast(weight) * (strain < broadcast(0.0) ? section.compression_stiffness : section.stiffness);
  const SimdDouble elastic = stiffness * strain, viscous = (stiffness * section.axial_damping) * half_rate;
  sums.dissipated = sums.dissipated + viscous * half_rate;
  if constexpr (kApart) sums.growth = sums.growth + broadcast(0.5) * (elastic * strain);
  return {elastic, viscous};
}

template <bool kApart>
NETPOCKET_INLINE void add_axial(const Section& section, const Product& square, const Product& rate,
                                Sums<kApart>& sums) {
  const auto middle = axial_stress(kGauss5[2].weight, section, Product::even(square, 0), Product::even(rate, 0), sums);
  if constexpr (kApart) add_middle_slope(sums.viscous, middle.viscous);
  add_middle_slope(sums.elastic, kApart ? middle.elastic : middle.elastic + middle.viscous);
#pragma GCC unroll 2
  for (int i = 3; i < 5; ++i) {
    const double xi = kGauss5[i].xi, weight = kGauss5[i].weight;
    const Pair A = Product::slopes(square, xi), A_rate = Product::slopes(rate, xi);
    const Stress plus = axial_stress(weight, section, A.plus, A_rate.plus, sums);
    const Stress minus = axial_stress(weight, section, A.minus, A_rate.minus, sums);
    if constexpr (kApart) {
      add_slopes(sums.elastic, xi, {plus.elastic, minus.elastic});
      add_slopes(sums.viscous, xi, {plus.viscous, minus.viscous});
    } else {
      add_slopes(sums.elastic, xi, {plus.elastic + plus.viscous, minus.elastic + minus.viscous});
    }
  }
}

// Three reciprocals from one division, by far the slowest operation here.
struct Three {
  SimdDouble first, second, third;
};
NETPOCKET_INLINE Three reciprocals(const SimdDouble& a, const SimdDouble& b, const SimdDouble& c) {
  const SimdDouble ab = a * b, all = broadcast(1.0) / (ab * c), of_ab = all * c;
  return {of_ab * b, of_ab * a, all * ab};
}

// K = L^2 kappa^2 = power G + spread B.B at one point, with its derivatives by a.a.
struct Curvature {
  SimdDouble power, spread, square_slope;  // dK/dG, dK/d(B.B), dK/d(a.a)
  SimdDouble value, half_rate;
};
NETPOCKET_INLINE Curvature curvature(const SimdDouble& A, const SimdDouble& A0, const SimdDouble& inverse_A0,
                                     const SimdDouble& half_A_rate, const SimdVector& w, const SimdVector& w_rate,
                                     const SimdDouble& BB, const SimdDouble& half_BB_rate) {
  const SimdDouble y = (A - A0) * inverse_A0, y_2 = y * y;  // y = 0 unless |a| < smallest_stretch
  const SimdDouble inverse_2 = inverse_A0 * inverse_A0, inverse_3 = inverse_2 * inverse_A0;
  const SimdDouble G = simd::dot(w, w);
  Curvature k;
  k.power = inverse_3 * ((broadcast(1.0) - broadcast(3.0) * y) + broadcast(6.0) * y_2);
  k.spread = broadcast(-6.0) * (inverse_2 * (y_2 * y));
  k.square_slope = (inverse_2 * inverse_2) * (G * (broadcast(12.0) * y - broadcast(3.0))) -
                   broadcast(18.0) * ((inverse_3 * y_2) * BB);
  k.value = k.power * G + k.spread * BB;
  k.half_rate = (k.power * simd::dot(w, w_rate) + k.spread * half_BB_rate) + k.square_slope * half_A_rate;
  return k;
}

template <bool kApart>
NETPOCKET_INLINE Stress bending_stress(double weight, const Section& section, const Curvature& k,
                                       const SimdDouble& inverse_K, Sums<kApart>& sums) {
  const SimdDouble elastic = broadcast(2 * weight) * section.bending_stiffness;
  const SimdDouble growth = section.bending_damping * (k.half_rate * inverse_K);  // c d(kappa)/dt / kappa
  const SimdDouble viscous = elastic * growth;
  sums.dissipated = sums.dissipated + viscous * k.half_rate;
  if constexpr (kApart) sums.growth = sums.growth - broadcast(0.5) * (elastic * k.value);
  return {elastic, viscous};
}

template <bool kApart>
NETPOCKET_INLINE void add_bending(const Section& section, const Product& square, const Product& rate,
                                  const Twist& twist, const Twist& twist_rate, Sums<kApart>& sums) {
  constexpr double xi = kGauss3[2].xi;
  const Pair A = Product::slopes(square, xi), A_rate = Product::slopes(rate, xi);
  const Pair BB = Product::bends(square, xi), BB_rate = Product::bends(rate, xi);
  const Pair3 w = at(twist, xi), w_rate = at(twist_rate, xi);
  const SimdDouble A_middle = Product::even(square, 0);
  const SimdVector w_middle = even(twist, 0);
  const SimdDouble least = broadcast(kSmallestSquare);
  const SimdDouble A0_plus = larger(A.plus, least), A0_minus = larger(A.minus, least),
                   A0_middle = larger(A_middle, least);
  const Three inverse_A0 = reciprocals(A0_plus, A0_minus, A0_middle);
  const Curvature plus =
      curvature(A.plus, A0_plus, inverse_A0.first, A_rate.plus, w.plus, w_rate.plus, BB.plus, BB_rate.plus);
  const Curvature minus =
      curvature(A.minus, A0_minus, inverse_A0.second, A_rate.minus, w.minus, w_rate.minus, BB.minus, BB_rate.minus);
  const Curvature middle = curvature(A_middle, A0_middle, inverse_A0.third, Product::even(rate, 0), w_middle,
                                     even(twist_rate, 0), broadcast(4.0) * square.ss, broadcast(4.0) * rate.ss);
  const SimdDouble vanishing = broadcast(kVanishing);
  const Three inverse_K = reciprocals(plus.value + vanishing, minus.value + vanishing, middle.value + vanishing);
  const Stress at_plus = bending_stress(kGauss3[2].weight, section, plus, inverse_K.first, sums);
  const Stress at_minus = bending_stress(kGauss3[0].weight, section, minus, inverse_K.second, sums);
  const Stress at_middle = bending_stress(kGauss3[1].weight, section, middle, inverse_K.third, sums);

  const auto add = [&](Moments & m, const SimdDouble& p, const SimdDouble& n, const SimdDouble& c)
      __attribute__((always_inline)) {
    add_slopes(m, xi, {p * plus.square_slope, n * minus.square_slope});
    add_middle_slope(m, c * middle.square_slope);
    add_bends(m, xi, {p * plus.spread, n * minus.spread}, c * middle.spread);
    add_twists(m, xi, {p * plus.power, n * minus.power}, c * middle.power, w, w_middle);
  };
  if constexpr (kApart) {
    add(sums.elastic, at_plus.elastic, at_minus.elastic, at_middle.elastic);
    add(sums.viscous, at_plus.viscous, at_minus.viscous, at_middle.viscous);
  } else {
    add(sums.elastic, at_plus.elastic + at_plus.viscous, at_minus.elastic + at_minus.viscous,
        at_middle.elastic + at_middle.viscous);
  }
}

NETPOCKET_INLINE Modes load_modes(const CoordinateRows& arrays, const ElementBlock& block,
                                  const SimdDouble& inverse_length, int part) {
  const SimdVector r1 = load_coordinate(arrays, block, 0, part), r2 = load_coordinate(arrays, block, 2, part);
  const SimdVector g1 = load_coordinate(arrays, block, 1, part), g2 = load_coordinate(arrays, block, 3, part);
  const SimdVector e = inverse_length * (r2 - r1);
  return {e, scaled(0.5, g2 - g1), scaled(0.5, g1 + g2) - e};
}

// Rates of the modes at a material point due to the motion of material through the element and the change of length:
// xid B/2 - (Ld/L) (1 - P2) e with xid = -2 start_rate - (1 + xi) length_rate. Both rates in element lengths per
// second.
NETPOCKET_INLINE Modes flow(const Modes& q, const SimdDouble& start_rate, const SimdDouble& length_rate) {
  const SimdDouble middle_rate = broadcast(-2.0) * start_rate - length_rate;  // xid in the middle
  return {middle_rate * q.s - length_rate * (q.e + q.h), (broadcast(3.0) * middle_rate) * q.h - length_rate * q.s,
          length_rate * (q.e - scaled(2.0, q.h))};
}

// Powers (BatchPower) of each lane.
struct PowerSimd {
  SimdDouble dissipated, fed;
};

template <bool kVariable>
NETPOCKET_INLINE void part_forces(const ElementBlock& block, const SectionRows& rows, const double* start_rates,
                                  int part, const CoordinateRows& coordinates, const CoordinateRows& velocities,
                                  double* out, PowerSimd& power) {
  const SimdDouble length = load(block.length, part), inverse_length = load(block.inverse_length, part);
  const Modes q = load_modes(coordinates, block, inverse_length, part);
  Modes velocity = load_modes(velocities, block, inverse_length, part);
  Modes flowing{};
  SimdDouble length_rate{};
  if constexpr (kVariable) {
    length_rate = load(block.length_rate, part);
    flowing = flow(q, inverse_length * load(start_rates, part), length_rate);
    velocity = {velocity.e + flowing.e, velocity.s + flowing.s, velocity.h + flowing.h};
  }
  const SimdDouble half = broadcast(0.5) * length;
  const Section section = {half * load(rows.axial_stiffness, part), half * load(rows.compression_stiffness, part),
                           load(rows.axial_damping, part),
                           broadcast(0.25) * (load(rows.bending_rigidity, part) * inverse_length),
                           load(rows.bending_damping, part)};
  const Product q_square = square(q), half_rate = product(q, velocity);
  const Twist twist = {cross(q.e, q.s), cross(q.e, q.h), cross(q.s, q.h)};
  const Twist twist_rate = {cross(velocity.e, q.s) + cross(q.e, velocity.s),
                            cross(velocity.e, q.h) + cross(q.e, velocity.h),
                            cross(velocity.s, q.h) + cross(q.s, velocity.h)};
  Sums<kVariable> sums{};
  add_axial(section, q_square, half_rate, sums);
  add_bending(section, q_square, half_rate, twist, twist_rate, sums);

  Modes force = forces(sums.elastic, q);
  power.dissipated = power.dissipated + sums.dissipated;
  if constexpr (kVariable) {
    // At fixed coordinates a longer element has a shorter e. Damping also does work on the flow of material.
    const Modes viscous = forces(sums.viscous, q);
    const SimdDouble lengthening = simd::dot(force.h - force.e, q.e);
    power.fed = power.fed + (dot(viscous, flowing) + length_rate * (lengthening + sums.growth));
    force = {force.e + viscous.e, force.s + viscous.s, force.h + viscous.h};
  }
  store3(out, 0, part, inverse_length * (force.h - force.e));
  store3(out, 3, part, scaled(0.5, force.h - force.s));
  store3(out, 6, part, scaled(0.5, force.h + force.s));
}

}  // namespace

BatchPower element_forces(const BatchView& batch, const StartRates* start_rates, int first, int last,
                          const CoordinateRows& coordinates, const CoordinateRows& velocities, double* forces) {
  PowerSimd power[kParts] = {};
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
