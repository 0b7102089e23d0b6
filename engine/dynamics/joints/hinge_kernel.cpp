// Compiled once per instruction set; NETPOCKET_ISA_NAME is the variant's namespace. The formulas and notation are those
// of hinge_forces.h.

#include "engine/dynamics/joints/hinge_kernel.h"

#include "engine/ancf/element_coordinates.h"
#include "engine/dynamics/joints/hinge_hold.h"
#include "engine/math/elementary.h"
#include "engine/math/simd.h"

namespace netpocket::hinge_kernel::NETPOCKET_ISA_NAME {
namespace {

using namespace simd;

// A matrix for each lane, by columns.
struct Matrix {
  SimdVector first, second, third;
};

// The order of summation is that of symmetric_product and symmetric_transposed_product.
NETPOCKET_INLINE SimdVector product(const Matrix& m, const SimdVector& v) {
  return (v.x * m.first + v.z * m.third) + v.y * m.second;
}
NETPOCKET_INLINE SimdVector transposed_product(const Matrix& m, const SimdVector& v) {
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
  SimdVector unit, rate;
  SimdDouble magnitude;
};
NETPOCKET_INLINE Direction direction(const SimdVector& gradient, const SimdVector& gradient_rate) {
  Direction d;
  d.magnitude = square_root(dot(gradient, gradient));
  const SimdDouble inverse = broadcast(1.0) / d.magnitude;
  d.unit = inverse * gradient;
  d.rate = inverse * (gradient_rate - dot(d.unit, gradient_rate) * d.unit);
  return d;
}

NETPOCKET_INLINE SimdDouble gather_values(const double* values, const std::int32_t* indices, int part) {
  std::ptrdiff_t place[kWidth];
  for (int i = 0; i < kWidth; ++i) place[i] = indices[part * kWidth + i];
  return gather(values, place);
}

NETPOCKET_INLINE SimdDouble angle_of(const SimdDouble& sine, const SimdDouble& cosine, int lanes) {
  SimdDouble angle = {};
  for (int i = 0; i < kWidth && i < lanes; ++i) angle[i] = arc_tangent(sine[i], cosine[i]);
  return angle;
}

// As hinge_hold.
struct Hold {
  SimdDouble hold, rate;
};
NETPOCKET_INLINE Hold hold_of(const SimdDouble& length) {
  const SimdDouble firm = broadcast(kFirmHold), one = broadcast(1.0);
  const SimdDouble x = length < firm ? length / firm : one;
  return {x * x * (broadcast(3.0) - broadcast(2.0) * x), broadcast(6 / kFirmHold) * x * (one - x)};
}

}  // namespace

void forces(const CoordinateRows& coordinates, const CoordinateRows& velocities, const double* inverse_mass,
            double kick, const Axes& axes, HingeBlock& block) {
  const Matrix to_world = broadcast_matrix(axes.rotation);
  const SimdVector spin = {broadcast(axes.angular_velocity[0]), broadcast(axes.angular_velocity[1]),
                           broadcast(axes.angular_velocity[2])};
  for (int part = 0; part < kParts; ++part) {
    const Matrix rest = load_matrix(block.rest_rotation, part);
    const SimdVector g1 = gather_coordinates(coordinates.first, block.gradient1, part),
                     g2 = gather_coordinates(coordinates.first, block.gradient2, part);
    const Direction d1 = direction(g1, gather_coordinates(velocities.first, block.gradient1, part));
    const Direction d2 = direction(g2, gather_coordinates(velocities.first, block.gradient2, part));
    const SimdVector t = product(to_world, product(rest, transposed_product(to_world, d1.unit)));
    const SimdVector t_rate =
        product(to_world, product(rest, transposed_product(to_world, d1.rate - cross(spin, d1.unit)))) + cross(spin, t);

    const SimdDouble cosine = dot(t, d2.unit);
    const SimdVector across = cross(t, d2.unit);
    const SimdDouble sine = square_root(dot(across, across));
    const SimdDouble angle = angle_of(sine, cosine, block.count - part * kWidth);
    const SimdVector towards2 = t - cosine * d2.unit, towards1 = d2.unit - cosine * t;
    const SimdDouble zero = broadcast(0.0), one = broadcast(1.0);
    // At a straight hinge the plane of the angle is undefined, and the angle's rate is taken as 0.
    const SimdDouble inverse_sine = one / (sine < broadcast(1e-12) ? one : sine);
    const SimdDouble closing = -(dot(towards2, d2.rate) + dot(towards1, t_rate)) * inverse_sine;
    const SimdDouble angle_rate = sine < broadcast(1e-12) ? zero : closing;
    const SimdDouble i1 = gather_values(inverse_mass, block.gradient1, part);
    const SimdDouble i2 = gather_values(inverse_mass, block.gradient2, part);
    // Inverse inertia of the angle, 1/(kg m^2). For the limit of damping see hinge_kernel.h.
    const SimdDouble turning = i1 / (d1.magnitude * d1.magnitude) + i2 / (d2.magnitude * d2.magnitude);
    const SimdDouble own_damping = load(block.damping, part);
    const SimdDouble allowed = larger(one / (turning * broadcast(kick)), own_damping * ((i1 + i2) / turning));
    const SimdDouble damping = own_damping < allowed ? own_damping : allowed;
    const SimdDouble damping_moment = damping * angle_rate;
    const SimdDouble ratio = sine < broadcast(1e-8) ? one : angle * inverse_sine;
    const Hold hold1 = hold_of(d1.magnitude), hold2 = hold_of(d2.magnitude);
    const SimdDouble stiffness = load(block.stiffness, part);
    const SimdDouble factor = stiffness * (hold1.hold * hold2.hold) * ratio + damping_moment * inverse_sine;
    const SimdDouble bend = broadcast(0.5) * stiffness * angle * angle;

    const SimdVector force2 = (factor / d2.magnitude) * towards2 - (bend * (hold1.hold * hold2.rate)) * d2.unit;
    const SimdVector force1 =
        (factor / d1.magnitude) * product(to_world, transposed_product(rest, transposed_product(to_world, towards1))) -
        (bend * (hold2.hold * hold1.rate)) * d1.unit;
    const SimdVector torque = cross(g1, force1) + cross(g2, force2);
    store3(block.on_gradient1[0], 0, part, force1);
    store3(block.on_gradient2[0], 0, part, force2);
    store3(block.torque_on_body[0], 0, part, {-torque.x, -torque.y, -torque.z});
    store(block.dissipated_power, part, damping_moment * angle_rate);
    store(block.is_limited, part, damping < own_damping ? one : zero);
    store(block.is_loose, part, hold1.hold * hold2.hold < one ? one : zero);
  }
}

}  // namespace netpocket::hinge_kernel::NETPOCKET_ISA_NAME
