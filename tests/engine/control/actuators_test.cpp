// Thrusters, the box of force and torque, and reaction wheels: momentum, propellant, limits and the limit cycle.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "engine/control/attitude_pd.h"
#include "engine/control/reaction_wheels.h"
#include "engine/control/thrusters.h"
#include "engine/control/wrench_box.h"
#include "tests/engine/control/single_axis.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;
using test::about_axis;
using test::SingleAxis;

constexpr double kActuatorStep = 1e-3;  // s
// Relative error of an allocation: the small weight on the size of its solution (bounded_least_squares.h).
constexpr double kAllocation = 3e-8;

// Twelve thrusters: at each end of each axis one each way along the next axis. Any wrench can be had.
std::vector<Thruster> twelve_thrusters(double thrust, double bit) {
  std::vector<Thruster> thrusters;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double end : {-1.0, 1.0}) {
      for (const double sign : {-1.0, 1.0}) {
        thrusters.push_back({.position = 1.5 * end * Vector3d::Unit(axis),
                             .direction = sign * Vector3d::Unit((axis + 1) % 3),
                             .thrust = thrust,
                             .impulse_bit = bit,
                             .specific_impulse = 230});
      }
    }
  }
  return thrusters;
}

struct Impulse {
  Vector3d linear = Vector3d::Zero(), angular = Vector3d::Zero();  // N s, N m s
};

template <class Actuator>
Impulse impulse_over(Actuator& actuator, double time) {
  Impulse impulse;
  for (int i = 0; i < std::lround(time / kActuatorStep); ++i) {
    const Wrench wrench = actuator.step(kActuatorStep);
    impulse.linear += kActuatorStep * wrench.force;
    impulse.angular += kActuatorStep * wrench.torque;
  }
  return impulse;
}

TEST(Thrusters, GiveTheWantedImpulse) {
  const Wrench wanted = {{3, -4, 5}, {1, 2, -3}};
  for (const double lag : {0.0, 0.01}) {
    Thrusters thrusters(twelve_thrusters(20, 0), lag);
    thrusters.command(wanted, 0.1);
    const Impulse impulse = impulse_over(thrusters, 0.5);  // long after the period, for the lag to fade
    EXPECT_NEAR((impulse.linear - 0.1 * wanted.force).norm(), 0, 1e-7);
    EXPECT_NEAR((impulse.angular - 0.1 * wanted.torque).norm(), 0, 1e-7);
  }
}

// Force along +x: the two thrusters that push that way, and no others. Propellant = impulse/(Isp g0).
TEST(Thrusters, PropellantIsImpulseOverExhaustSpeed) {
  Thrusters thrusters(twelve_thrusters(20, 0), 0.02);
  for (int i = 0; i < 50; ++i) {
    thrusters.command({{10, 0, 0}, {0, 0, 0}}, 0.1);
    impulse_over(thrusters, 0.1);
  }
  impulse_over(thrusters, 1);
  EXPECT_NEAR(thrusters.propellant(), 10 * 5 / (230 * 9.80665), kAllocation * 0.0222);
}

// A wish beyond the limits: every useful thruster fires for the whole period.
TEST(Thrusters, SaturateAtTheirThrust) {
  Thrusters thrusters(twelve_thrusters(20, 0), 0);
  thrusters.command({{1000, 0, 0}, {0, 0, 0}}, 0.1);
  EXPECT_NEAR(thrusters.step(kActuatorStep).force.x(), 40, 1e-9);
  EXPECT_NEAR(impulse_over(thrusters, 1).linear.x(), 40 * (0.1 - kActuatorStep), 1e-9);
}

// One thruster of 10 N with a bit of 0.5 N s: less than half a bit is dropped, more is rounded up, and the pulse of 50
// ms outlasts a period of 20 ms.
TEST(Thrusters, RoundToTheirImpulseBit) {
  const auto given = [](double wanted) {
    Thrusters one({{.position = {0, 0, 0}, .direction = {0, 2, 0}, .thrust = 10, .impulse_bit = 0.5}}, 0);
    one.command({{0, wanted / 0.02, 0}, {0, 0, 0}}, 0.02);
    double impulse = impulse_over(one, 0.02).linear.y();
    one.command({}, 0.02);
    return impulse += impulse_over(one, 0.1).linear.y();
  };
  EXPECT_EQ(given(0.19), 0);
  EXPECT_NEAR(given(0.2), 0, 1e-12);  // the most in 20 ms: below half a bit
  Thrusters one({{.position = {0, 0, 0}, .direction = {0, 1, 0}, .thrust = 30, .impulse_bit = 0.5}}, 0);
  one.command({{0, 13, 0}, {0, 0, 0}}, 0.02);  // 0.26 N s
  EXPECT_NEAR(impulse_over(one, 0.015).linear.y(), 0.45, 1e-9);
  one.command({}, 0.02);
  EXPECT_NEAR(impulse_over(one, 0.1).linear.y(), 0.05, 1e-9);
}

