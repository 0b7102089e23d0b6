#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "engine/contact/force_law.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

class VerificationFriction : public test::VerificationTest {};

constexpr double kGravity = 9.81, kFriction = 0.4, kFrictionVelocity = 1e-3;

struct Slide {
  double speed = 0;          // m/s, down the slope
  double acceleration = 0;   // m/s^2, mean over the second half
  double largest_power = 0;  // W, of the friction
};

// A block of 2 kg that starts at rest on an incline: pressed into it through the normal law, dragged along it by
// gravity.
Slide slide(double angle, double dt, double end, double friction_velocity = kFrictionVelocity) {
  const double mass = 2;
  const NormalLaw law = make_normal_law(1e7, 0.2, mass);
  double penetration = std::pow(mass * kGravity * std::cos(angle) / law.stiffness, 2.0 / 3.0);  // in balance
  double separation = 0;
  Slide result;
  const int steps = static_cast<int>(std::lround(end / dt));
  double half_speed = 0;
  for (int i = 0; i < steps; ++i) {
    if (i == steps / 2) half_speed = result.speed;
    const double pressed = separation - kGravity * std::cos(angle) * dt;
    const double normal = stepped_normal_force(law, penetration, {separation, pressed}, 1 / mass, dt);
    const double driven = result.speed + kGravity * std::sin(angle) * dt;  // friction sees the pull of this step
    const double resistance = sliding_resistance(kFriction, friction_velocity, normal, std::abs(driven), 1 / mass, dt);
    const double friction = -resistance * driven;
    separation += (normal / mass - kGravity * std::cos(angle)) * dt;
    penetration -= separation * dt;
    result.speed = driven + friction / mass * dt;
    result.largest_power = std::max(result.largest_power, friction * 0.5 * (driven + result.speed));
  }
  result.acceleration = (result.speed - half_speed) / ((steps - steps / 2) * dt);
  return result;
}

TEST_F(VerificationFriction, BlockSlidesAboveTheAngleOfFriction) {
  for (double angle : {0.45, 0.6, 1.0}) {  // atan(0.4) = 0.3805
    const double expected = kGravity * (std::sin(angle) - kFriction * std::cos(angle));
    const Slide block = slide(angle, 1e-4, 1);
    expect_relative("block sliding down " + std::to_string(angle).substr(0, 4) + " rad, mu = 0.4: acceleration, m/s^2",
                    block.acceleration, expected, 1e-9, "g (sin - mu cos) (verification case V5); round-off");
    EXPECT_LE(block.largest_power, 0);
  }
}

TEST_F(VerificationFriction, BlockSticksBelowTheAngleOfFriction) {
  for (double angle : {0.1, 0.3, 0.37}) {
    const Slide block = slide(angle, 1e-4, 1);
    // What the regularisation leaves: creep at the share of the friction velocity that carries the load. Friction sees
    // it before, `speed` is it after friction has taken back the pull of one step.
    const double creep = kFrictionVelocity * std::tan(angle) / kFriction;
    expect_relative("block sticking at " + std::to_string(angle).substr(0, 4) + " rad, mu = 0.4: creep, m/s",
                    block.speed, creep - kGravity * std::sin(angle) * 1e-4, 1e-8,
                    "sticks below atan(mu) (verification case V5); the regularised law's creep v_f tan(angle)/mu, less "
                    "one step's pull");
    EXPECT_LT(std::abs(block.acceleration), 1e-9);
    EXPECT_LE(block.largest_power, 0);
  }
}

TEST_F(VerificationFriction, WithoutRegularisationTheBlockStandsStill) {
  const Slide block = slide(0.3, 1e-4, 1, 0);
  EXPECT_EQ(block.speed, 0);
}

TEST_F(VerificationFriction, FullyDevelopedAboveTheFrictionVelocity) {
  const double normal = 50;
  const auto force = [&](double speed) { return speed * sliding_resistance(0.4, 1e-3, normal, speed, 1e-6, 1e-6); };
  EXPECT_DOUBLE_EQ(force(1e-3), 20);
  EXPECT_DOUBLE_EQ(force(5.0), 20);
  EXPECT_DOUBLE_EQ(force(5e-4), 10);
  EXPECT_EQ(force(0), 0);
}

TEST_F(VerificationFriction, NeverTurnsSlidingRoundNorFeedsIt) {
  std::mt19937 random(5);
  const auto any = [&](double low, double high) {
    return std::exp(std::uniform_real_distribution<double>(std::log(low), std::log(high))(random));
  };
  for (int i = 0; i < 100000; ++i) {
    const double speed = any(1e-9, 100), inverse_mass = any(1e-4, 1e4), dt = any(1e-7, 1e-1), normal = any(1e-6, 1e6);
    const double resistance = sliding_resistance(any(0.01, 2), any(1e-5, 1), normal, speed, inverse_mass, dt);
    ASSERT_GE(resistance, 0);
    const double after = speed * (1 - resistance * inverse_mass * dt);
    ASSERT_GE(after, -1e-15 * speed);
    ASSERT_LE(after, speed);
  }
}

TEST_F(VerificationFriction, FiniteWithoutForceSpeedOrRegularisation) {
  EXPECT_EQ(0 * sliding_resistance(0.4, 0, 0, 0, 1, 1e-4), 0);
  EXPECT_EQ(0 * sliding_resistance(0.4, 0, 10, 0, 1, 1e-4), 0);
  EXPECT_EQ(sliding_resistance(0.4, 1e-3, 0, 0, 1, 1e-4), 0);
  EXPECT_EQ(sliding_resistance(0, 1e-3, 10, 1, 1, 1e-4), 0);
}

}  // namespace
}  // namespace netpocket
