#include "engine/dynamics/joints/hinge_forces.h"

#include <cmath>

#include "engine/math/elementary.h"
#include "engine/math/symmetric_algebra.h"

namespace netpocket {
namespace {

// A unit direction and its rate, from a gradient and its rate.
struct Direction {
  Eigen::Vector3d unit, rate;
  double magnitude;

  Direction(const Eigen::Vector3d& gradient, const Eigen::Vector3d& gradient_rate)
      : magnitude(symmetric_norm(gradient)) {
    unit = gradient / magnitude;
    rate = (gradient_rate - unit * symmetric_dot(unit, gradient_rate)) / magnitude;
  }
};

// angle / sin(angle) for an angle in [0, pi) and its sine; tends to 1 where the sine vanishes.
double angle_over_sine(double angle, double sine) { return sine < 1e-8 ? 1.0 : angle / sine; }

}  // namespace

HingeForces hinge_forces(const Hinge& hinge, const Eigen::Vector3d& g1, const Eigen::Vector3d& g2,
                         const Eigen::Vector3d& g1_rate, const Eigen::Vector3d& g2_rate, const Eigen::Matrix3d& axes,
                         const Eigen::Vector3d& angular_velocity) {
  const Direction d1(g1, g1_rate), d2(g2, g2_rate);
  // R g1 = axes R0 axes^T g1. Its rate has a part from the rotation of the axes.
  const auto turn = [&](const Eigen::Vector3d& v) -> Eigen::Vector3d {
    return symmetric_product(axes, symmetric_product(hinge.rest_rotation, symmetric_transposed_product(axes, v)));
  };
  const auto turn_back = [&](const Eigen::Vector3d& v) -> Eigen::Vector3d {
    return symmetric_product(axes,
                             symmetric_transposed_product(hinge.rest_rotation, symmetric_transposed_product(axes, v)));
  };
  const Eigen::Vector3d t = turn(d1.unit);
  const Eigen::Vector3d t_rate = turn(d1.rate - angular_velocity.cross(d1.unit)) + angular_velocity.cross(t);

  const double cosine = symmetric_dot(t, d2.unit);
  const double sine = symmetric_norm(t.cross(d2.unit));
  HingeForces result;
  result.angle = arc_tangent(sine, cosine);

  // d(theta)/d(t2) = -(t - cosine t2)/sine is minus the unit vector across t2, towards t. `towards2` is that unit
  // vector times the sine.
  const Eigen::Vector3d towards2 = t - cosine * d2.unit;
  const Eigen::Vector3d towards1 = d2.unit - cosine * t;  // likewise across t, towards t2
  const double angle_rate =
      sine < 1e-12 ? 0.0 : -(symmetric_dot(towards2, d2.rate) + symmetric_dot(towards1, t_rate)) / sine;
  const double damping_moment = hinge.damping * angle_rate;
  const HingeHold hold1 = hinge_hold(d1.magnitude), hold2 = hinge_hold(d2.magnitude);
  const double stiffness = hinge.stiffness * (hold1.hold * hold2.hold);
  const double factor = stiffness * angle_over_sine(result.angle, sine) + (sine < 1e-12 ? 0.0 : damping_moment / sine);
  const double bend = 0.5 * hinge.stiffness * result.angle * result.angle;

  result.on_gradient2 = (factor / d2.magnitude) * towards2 - (bend * (hold1.hold * hold2.rate)) * d2.unit;
  result.on_gradient1 = (factor / d1.magnitude) * turn_back(towards1) - (bend * (hold2.hold * hold1.rate)) * d1.unit;
  // A common rotation changes no energy, so the moments on the gradients and on the body balance.
  result.torque_on_body = -(g1.cross(result.on_gradient1) + g2.cross(result.on_gradient2));
  result.energy = 0.5 * stiffness * result.angle * result.angle;
  result.dissipated_power = damping_moment * angle_rate;
  return result;
}

}  // namespace netpocket
