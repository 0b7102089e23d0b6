#include "engine/contact/force_law.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>
#include <random>

#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

class VerificationForceLaw : public test::VerificationTest {};

// Net cord (E = 12 GPa, d = 4 mm) on an aluminium target of 4.5 m radius; a piece of cord of 5 g.
const double kStiffness = hertz_stiffness(effective_modulus({12e9, 0.3}, {70e9, 0.33}), effective_radius(0.002, 4.5));
constexpr double kCordMass = 0.005, kTargetMass = 200;
const double kMass = effective_mass(kCordMass, kTargetMass);

// State of the head-on collision of two bodies, as one body of the effective mass.
struct Impact {
  double penetration = 0;
  double separation_speed;
};

struct ImpactRecord {
  double rebound_speed = 0;
  double largest_penetration = 0;
  double duration = 0;
};

double hertz_duration(double stiffness, double mass, double speed) {
  return 3.218065 * std::pow(mass * mass / (stiffness * stiffness * speed), 0.2);
}

// Runge-Kutta from first touch to the end of contact, which is when the force or the penetration vanishes.
template <class Force>
ImpactRecord collide(const Force& force, double mass, double speed, double dt) {
  Impact now{0, -speed};
  ImpactRecord record;
  const auto derivative = [&](const Impact& s) {
    return Impact{-s.separation_speed, force(s.penetration, s.separation_speed) / mass};
  };
  const auto moved = [](const Impact& s, const Impact& rate, double h) {
    return Impact{s.penetration + h * rate.penetration, s.separation_speed + h * rate.separation_speed};
  };
  while (true) {
    const Impact k1 = derivative(now), k2 = derivative(moved(now, k1, dt / 2)), k3 = derivative(moved(now, k2, dt / 2)),
                 k4 = derivative(moved(now, k3, dt));
    const Impact next = moved(moved(moved(moved(now, k1, dt / 6), k2, dt / 3), k3, dt / 3), k4, dt / 6);
    const bool parted = next.separation_speed > 0 && force(next.penetration, next.separation_speed) == 0;
    if (parted || next.penetration <= 0) {
      record.rebound_speed = next.separation_speed;
      return record;
    }
    now = next;
    record.duration += dt;
    record.largest_penetration = std::max(record.largest_penetration, now.penetration);
  }
}

TEST_F(VerificationForceLaw, EffectiveQuantities) {
  EXPECT_NEAR(effective_modulus({12e9, 0.3}, {70e9, 0.33}), 11.2914e9, 0.0001e9);
  EXPECT_DOUBLE_EQ(effective_modulus({2e9, 0}, {2e9, 0}), 1e9);
  EXPECT_DOUBLE_EQ(effective_radius(0.3, 0.6), 0.2);
  EXPECT_DOUBLE_EQ(effective_radius(0.3, std::numeric_limits<double>::infinity()), 0.3);
  EXPECT_DOUBLE_EQ(effective_mass(2, 3), 1.2);
  EXPECT_DOUBLE_EQ(effective_mass(2, std::numeric_limits<double>::infinity()), 2);
  EXPECT_NEAR(kStiffness, 6.7e8, 0.05e8);  // the order that the model's trials used
}

// Antypov & Elliott (2011); six digits as tabulated in the verification plan.
TEST_F(VerificationForceLaw, DampingFromRestitution) {
  for (const auto& [restitution, alpha] :
       {std::pair{0.9, 0.074950}, {0.8, 0.158426}, {0.5, 0.481769}, {0.3, 0.800193}}) {
    expect_value("damping alpha for c_r = " + std::to_string(restitution).substr(0, 3),
                 restitution_damping(restitution), alpha, 5e-7,
                 "Antypov & Elliott (2011), six digits (verification case V5)");
  }
  EXPECT_DOUBLE_EQ(restitution_damping(0), std::sqrt(5.0));
  EXPECT_EQ(restitution_damping(1), 0);
  EXPECT_GT(restitution_damping(1e-300), 2.23);  // continuous towards 0, though slowly: the logarithm
  EXPECT_EQ(restitution_damping(1.5), 0);
  EXPECT_EQ(restitution_damping(-0.1), restitution_damping(0));
}

