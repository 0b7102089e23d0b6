// Towing: closed loops against their closed forms.

#include "engine/control/tow_control.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/control/spin_damping.h"
#include "engine/control/velocity_profile.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

// A spacecraft of 1210 kg that keeps its distance: m x'' + D x' + P x = 0, critically damped:
// x = x0 (1 + f t) exp(-f t).
TEST(TowControl, SeparationFollowsTheSecondOrderSolution) {
  constexpr double kMass = 1210, kFrequency = 0.4, kStep = 1e-4;
  TowControl tow({.proportional = kMass * kFrequency * kFrequency, .derivative = 2 * kMass * kFrequency});
  double separation = 12, rate = 0;
  for (int i = 1; i <= 100'000; ++i) {
    const double thrust = tow.update({separation, rate, 0}, {10}, kStep);
    separation += kStep * (rate + 0.5 * kStep * thrust / kMass);
    rate += kStep * thrust / kMass;
    const double ft = kFrequency * i * kStep;
    ASSERT_NEAR(separation, 10 + 2 * (1 + ft) * std::exp(-ft), 1e-4);
  }
}

// A line with a tension of q times the thrust: the excess over the cap decays as exp(-q I t).
TEST(TowControl, TensionDecaysToItsCap) {
  constexpr double kPart = 200.0 / 1410, kIntegral = 5, kCap = 20, kStep = 1e-4;
  TowControl tow({.most = 300}, TensionCapSettings{.cap = kCap, .integral = kIntegral});
  double tension = 0;
  for (int i = 0; i < 200'000; ++i)
    tension = kPart * tow.update({0, 0, tension}, {.value = 0, .feed_forward = 100}, kStep);
  EXPECT_NEAR(tension, 100 * kPart, 1e-12);  // below the cap the demand passes
  double time = 0;
  for (; time < 2; time += kStep)
    tension = kPart * tow.update({0, 0, tension}, {.value = 0, .feed_forward = 300}, kStep);
  EXPECT_NEAR(tension - kCap, (300 * kPart - kCap) * std::exp(-kPart * kIntegral * time), 0.02);
  for (int i = 0; i < 300'000; ++i)
    tension = kPart * tow.update({0, 0, tension}, {.value = 0, .feed_forward = 300}, kStep);
  EXPECT_NEAR(tension, kCap, 1e-6);
}

TEST(TowControl, CapNeverPushes) {
  TensionCap cap({.cap = 10, .proportional = 50});
  EXPECT_EQ(cap.update(100, 1000, 0.1), 0);
  EXPECT_EQ(cap.update(-5, 1000, 0.1), -5);
}

// Simpson's rule over the profile gives the distance duration (from + to)/2, the mean by symmetry.
TEST(VelocityProfile, GoesSmoothlyFromOneValueToTheOther) {
  const VelocityProfile profile = {.start = 3, .duration = 4, .from = 0.1, .to = 0.5};
  EXPECT_EQ(profile.velocity(2), 0.1);
  EXPECT_EQ(profile.velocity(7), 0.5);
  EXPECT_EQ(profile.velocity(100), 0.5);
  EXPECT_NEAR(profile.velocity(5), 0.3, 1e-15);
  EXPECT_EQ(profile.acceleration(3), 0);
  EXPECT_EQ(profile.acceleration(7), 0);
  EXPECT_NEAR(profile.acceleration(5), 2 * 0.4 / 4, 1e-15);
  double distance = 0;
  for (int i = 0; i < 1000; ++i) {
    const double h = 4e-3, t = 3 + i * h;
    distance += h / 6 * (profile.velocity(t) + 4 * profile.velocity(t + h / 2) + profile.velocity(t + h));
    const double slope = (profile.velocity(t + 1e-5) - profile.velocity(t)) / 1e-5;
    EXPECT_NEAR(profile.acceleration(t + 0.5e-5), slope, 1e-9);
  }
  EXPECT_NEAR(distance, 4 * 0.3, 1e-12);
}

// I w' = -D w, at most M: linear until w = M/D, then exponential.
TEST(SpinDamping, SpinDecaysLinearlyAndThenExponentially) {
  constexpr double kMoment = 5000, kStep = 1e-3;
  const SpinDamping damping = {.gain = 1000, .most = 50};
  const Vector3d axis = Vector3d(2, 1, -2) / 3;
  Vector3d spin = 0.15 * axis;
  for (int i = 0; i < 20'000; ++i) {
    const Wrench demand = damping.demand(spin);
    EXPECT_LE(demand.torque.norm(), 50 * (1 + 1e-15));
    EXPECT_EQ(demand.force.norm(), 0);
    spin += kStep / kMoment * demand.torque;
  }
  // 0.15 to 0.05 rad/s takes 0.1 * 5000/50 = 10 s.
  EXPECT_NEAR(spin.norm(), 0.05 * std::exp(-1000.0 / kMoment * 10), 1e-5);
  EXPECT_NEAR(spin.normalized().dot(axis), 1, 1e-12);
}

}  // namespace
}  // namespace netpocket
