// Winch: a drum with inertia that winds a mass in, against the solution of its equations; control, brake, jam, energy.

#include "engine/control/winch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace netpocket {
namespace {

constexpr double kDrumRadius = 0.05, kDrumInertia = 0.02,
                 kDrumMass = kDrumInertia / (kDrumRadius * kDrumRadius);  // m, kg m^2, kg
constexpr double kLoadMass = 200, kRopeStiffness = 5e4;                   // kg, N/m

// A mass that the winch pulls through an elastic rope without mass.
class Load {
 public:
  Load(const WinchSettings& settings, double length) : winch(settings, length), position_(length) {}

  double tension() const { return std::max(0.0, kRopeStiffness * (position_ - winch.motion().length)); }
  void step(double dt, double pull = 0) {
    const double now = tension();
    velocity_ += dt * (pull - now) / kLoadMass;
    position_ += dt * velocity_;
    winch.step(now, dt);
  }
  double velocity() const { return velocity_; }

  Winch winch;

 private:
  double position_, velocity_ = 0;
};

WinchSettings test_winch() { return {.drum_radius = kDrumRadius, .drum_inertia = kDrumInertia, .most_torque = 20}; }

// M x'' = -T, m L'' = T - F, T = k (x - L): the centre of both masses accelerates by -F/(M + m), and the stretch swings
// as F/(m w^2) (1 - cos w t), w^2 = k (1/M + 1/m).
TEST(Winch, WindsAMassAsItsEquationsSay) {
  constexpr double kTorque = 10, kForce = kTorque / kDrumRadius, kStep = 2e-6;
  Load load(test_winch(), 10);
  load.winch.command({.mode = WinchMode::torque, .value = kTorque});
  const double w2 = kRopeStiffness * (1 / kLoadMass + 1 / kDrumMass);
  for (int i = 1; i <= 500'000; ++i) {
    load.step(kStep);
    if (i % 1000 != 0) continue;
    const double t = i * kStep, stretch = kForce / (kDrumMass * w2) * (1 - std::cos(std::sqrt(w2) * t));
    const double centre = 10 - 0.5 * kForce / (kLoadMass + kDrumMass) * t * t;
    ASSERT_NEAR(load.winch.motion().length, centre - kLoadMass / (kLoadMass + kDrumMass) * stretch, 2e-6) << t;
    ASSERT_NEAR(load.tension(), kRopeStiffness * stretch, 0.05) << t;
  }
}

// m L'' = T for a drum without motor and brake; the clutch lets T - slip through a brake that would hold more, and a
// drum that has paid out all of its rope stops.
TEST(Winch, ClutchSlipsAndRopeEnds) {
  constexpr double kStep = 1e-4, kTension = 30, kSlip = 20;
  Winch idle(test_winch(), 5);
  idle.command({.mode = WinchMode::torque, .value = 0});
  WinchSettings settings = test_winch();
  settings.slip_tension = kSlip;
  settings.most_length = 6;
  Winch braked(settings, 5);
  braked.command({.brake = true});
  for (int i = 0; i < 1000; ++i) {
    idle.step(kTension, kStep);
    braked.step(0.99 * kSlip, kStep);
  }
  EXPECT_NEAR(idle.motion().rate, kTension / kDrumMass * 0.1, 1e-12);
  EXPECT_NEAR(idle.motion().length, 5 + 0.5 * kTension / kDrumMass * 0.01, 1e-4);
  EXPECT_EQ(braked.motion().length, 5) << "held below the clutch's limit, though the brake could bear 2000 N";
  for (int i = 0; i < 1000; ++i) braked.step(kTension, kStep);
  EXPECT_NEAR(braked.motion().rate, (kTension - kSlip) / kDrumMass * 0.1, 1e-12);
  EXPECT_NEAR(braked.losses(), kSlip * (braked.motion().length - 5), 1e-3);
  for (int i = 0; i < 20000; ++i) braked.step(kTension, kStep);
  EXPECT_EQ(braked.motion().length, 6);
  EXPECT_NEAR(braked.rope_work(), braked.losses() + braked.kinetic_energy(), 1e-9);
  settings.most_length = 4;
  EXPECT_THROW(Winch(settings, 5), std::invalid_argument);
}

// Work and energy: motor + rope = kinetic + losses, in every mode, braked, jammed and at the least length.
TEST(Winch, EnergyBalances) {
  WinchSettings settings = test_winch();
  settings.rate_gain = 500;
  settings.brake_torque = 3;
  settings.least_length = 9.7;
  Load load(settings, 10);
  const auto run = [&](const WinchCommand& command, double time) {
    load.winch.command(command);
    for (double t = 0; t < time; t += 1e-4) {
      load.step(1e-4, 40);
      const Winch& winch = load.winch;
      ASSERT_NEAR(winch.motor_work() + winch.rope_work(), winch.kinetic_energy() + winch.losses(), 1e-10);
    }
  };
  run({.mode = WinchMode::rate, .value = -0.2}, 1);
  EXPECT_EQ(load.winch.losses(), 0);
  run({.brake = true}, 1);
  EXPECT_GT(load.winch.losses(), 0.01);
  run({.mode = WinchMode::rate, .value = -0.5}, 1);
  EXPECT_EQ(load.winch.motion().length, 9.7);
  run({.mode = WinchMode::rate, .value = 0.5}, 0.5);
  EXPECT_GT(load.winch.kinetic_energy(), 0.1);
  load.winch.jam(true);
  run({.mode = WinchMode::rate, .value = 0.5}, 0.1);
  EXPECT_EQ(load.winch.motion().rate, 0);
  EXPECT_EQ(load.winch.kinetic_energy(), 0);
}

// The rate loop: m v' = -P (v - r) - I int (v - r) + T. Without load and integral v = r (1 - exp(-P t/m)).
TEST(Winch, RateFollowsItsLoop) {
  Winch winch(test_winch(), 10);
  winch.command({.mode = WinchMode::rate, .value = -0.2});
  for (int i = 1; i <= 2000; ++i) {
    winch.step(0, 1e-4);
    ASSERT_NEAR(winch.motion().rate, -0.2 * (1 - std::exp(-100 / kDrumMass * i * 1e-4)), 2e-4 * 0.2 * 10);
  }
  // A steady tension T leaves T/P, which the integral takes up.
  for (int i = 0; i < 20'000; ++i) winch.step(5, 1e-4);
  EXPECT_NEAR(winch.motion().rate, -0.2 + 5.0 / 100, 1e-9);
  WinchSettings settings = test_winch();
  settings.rate_integral = 200;
  Winch integral(settings, 10);
  integral.command({.mode = WinchMode::rate, .value = -0.2});
  for (int i = 0; i < 100'000; ++i) integral.step(5, 1e-4);
  EXPECT_NEAR(integral.motion().rate, -0.2, 1e-9);
  EXPECT_NEAR(integral.torque(), 5 * kDrumRadius, 1e-9);
  EXPECT_NEAR(integral.power(), 5 * 0.2, 1e-9);
}

// Routh, for P = 2000 N s/m, I = 1000 N/m, K_L = 0.5/s and the mass M = 208 kg: stable for P (P K_L + I) > M I K_L.
TEST(Winch, ReachesACommandedLength) {
  WinchSettings settings = test_winch();
  settings.rate_gain = 2000;
  settings.rate_integral = 1000;
  settings.length_gain = 0.5;
  Load load(settings, 10);
  load.winch.command({.mode = WinchMode::length, .value = 9});
  double fastest = 0;
  for (int i = 0; i < 300'000; ++i) {
    load.step(1e-4, 20);  // something pulls at the mass
    fastest = std::max(fastest, std::abs(load.winch.motion().rate));
  }
  EXPECT_NEAR(load.winch.motion().length, 9, 1e-3);
  EXPECT_NEAR(load.tension(), 20, 0.5);
  EXPECT_GT(fastest, 0.1);
}

// A length that moves: with its rate fed forward the drum follows without lag, once the loops have settled.
TEST(Winch, FollowsAMovingLength) {
  WinchSettings settings = test_winch();
  settings.rate_gain = 2000;
  Winch winch(settings, 10);
  for (int i = 0; i < 20'000; ++i) {
    winch.command({.mode = WinchMode::length, .value = 10 - 0.1 * i * 1e-3, .rate = -0.1});
    winch.step(0, 1e-3);
  }
  EXPECT_NEAR(winch.motion().length, 10 - 0.1 * 20, 1e-3);
}

// The derivative of the tension adds D_T T' to the wanted rate, from the second step on.
TEST(Winch, TensionRateCounts) {
  WinchSettings settings = test_winch();
  settings.tension_gain = 0;
  settings.tension_derivative = 1e-3;
  Winch winch(settings, 10);
  winch.command({.mode = WinchMode::tension, .value = 0});
  winch.step(5, 1e-6);
  EXPECT_EQ(winch.torque(), 0);
  winch.step(5 + 100e-6, 1e-6);
  EXPECT_NEAR(winch.torque(), -100 * 1e-3 * 100 * kDrumRadius, 1e-3);
}

// The tension of a fixed end k (L0 - L): rate = K_T (T - T_w) makes it approach T_w as exp(-k K_T t), while the rate
// loop is fast.
TEST(Winch, HoldsACommandedTension) {
  constexpr double kSoft = 1000, kGain = 2e-4;
  WinchSettings settings = test_winch();
  settings.tension_gain = kGain;
  settings.rate_gain = 5e3;
  settings.rate_integral = 1e5;
  Winch winch(settings, 10);
  winch.command({.mode = WinchMode::tension, .value = 80});
  double tension = 0, rising = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    winch.step(tension, 1e-4);
    tension = std::max(0.0, kSoft * (10 - winch.motion().length));
    if (i == 50'000) rising = tension;
  }
  EXPECT_NEAR(rising, 80 * (1 - std::exp(-kSoft * kGain * 5)), 2);
  EXPECT_NEAR(tension, 80, 1e-6);
}

// A slack rope is taken up at the take-up rate until it is taut. Without integral the drum then stands where
// K_T (T - T_w) + T/P = 0.
TEST(Winch, TakesUpSlack) {
  WinchSettings settings = test_winch();
  settings.take_up_rate = 0.3;
  settings.tension_gain = 1e-3;
  settings.rate_gain = 1000;
  Winch winch(settings, 10);
  winch.command({.mode = WinchMode::tension, .value = 10});
  while (winch.motion().length > 9) winch.step(0, 1e-3);
  EXPECT_NEAR(winch.motion().rate, -0.3, 1e-6);
  const auto tension = [&] { return std::max(0.0, 2000 * (9 - winch.motion().length)); };
  for (int i = 0; i < 100'000; ++i) winch.step(tension(), 1e-4);
  EXPECT_NEAR(tension(), 10 * 1e-3 / (1e-3 + 1.0 / 1000), 1e-6);
}

TEST(Winch, MotorGivesAtMostItsTorque) {
  Winch winch(test_winch(), 10);
  winch.command({.mode = WinchMode::torque, .value = 500});
  winch.step(0, 0.01);
  EXPECT_EQ(winch.torque(), 20);
  EXPECT_DOUBLE_EQ(winch.motion().acceleration, -20 / kDrumRadius / kDrumMass);
  winch.command({.mode = WinchMode::rate, .value = 100});
  winch.step(0, 0.01);
  EXPECT_GE(winch.torque(), -20);
}

// The brake holds below its torque and slips above: m a = T - B/r.
TEST(Winch, BrakeHoldsAndSlips) {
  WinchSettings settings = test_winch();
  settings.brake_torque = 3;  // 60 N
  Winch winch(settings, 10);
  winch.command({.brake = true});
  for (int i = 0; i < 1000; ++i) winch.step(59, 1e-3);
  EXPECT_EQ(winch.motion(), (RopeMotion{10, 0, 0}));
  for (int i = 0; i < 1000; ++i) winch.step(100, 1e-3);
  EXPECT_NEAR(winch.motion().rate, 40 / kDrumMass, 1e-12);
  for (int i = 0; i < 5000; ++i) winch.step(20, 1e-3);
  EXPECT_EQ(winch.motion().rate, 0);
}

// While the brake holds, the integral of the rate loop is given up: after that the first torque is P times the error.
TEST(Winch, BrakeResetsTheRateLoop) {
  WinchSettings settings = test_winch();
  settings.rate_integral = 1000;
  Winch winch(settings, 10);
  winch.command({.mode = WinchMode::rate, .value = 0.1});
  for (int i = 0; i < 1000; ++i) winch.step(50, 1e-3);
  EXPECT_GT(winch.torque(), 40 * kDrumRadius);
  winch.command({.brake = true});
  for (int i = 0; i < 1000; ++i) winch.step(50, 1e-3);
  winch.command({.mode = WinchMode::rate, .value = 0.1});
  winch.step(50, 1e-6);
  EXPECT_NEAR(winch.torque(), -100 * 0.1 * kDrumRadius, 1e-4);
}

TEST(Winch, JamHoldsAgainstEverything) {
  Winch winch(test_winch(), 10);
  winch.command({.mode = WinchMode::rate, .value = -0.5});
  for (int i = 0; i < 1000; ++i) winch.step(0, 1e-3);
  winch.jam(true);
  const double length = winch.motion().length;
  for (int i = 0; i < 1000; ++i) winch.step(1e5, 1e-3);
  EXPECT_EQ(winch.motion(), (RopeMotion{length, 0, 0}));
  winch.jam(false);
  for (int i = 0; i < 1000; ++i) winch.step(0, 1e-3);
  EXPECT_LT(winch.motion().length, length);
}

TEST(Winch, NeverWindsBelowTheLeastLength) {
  WinchSettings settings = test_winch();
  settings.least_length = 2;
  Winch winch(settings, 3);
  winch.command({.mode = WinchMode::torque, .value = 20});
  for (int i = 0; i < 3000; ++i) EXPECT_GE(winch.step(0, 1e-3).length, 2);
  EXPECT_EQ(winch.motion(), (RopeMotion{2, 0, 0}));
}

TEST(Winch, RefusesWrongSettings) {
  const auto refused = [](const WinchSettings& settings, double length) {
    EXPECT_THROW(Winch(settings, length), std::invalid_argument);
  };
  refused({.drum_radius = 0}, 10);
  refused({.drum_inertia = std::nan("")}, 10);
  refused({.most_torque = -1}, 10);
  refused({.least_length = 1}, 0.5);
}

}  // namespace
}  // namespace netpocket