TEST_F(VerificationForceLaw, NothingActsAcrossAGap) {
  const NormalLaw law = make_normal_law(kStiffness, 0.5, kMass);
  for (double penetration : {0.0, -1e-12, -1.0}) {
    for (double speed : {-10.0, 0.0, 10.0}) {
      EXPECT_EQ(normal_force(law, penetration, speed), 0);
      EXPECT_EQ(repulsive_normal_force(law, penetration, speed), 0);
      EXPECT_EQ(stepped_normal_force(law, penetration, {speed, speed}, 1 / kMass, 1e-4), 0);
      EXPECT_EQ(elastic_energy(law, penetration), 0);
    }
  }
}

TEST_F(VerificationForceLaw, ElasticEnergyIsTheWorkOfTheSpring) {
  const NormalLaw law{kStiffness, 0};
  const double d = 2e-5, h = 1e-9;
  EXPECT_NEAR((elastic_energy(law, d + h) - elastic_energy(law, d - h)) / (2 * h), normal_force(law, d, 0),
              1e-8 * normal_force(law, d, 0));
}

// The point of this damper: the same coefficient of restitution at every speed.
TEST_F(VerificationForceLaw, ReboundIsTheCoefficientOfRestitutionAtAnySpeed) {
  double largest_error = 0;
  for (double restitution : {0.3, 0.5, 0.8, 0.9}) {
    const NormalLaw law = make_normal_law(kStiffness, restitution, kMass);
    for (double speed : {0.1, 1.0, 10.0}) {
      const auto force = [&](double d, double v) { return normal_force(law, d, v); };
      const double dt = hertz_duration(kStiffness, kMass, speed) / 50000;
      const double rebound = collide(force, kMass, speed, dt).rebound_speed / speed;
      largest_error = std::max(largest_error, std::abs(rebound - restitution));
      // The damper starts like d^(1/4): Runge-Kutta is of order 5/4 there, 50000^-1.25 = 1e-6.
    }
  }
  expect_below("rebound at c_r = 0.3, 0.5, 0.8, 0.9 and 0.1, 1, 10 m/s: largest error", largest_error, 5e-6,
               "Antypov & Elliott (2011): exactly c_r at any speed; Runge-Kutta is of order 5/4 there: 50000^-1.25");
}

TEST_F(VerificationForceLaw, ReboundWithoutTheAdhesiveTailIsFaster) {
  const NormalLaw law = make_normal_law(kStiffness, 0.5, kMass);
  for (double speed : {0.1, 1.0, 10.0}) {
    const auto force = [&](double d, double v) { return repulsive_normal_force(law, d, v); };
    const double dt = hertz_duration(kStiffness, kMass, speed) / 50000;
    expect_value("rebound without the adhesive tail, c_r = 0.5, at " + std::to_string(speed).substr(0, 4) + " m/s",
                 collide(force, kMass, speed, dt).rebound_speed / speed, 0.55028, 1e-5,
                 "verification case V5, five digits");
  }
}

TEST_F(VerificationForceLaw, ReboundAtTheEndsOfTheRange) {
  const auto rebound = [](double restitution) {
    const NormalLaw law = make_normal_law(kStiffness, restitution, kMass);
    const auto force = [&](double d, double v) { return repulsive_normal_force(law, d, v); };
    return collide(force, kMass, 1, hertz_duration(kStiffness, kMass, 1) / 20000).rebound_speed;
  };
  EXPECT_NEAR(rebound(1), 1, 1e-6);
  // Critically damped without its tail: the spring still gives something back, less than for 0.3.
  EXPECT_GT(rebound(0), 0);
  EXPECT_LT(rebound(0), rebound(0.3));
}

