// Attitude PD against the closed solution of the second-order equation and the closed form of its delay margin.

#include "engine/control/attitude_pd.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "engine/control/sensor_channel.h"
#include "tests/engine/control/single_axis.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;
using test::about_axis;
using test::SingleAxis;

constexpr double kFrequency = 0.5, kDamping = 0.6;  // rad/s and 1

AttitudePd test_pd() {
  return {attitude_gains(SingleAxis::inertia().diagonal(), kFrequency, kDamping), SingleAxis::inertia()};
}

// I e'' + D e' + P e = 0 with e(0) = e0, e'(0) = 0: e = e0 exp(-z f t) (cos w t + z f/w sin w t), w = f sqrt(1 - z^2).
TEST(AttitudePd, FollowsTheSecondOrderSolution) {
  constexpr double kStart = 1.2, kStep = 0.01;  // rad, s
  const AttitudePd pd = test_pd();
  SingleAxis body = {kStart, 0};
  const double decay = kDamping * kFrequency, w = kFrequency * std::sqrt(1 - kDamping * kDamping);
  for (int i = 1; i <= 2000; ++i) {
    body.turn([&](const SingleAxis& now) { return about_axis(pd.demand(now.body(), {SingleAxis::wanted()}).torque); },
              kStep);
    const double t = i * kStep;
    const double exact = kStart * std::exp(-decay * t) * (std::cos(w * t) + decay / w * std::sin(w * t));
    ASSERT_NEAR(body.angle, exact, 1e-9 * kStart) << t;
  }
}

// Euler's equations: with no error of attitude and rate, a body about its wanted spin needs the torque w x (J w) + J a.
TEST(AttitudePd, KeepsAWantedSpinAboutAnyAxis) {
  BodyState state;
  state.angular_velocity = {0.1, 0.2, -0.3};
  const WantedMotion wanted = {state, Vector3d::Zero(), {0.01, 0, 0.02}};
  const Vector3d torque = test_pd().demand(state, wanted).torque;
  const Vector3d by_hand = {0.2 * -0.3 * (14498 - 12736) + 4282 * 0.01, -0.3 * 0.1 * (4282 - 14498),
                            0.1 * 0.2 * (12736 - 4282) + 14498 * 0.02};
  EXPECT_NEAR((torque - by_hand).norm(), 0, 1e-11);
}

// Delay margin of L = (2 z f s + f^2)/s^2: |L| = 1 at w^2 = f^2 (2 z^2 + sqrt(4 z^4 + 1)), phase margin atan(2 z w/f),
// delay margin phase/w (Astrom & Murray, Feedback Systems (2008), section 9.3).
double delay_margin() {
  const double z2 = kDamping * kDamping;
  const double w = kFrequency * std::sqrt(2 * z2 + std::sqrt(4 * z2 * z2 + 1));
  return std::atan(2 * kDamping * w / kFrequency) / w;
}

// Largest angle of the second 100 s over that of the first 100 s, after 50 s; small angles stay far from half a turn.
double growth_with_delay(double delay) {
  constexpr double kPeriod = 0.005;  // s
  const AttitudePd pd = test_pd();
  // A torque held over a period adds half of it to the delay.
  SensorChannel sensor({.rate = 1 / kPeriod, .delay = delay - 0.5 * kPeriod}, 2);
  SingleAxis body = {1e-6, 0};
  double before = 0, after = 0;
  for (int i = 0; i < 50'000; ++i) {
    sensor.look(i * kPeriod, std::array{body.angle, body.rate});
    const SingleAxis seen = {sensor.reading()[0], sensor.reading()[1]};
    body.turn(about_axis(pd.demand(seen.body(), {SingleAxis::wanted()}).torque), kPeriod);
    if (i < 10'000) continue;
    double& peak = i < 30'000 ? before : after;
    peak = std::max(peak, std::abs(body.angle));
  }
  return after / before;
}

// The delay is a whole number of periods, so the margin is met within half a period of some 1.5 s.
TEST(AttitudePd, LosesStabilityAtItsDelayMargin) {
  EXPECT_LT(growth_with_delay(0.99 * delay_margin()), 0.9);
  EXPECT_GT(growth_with_delay(1.01 * delay_margin()), 1.1);
}

}  // namespace
}  // namespace netpocket