// A double integrator in a dead band, fired back by one bit B of each of the n thrusters at each side: the rate
// alternates between +-n B L/(2 I), the period is 4 times the limit angle over that rate, and a period costs 2 n B/(Isp
// g0). (Brown, Elements of Spacecraft Design, limit cycle without external torque.)
TEST(Thrusters, ImpulseBitGivesThePredictedLimitCycle) {
  constexpr double kBit = 0.05, kLever = 1.5, kPeriod = 0.1, kPairs = 2;
  const AttitudePd pd({Vector3d::Constant(2000), Vector3d::Constant(100)}, SingleAxis::inertia());
  Thrusters thrusters(twelve_thrusters(20, kBit), 0);
  const double predicted = kPairs * kBit * kLever / (2 * SingleAxis::moment());
  // The PD demand crosses half a bit: P angle + D rate = n L B/2 / period.
  const double limit = (kPairs * kLever * kBit / 2 / kPeriod - 100 * predicted) / 2000;
  SingleAxis body = {0, predicted};
  double highest = 0, lowest = 0, widest = 0, first = 0, last = 0, propellant = 0, used = 0;
  int cycles = -1;
  for (int i = 0; i < 20'000; ++i) {
    const double before = body.angle;
    thrusters.command(
        {Vector3d::Zero(), to_body_axes(body.body(), pd.demand(body.body(), {SingleAxis::wanted()}).torque)}, kPeriod);
    for (int k = 0; k < 10; ++k) body.turn(thrusters.step(kPeriod / 10).torque.y(), kPeriod / 10);
    highest = std::max(highest, body.rate);
    lowest = std::min(lowest, body.rate);
    widest = std::max(widest, std::abs(body.angle));
    if (before < 0 && body.angle >= 0) {
      last = i * kPeriod;
      if (++cycles == 0) first = last;
      if (cycles == 0) propellant = thrusters.propellant();
      used = thrusters.propellant() - propellant;
    }
  }
  EXPECT_NEAR((highest - lowest) / 2, predicted, 1e-9 * predicted);
  EXPECT_NEAR(highest, predicted, 1e-9 * predicted);
  ASSERT_GT(cycles, 3);
  EXPECT_NEAR(widest, limit, predicted * kPeriod * 2);
  EXPECT_NEAR((last - first) / cycles, 4 * limit / predicted, 6 * kPeriod);
  EXPECT_NEAR(used / cycles, 2 * kPairs * kBit / (230 * 9.80665), 1e-12);
}

TEST(Thrusters, RefuseWrongOnes) {
  const auto refused = [](const Thruster& thruster) { EXPECT_THROW(Thrusters({thruster}, 0), std::invalid_argument); };
  refused({.position = {1, 0, 0}, .direction = {0, 0, 0}, .thrust = 1});
  refused({.position = {1, 0, 0}, .direction = {1, 0, 0}, .thrust = 0});
  refused({.position = {1, 0, 0}, .direction = {1, 0, 0}, .thrust = 1, .impulse_bit = -1});
  refused({.position = {1, 0, 0}, .direction = {1, 0, 0}, .thrust = 1, .specific_impulse = 0});
  refused({.position = {std::nan(""), 0, 0}, .direction = {1, 0, 0}, .thrust = 1});
  EXPECT_THROW(Thrusters({}, 0), std::invalid_argument);
}