// Hertz (1882): 5/4 and a quotient of gamma functions.
TEST_F(VerificationForceLaw, UndampedImpactIsThatOfHertz) {
  const NormalLaw law = make_normal_law(kStiffness, 1, kMass);
  const auto force = [&](double d, double v) { return normal_force(law, d, v); };
  for (double speed : {0.1, 1.0, 10.0}) {
    const double duration = hertz_duration(kStiffness, kMass, speed);
    const ImpactRecord record = collide(force, kMass, speed, duration / 20000);
    const double deepest = 1.093362 * std::pow(kMass * speed * speed / kStiffness, 0.4);
    EXPECT_NEAR(depth_of_impact(kMass, kStiffness, speed) / deepest, 1, 1e-6);
    const std::string at = " at " + std::to_string(speed).substr(0, 4) + " m/s";
    expect_relative("undamped impact: deepest penetration, m," + at, record.largest_penetration, deepest, 1e-6,
                    "1.093362 (m v^2/K)^0.4, Hertz (verification case V5); seven digits of the constant");
    expect_relative("undamped impact: duration, s," + at, record.duration, duration, 1e-4,
                    "3.218065 (m^2/(K^2 v))^0.2, Hertz (verification case V5); steps of duration/20000");
    expect_relative("undamped impact: rebound, m/s," + at, record.rebound_speed, speed, 1e-6, "no loss");
  }
}

TEST(ForceLaw, StiffnessOfAnImpactInvertsHertzsDuration) {
  for (const double duration : {1e-4, 1e-3}) {
    for (const double speed : {0.1, 10.0}) {
      const double stiffness = stiffness_of_impact(kMass, speed, duration);
      EXPECT_NEAR(hertz_duration(stiffness, kMass, speed), duration, 1e-12 * duration);
    }
  }
}

// Leapfrog with the stepped force from first touch, which comes `phase` of a step before a step's end.
double stepped_rebound(const NormalLaw& law, double speed, double dt, double phase) {
  Impact now{phase * speed * dt, -speed};
  while (now.penetration > 0) {
    const double force =
        stepped_normal_force(law, now.penetration, {now.separation_speed, now.separation_speed}, 1 / kMass, dt);
    now.separation_speed += force / kMass * dt;
    now.penetration -= now.separation_speed * dt;
  }
  return now.separation_speed;
}

struct Rebounds {
  double smallest = 2, mean = 0, largest = 0;  // of the speed of approach
};

Rebounds rebounds_over_phases(const NormalLaw& law, double speed, double dt) {
  constexpr int kPhases = 50;
  Rebounds result;
  for (int i = 0; i < kPhases; ++i) {
    const double rebound = stepped_rebound(law, speed, dt, (i + 0.5) / kPhases) / speed;
    result.smallest = std::min(result.smallest, rebound);
    result.largest = std::max(result.largest, rebound);
    result.mean += rebound / kPhases;
  }
  return result;
}

NormalLaw resolved_law(double restitution, double dt) {
  return make_normal_law(stiffness_of_impact(kMass, 1, 8 * dt), restitution, kMass);
}

// The point of the softened contact: the law's own rebound, whatever the step.
TEST(SteppedForce, ReboundIsThatOfTheLawAtAnyStep) {
  for (const double restitution : {0.2, 0.5, 0.8, 1.0}) {
    const NormalLaw continuous = make_normal_law(kStiffness, restitution, kMass);
    const auto force = [&](double d, double v) { return repulsive_normal_force(continuous, d, v); };
    const double exact = collide(force, kMass, 1, hertz_duration(kStiffness, kMass, 1) / 20000).rebound_speed;
    for (const double dt : {1e-5, 1e-4, 1e-3}) {
      for (const double speed : {0.01, 0.1, 1.0, 10.0}) {
        const Rebounds rebounds = rebounds_over_phases(resolved_law(restitution, dt), speed, dt);
        EXPECT_NEAR(rebounds.mean, exact, 0.01) << "c_r " << restitution << ", dt " << dt << ", " << speed << " m/s";
        EXPECT_NEAR(rebounds.smallest, exact, 0.04);
        EXPECT_NEAR(rebounds.largest, exact, 0.08);  // where the damper first acts at full depth of a step
      }
    }
  }
}

