// Compiled once per instruction set, NETPOCKET_ISA_NAME being the variant's namespace. The formulas are those of
// hinge_forces.h, in the same notation.

#include "engine/dynamics/hinge_kernel.h"

#include "engine/ancf/element_slots.h"
#include "engine/ancf/lanes.h"
#include "engine/dynamics/hinge_hold.h"
#include "engine/math/elementary.h"

namespace netpocket::hinge_kernel::NETPOCKET_ISA_NAME {
namespace {

using namespace lanes;

// Columns of a matrix of each lane.
struct Matrix {
  Lanes3 first, second, third;
};

// As symmetric_product and symmetric_transposed_product.
NETPOCKET_INLINE Lanes3 product(const Matrix& m, const Lanes3& v) {
  return (v.x * m.first + v.z * m.third) + v.y * m.second;
}
NETPOCKET_INLINE Lanes3 transposed_product(const Matrix& m, const Lanes3& v) {
  return {dot(m.first, v), dot(m.second, v), dot(m.third, v)};
}

NETPOCKET_INLINE Matrix broadcast_matrix(const double* m) {
  return {{broadcast(m[0]), broadcast(m[1]), broadcast(m[2])},
          {broadcast(m[3]), broadcast(m[4]), broadcast(m[5])},
          {broadcast(m[6]), broadcast(m[7]), broadcast(m[8])}};
}
NETPOCKET_INLINE Matrix load_matrix(const double (*rows)[kBlock], int part) {
  return {{load(rows[0], part), load(rows[1], part), load(rows[2], part)},
          {load(rows[3], part), load(rows[4], part), load(rows[5], part)},
          {load(rows[6], part), load(rows[7], part), load(rows[8], part)}};
}

// A unit direction and its rate, from a gradient and its rate.
struct Direction {
  Lanes3 unit, rate;
  Lanes magnitude;
};
NETPOCKET_INLINE Direction direction(const Lanes3& gradient, const Lanes3& gradient_rate) {
  Direction d;
  d.magnitude = square_root(dot(gradient, gradient));
  const Lanes inverse = broadcast(1.0) / d.magnitude;
  d.unit = inverse * gradient;
  d.rate = inverse * (gradient_rate - dot(d.unit, gradient_rate) * d.unit);
  return d;
}

NETPOCKET_INLINE Lanes gather_values(const double* values, const std::int32_t* slots, int part) {
  std::ptrdiff_t place[kWidth];
  for (int i = 0; i < kWidth; ++i) place[i] = slots[part * kWidth + i];
  return gather(values, place);
}

NETPOCKET_INLINE Lanes angle_of(const Lanes& sine, const Lanes& cosine) {
  Lanes angle = {};
  for (int i = 0; i < kWidth; ++i) angle[i] = arc_tangent(sine[i], cosine[i]);
  return angle;
}

// hinge_hold
struct Hold {
  Lanes hold, rate;
};
NETPOCKET_INLINE Hold hold_of(const Lanes& length) {
  const Lanes firm = broadcast(kFirmHold), one = broadcast(1.0);
  const Lanes x = length < firm ? length / firm : one;
  return {x * x * (broadcast(3.0) - broadcast(2.0) * x), broadcast(6 / kFirmHold) * x * (one - x)};
}

}  // namespace

void forces(const SlotRows& coordinates, const SlotRows& velocities, const double* inverse_mass, double kick,
            const Axes& axes, HingeBlock& block) {
  const Matrix to_world = broadcast_matrix(axes.rotation);
  const Lanes3 spin = {broadcast(axes.angular_velocity[0]), broadcast(axes.angular_velocity[1]),
                       broadcast(axes.angular_velocity[2])};
  for (int part = 0; part < kParts; ++part) {
    const Matrix rest = load_matrix(block.rest_rotation, part);
    const Lanes3 g1 = gather_slots(coordinates.first, block.gradient1, part),
                 g2 = gather_slots(coordinates.first, block.gradient2, part);
    const Direction d1 = direction(g1, gather_slots(velocities.first, block.gradient1, part));
    const Direction d2 = direction(g2, gather_slots(velocities.first, block.gradient2, part));
    const Lanes3 t = product(to_world, product(rest, transposed_product(to_world, d1.unit)));
    const Lanes3 t_rate =
        product(to_world, product(rest, transposed_product(to_world, d1.rate - cross(spin, d1.unit)))) + cross(spin, t);

    const Lanes cosine = dot(t, d2.unit);
    const Lanes3 across = cross(t, d2.unit);
    const Lanes sine = square_root(dot(across, across));
    const Lanes angle = angle_of(sine, cosine);
    const Lanes3 towards2 = t - cosine * d2.unit, towards1 = d2.unit - cosine * t;
    const Lanes zero = broadcast(0.0), one = broadcast(1.0);
    const Lanes inverse_sine = one / (sine < broadcast(1e-12) ? one : sine);
    const Lanes closing = -(dot(towards2, d2.rate) + dot(towards1, t_rate)) * inverse_sine;
    const Lanes angle_rate = sine < broadcast(1e-12) ? zero : closing;
    const Lanes i1 = gather_values(inverse_mass, block.gradient1, part);
    const Lanes i2 = gather_values(inverse_mass, block.gradient2, part);
    const Lanes turning = i1 / (d1.magnitude * d1.magnitude) + i2 / (d2.magnitude * d2.magnitude);
    const Lanes own_damping = load(block.damping, part);
    const Lanes allowed = larger(one / (turning * broadcast(kick)), own_damping * ((i1 + i2) / turning));
    const Lanes damping = own_damping < allowed ? own_damping : allowed;
    const Lanes damping_moment = damping * angle_rate;
    const Lanes ratio = sine < broadcast(1e-8) ? one : angle * inverse_sine;
    const Hold hold1 = hold_of(d1.magnitude), hold2 = hold_of(d2.magnitude);
    const Lanes stiffness = load(block.stiffness, part);
    const Lanes factor = stiffness * (hold1.hold * hold2.hold) * ratio + damping_moment * inverse_sine;
    const Lanes bend = broadcast(0.5) * stiffness * angle * angle;

    const Lanes3 force2 = (factor / d2.magnitude) * towards2 - (bend * (hold1.hold * hold2.rate)) * d2.unit;
    const Lanes3 force1 =
        (factor / d1.magnitude) * product(to_world, transposed_product(rest, transposed_product(to_world, towards1))) -
        (bend * (hold2.hold * hold1.rate)) * d1.unit;
    const Lanes3 torque = cross(g1, force1) + cross(g2, force2);
    store3(block.on_gradient1[0], 0, part, force1);
    store3(block.on_gradient2[0], 0, part, force2);
    store3(block.torque_on_body[0], 0, part, {-torque.x, -torque.y, -torque.z});
    store(block.dissipated_power, part, damping_moment * angle_rate);
    store(block.is_limited, part, damping < own_damping ? one : zero);
    store(block.is_loose, part, hold1.hold * hold2.hold < one ? one : zero);
  }
}

}  // namespace netpocket::hinge_kernel::NETPOCKET_ISA_NAME