// A lag T after a step: F (1 - exp(-t/T)); propellant = int |F| dt/(Isp g0) with int F dt = F (t - T (1 - exp(-t/T))).
TEST(WrenchBox, CutsAndLags) {
  WrenchBox box({.most_force = {5, 5, 5}, .most_torque = {1, 1, 1}, .time_constant = 0.2, .specific_impulse = 300});
  box.command({{-50, 3, 0}, {0.5, -4, 0}});
  const Impulse impulse = impulse_over(box, 0.3);
  const double risen = 1 - std::exp(-0.3 / 0.2), time = 0.3 - 0.2 * risen;
  EXPECT_NEAR((impulse.linear - time * Vector3d(-5, 3, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((impulse.angular - time * Vector3d(0.5, -1, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR(box.propellant(), time * 8 / (300 * 9.80665), 1e-14);
  const Wrench now = box.step(1e-9);
  EXPECT_NEAR((now.force - risen * Vector3d(-5, 3, 0)).norm(), 0, 1e-7);
}

// Four wheels in a pyramid, of which the torque about z is shared evenly: each has 1/(4 sin 35 deg).
std::vector<ReactionWheel> pyramid(double most_torque, double most_momentum) {
  std::vector<ReactionWheel> wheels;
  const double tilt = 35 * std::numbers::pi / 180;
  for (int i = 0; i < 4; ++i) {
    const double turn = i * std::numbers::pi / 2;
    wheels.push_back({{std::cos(tilt) * std::cos(turn), std::cos(tilt) * std::sin(turn), std::sin(tilt)},
                      most_torque,
                      most_momentum});
  }
  return wheels;
}

TEST(ReactionWheels, ShareTheTorque) {
  ReactionWheels wheels(pyramid(1, 10));
  wheels.command({0, 0, 0.8});
  const Wrench wrench = wheels.step(Vector3d::Zero(), 2);
  EXPECT_NEAR((wrench.torque - Vector3d(0, 0, 0.8)).norm(), 0, kAllocation);
  EXPECT_EQ(wrench.force.norm(), 0);
  for (const double momentum : wheels.wheel_momenta()) {
    EXPECT_NEAR(momentum, -2 * 0.8 / (4 * std::sin(35 * std::numbers::pi / 180)), 1e-7);
  }
}

// The angular momentum J w + h, in world axes, of a free body with wheels stays the same whatever the wheels do.
TEST(ReactionWheels, KeepTheAngularMomentum) {
  ReactionWheels wheels(pyramid(0.5, 3));
  const Eigen::Matrix3d inertia = Vector3d(20, 30, 40).asDiagonal(), inverse = inertia.inverse();
  Vector3d spin(0.1, -0.2, 0.15);
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
  const auto momentum = [&] { return Vector3d(attitude * (inertia * spin + wheels.momentum())); };
  const Vector3d before = momentum();
  constexpr double kFine = 1e-4;
  for (int i = 0; i < 200'000; ++i) {
    if (i % 1000 == 0) wheels.command(Vector3d(std::sin(0.01 * i), 0.3, std::cos(0.003 * i)));
    const Vector3d torque = wheels.step(spin, kFine).torque;
    const Vector3d middle = spin + 0.5 * kFine * (inverse * (torque - spin.cross(inertia * spin)));
    attitude = attitude * rotation_by(kFine * middle);
    attitude.normalize();
    spin += kFine * (inverse * (torque - middle.cross(inertia * middle)));
  }
  EXPECT_GT(wheels.momentum().norm(), 1);
  EXPECT_NEAR((momentum() - before).norm(), 0, 1e-3 * before.norm());
}

// 3 N m s at 0.5 N m last 6 s. Then no torque that way is left, and the other way there is.
TEST(ReactionWheels, SaturateInTorqueAndMomentum) {
  ReactionWheels wheel({{{0, 0, 2}, 0.5, 3}});
  for (int i = 0; i < 100; ++i) {
    wheel.command({0, 0, -9});
    EXPECT_NEAR(wheel.step(Vector3d::Zero(), 0.1).torque.z(), i < 60 ? -0.5 : 0, kAllocation) << i;
  }
  EXPECT_NEAR(wheel.momentum().z(), 3, 1e-12);
  wheel.command({0, 0, 0.2});
  EXPECT_NEAR(wheel.step(Vector3d::Zero(), 0.1).torque.z(), 0.2, kAllocation);
  EXPECT_THROW(ReactionWheels({{{0, 0, 0}, 1, 1}}), std::invalid_argument);
  EXPECT_THROW(ReactionWheels({{{0, 0, 1}, 0, 1}}), std::invalid_argument);
}

// A saturated wheel of a pyramid: the other three still give the torque.
TEST(ReactionWheels, OthersTakeOverForASaturatedWheel) {
  std::vector<ReactionWheel> wheels = pyramid(1, 10);
  wheels[0].most_momentum = 0.1;
  for (const double sign : {-1.0, 1.0}) {
    ReactionWheels actuator(wheels);
    const Vector3d wanted = sign * Vector3d(0.05, 0.1, 0.2);
    double lost = 0;
    for (int i = 0; i < 100; ++i) {
      actuator.command(wanted);
      lost = (actuator.step(Vector3d::Zero(), 0.1).torque - wanted).norm();
    }
    EXPECT_NEAR(std::abs(actuator.wheel_momenta()[0]), 0.1, 1e-12);
    EXPECT_NEAR(lost, 0, kAllocation);
  }
}

}  // namespace
}  // namespace netpocket