// What the material's own stiffness does with steps that do not resolve it: the implicit part takes energy, the impulse
// lies between that of a contact without rebound and the whole. Why a run softens its contacts.
TEST(SteppedForce, StiffContactLosesItsRebound) {
  const NormalLaw law = make_normal_law(kStiffness, 0.5, kMass);
  const Rebounds coarse = rebounds_over_phases(law, 0.3, 2e-4);
  std::printf("material's stiffness, dt 2e-4 s: rebound %.3f [%.3f, %.3f] for 0.550\n", coarse.mean, coarse.smallest,
              coarse.largest);
  EXPECT_LT(coarse.mean, 0.4);
  EXPECT_NEAR(rebounds_over_phases(law, 0.3, 2e-6).mean, 0.55028, 0.005);
}

TEST(SteppedForce, TendsToTheExplicitLawForSmallSteps) {
  const NormalLaw law = make_normal_law(kStiffness, 0.5, kMass);
  double previous = 0;
  for (const double dt : {1e-7, 5e-8, 2.5e-8}) {
    double error = 0;
    for (const double v : {-1.0, -0.2, 0.05}) {
      const double exact = repulsive_normal_force(law, 1e-5, v);
      error = std::max(error, std::abs(stepped_normal_force(law, 1e-5, {v, v}, 1 / kMass, dt) / exact - 1));
    }
    if (previous > 0) {
      EXPECT_NEAR(previous / error, 2, 0.05);  // of one force; a collision is of second order
    }
    previous = error;
  }
}

// Whatever the stiffness, step and speed: nothing leaves faster than it came, but for the first step's depth, which the
// leapfrog scheme sees as stored energy (3 % of the speed where it is explicit to its limit).
TEST(SteppedForce, HardlyAddsSpeed) {
  std::mt19937 random(3);
  const auto any = [&](double low, double high) {  // over orders of magnitude
    return std::exp(std::uniform_real_distribution<double>(std::log(low), std::log(high))(random));
  };
  std::uniform_real_distribution<double> part(0, 1);
  double largest = 0;
  for (int i = 0; i < 20000; ++i) {
    const NormalLaw law = make_normal_law(any(1e2, 1e12), part(random), kMass);
    const double dt = any(1e-6, 1e-2), speed = any(1e-3, 100);
    if (hertz_duration(law.stiffness, kMass, speed) > 500 * dt) continue;  // many steps: covered above
    const double rebound = stepped_rebound(law, speed, dt, part(random));
    ASSERT_TRUE(std::isfinite(rebound));
    largest = std::max(largest, rebound / speed);
  }
  std::printf("largest rebound %.3f of the speed of approach\n", largest);
  EXPECT_LT(largest, 1.1);
}

// A cord pressed against the target by a constant load ends at rest, with the spring carrying that load, at any step.
TEST(SteppedForce, SettlesUnderLoadAtAnyStep) {
  const double load = 20;
  for (const double dt : {1e-6, 2e-5, 2e-4, 1e-3}) {
    const NormalLaw law = resolved_law(0.5, dt);
    Impact now{-1e-6, 0};
    double force = 0;
    for (int i = 0; i < 20000; ++i) {
      const double pressed = now.separation_speed - load / kMass * dt;
      force = stepped_normal_force(law, now.penetration, {now.separation_speed, pressed}, 1 / kMass, dt);
      now.separation_speed = pressed + force / kMass * dt;
      now.penetration -= now.separation_speed * dt;
    }
    EXPECT_NEAR(force, load, 1e-9 * load) << "dt " << dt;
    EXPECT_NEAR(law.stiffness * std::pow(now.penetration, 1.5), load, 1e-9 * load) << "dt " << dt;
  }
}

}  // namespace
}  // namespace netpocket
