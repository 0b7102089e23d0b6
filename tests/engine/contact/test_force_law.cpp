#include <gtest/gtest.h>

#include <cstdio>
#include <limits>
#include <random>

#include "engine/contact/force_law.h"

namespace netpocket {
namespace {

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

TEST(ForceLaw, EffectiveQuantities) {
  EXPECT_NEAR(effective_modulus({12e9, 0.3}, {70e9, 0.33}), 11.2914e9, 0.0001e9);
  EXPECT_DOUBLE_EQ(effective_modulus({2e9, 0}, {2e9, 0}), 1e9);
  EXPECT_DOUBLE_EQ(effective_radius(0.3, 0.6), 0.2);
  EXPECT_DOUBLE_EQ(effective_radius(0.3, std::numeric_limits<double>::infinity()), 0.3);
  EXPECT_DOUBLE_EQ(effective_mass(2, 3), 1.2);
  EXPECT_DOUBLE_EQ(effective_mass(2, std::numeric_limits<double>::infinity()), 2);
  EXPECT_NEAR(kStiffness, 6.7e8, 0.05e8);  // the order that the model's trials used
}

// Antypov & Elliott (2011); six digits as tabulated in the verification plan.
TEST(ForceLaw, DampingFromRestitution) {
  EXPECT_NEAR(restitution_damping(0.9), 0.074950, 5e-7);
  EXPECT_NEAR(restitution_damping(0.8), 0.158426, 5e-7);
  EXPECT_NEAR(restitution_damping(0.5), 0.481769, 5e-7);
  EXPECT_NEAR(restitution_damping(0.3), 0.800193, 5e-7);
  EXPECT_DOUBLE_EQ(restitution_damping(0), std::sqrt(5.0));
  EXPECT_EQ(restitution_damping(1), 0);
  EXPECT_GT(restitution_damping(1e-300), 2.23);  // continuous towards 0, though slowly: the logarithm
  EXPECT_EQ(restitution_damping(1.5), 0);
  EXPECT_EQ(restitution_damping(-0.1), restitution_damping(0));
}

TEST(ForceLaw, NothingActsAcrossAGap) {
  const NormalLaw law = make_normal_law(kStiffness, 0.5, kMass);
  for (double penetration : {0.0, -1e-12, -1.0}) {
    for (double speed : {-10.0, 0.0, 10.0}) {
      EXPECT_EQ(normal_force(law, penetration, speed), 0);
      EXPECT_EQ(repulsive_normal_force(law, penetration, speed), 0);
      EXPECT_EQ(semi_implicit_normal_force(law, penetration, speed, 1 / kMass, 1e-4), 0);
      EXPECT_EQ(elastic_energy(law, penetration), 0);
    }
  }
}

TEST(ForceLaw, ElasticEnergyIsTheWorkOfTheSpring) {
  const NormalLaw law{kStiffness, 0};
  const double d = 2e-5, h = 1e-9;
  EXPECT_NEAR((elastic_energy(law, d + h) - elastic_energy(law, d - h)) / (2 * h), normal_force(law, d, 0),
              1e-8 * normal_force(law, d, 0));
}

// The point of this damper: the same coefficient of restitution at every speed.
TEST(ForceLaw, ReboundIsTheCoefficientOfRestitutionAtAnySpeed) {
  double largest_error = 0;
  for (double restitution : {0.3, 0.5, 0.8, 0.9}) {
    const NormalLaw law = make_normal_law(kStiffness, restitution, kMass);
    for (double speed : {0.1, 1.0, 10.0}) {
      const auto force = [&](double d, double v) { return normal_force(law, d, v); };
      const double dt = hertz_duration(kStiffness, kMass, speed) / 50000;
      const double rebound = collide(force, kMass, speed, dt).rebound_speed / speed;
      largest_error = std::max(largest_error, std::abs(rebound - restitution));
      // The damper starts like d^(1/4): Runge-Kutta is of order 5/4 there, 50000^-1.25 = 1e-6.
      EXPECT_NEAR(rebound, restitution, 5e-6) << "at " << speed << " m/s";
    }
  }
  std::printf("largest error of the restitution %.1e\n", largest_error);
}

TEST(ForceLaw, ReboundWithoutTheAdhesiveTailIsFaster) {
  const NormalLaw law = make_normal_law(kStiffness, 0.5, kMass);
  for (double speed : {0.1, 1.0, 10.0}) {
    const auto force = [&](double d, double v) { return repulsive_normal_force(law, d, v); };
    const double dt = hertz_duration(kStiffness, kMass, speed) / 50000;
    EXPECT_NEAR(collide(force, kMass, speed, dt).rebound_speed / speed, 0.55028, 1e-5);
  }
}

TEST(ForceLaw, ReboundAtTheEndsOfTheRange) {
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
TEST(ForceLaw, UndampedImpactIsThatOfHertz) {
  const NormalLaw law = make_normal_law(kStiffness, 1, kMass);
  const auto force = [&](double d, double v) { return normal_force(law, d, v); };
  for (double speed : {0.1, 1.0, 10.0}) {
    const double duration = hertz_duration(kStiffness, kMass, speed);
    const ImpactRecord record = collide(force, kMass, speed, duration / 20000);
    const double deepest = 1.093362 * std::pow(kMass * speed * speed / kStiffness, 0.4);
    EXPECT_NEAR(record.largest_penetration / deepest, 1, 1e-6);  // seven digits of the constant
    EXPECT_NEAR(record.duration / duration, 1, 1e-4);            // to the step, duration/20000
    EXPECT_NEAR(record.rebound_speed / speed, 1, 1e-6);
  }
}

// Symplectic Euler with the semi-implicit force, starting `phase` of a step before touch.
double semi_implicit_rebound(const NormalLaw& law, double speed, double dt, double phase) {
  Impact now{-phase * speed * dt, -speed};
  double force = 0;
  do {
    now.penetration -= now.separation_speed * dt;
    force = semi_implicit_normal_force(law, now.penetration, now.separation_speed, 1 / kMass, dt);
    now.separation_speed += force / kMass * dt;
  } while (now.penetration > 0 || now.separation_speed < 0);
  return now.separation_speed;
}

// Mean impulse over the moments of touch within a step, relative to that of the continuous law.
double mean_relative_impulse(double restitution, double dt) {
  const double speed = 0.3;
  const NormalLaw law = make_normal_law(kStiffness, restitution, kMass);
  const auto force = [&](double d, double v) { return repulsive_normal_force(law, d, v); };
  const double exact = collide(force, kMass, speed, hertz_duration(kStiffness, kMass, speed) / 20000).rebound_speed;
  double sum = 0;
  const int phases = 200;
  for (int i = 0; i < phases; ++i) sum += speed + semi_implicit_rebound(law, speed, dt, (i + 0.5) / phases);
  return sum / phases / (speed + exact);
}

// The contact of a piece of cord lasts 0.15 ms. Steps of that size cannot resolve the rebound: the implicit step takes
// energy, so the impulse lies between that of a contact without rebound, 1/(1 + c_r) of the continuous law's, and the
// whole; and it hardly depends on the step.
TEST(SemiImplicit, ImpulseOfALightBodyOnAHeavyOneHardlyDependsOnTheStep) {
  for (double restitution : {0.2, 0.5}) {
    double smallest = 2, largest = 0;
    for (double dt : {2e-4, 1e-4, 5e-5, 2e-5}) {
      const double impulse = mean_relative_impulse(restitution, dt);
      std::printf("c_r %.1f, dt %.0e s: impulse %.3f of the continuous law's\n", restitution, dt, impulse);
      smallest = std::min(smallest, impulse);
      largest = std::max(largest, impulse);
    }
    EXPECT_GT(smallest, 1 / (1 + restitution));
    EXPECT_LT(largest, 1);
    EXPECT_LT(largest - smallest, 0.1);
  }
}

TEST(SemiImplicit, TendsToTheExplicitLaw) {
  const NormalLaw law = make_normal_law(kStiffness, 0.5, kMass);
  double previous = 0;
  for (double dt : {1e-8, 5e-9, 2.5e-9}) {
    double error = 0;
    for (double v : {-1.0, -0.2, 0.05})
      error = std::max(
          error,
          std::abs(semi_implicit_normal_force(law, 1e-5, v, 1 / kMass, dt) / repulsive_normal_force(law, 1e-5, v) - 1));
    if (previous > 0) {
      EXPECT_NEAR(previous / error, 2, 0.02);  // first order
    }
    previous = error;
  }
  EXPECT_LT(std::abs(mean_relative_impulse(0.5, 1e-7) - 1), 2e-3);
}

// After a step, kinetic energy <= before + what the spring has given back. See the header for why.
TEST(SemiImplicit, NeverAddsEnergy) {
  std::mt19937 random(3);
  const auto any = [&](double low, double high) {  // over orders of magnitude
    return std::exp(std::uniform_real_distribution<double>(std::log(low), std::log(high))(random));
  };
  std::bernoulli_distribution coin(0.5);
  for (int i = 0; i < 200000; ++i) {
    const double mass = effective_mass(any(1e-4, 10), any(1, 1e4));
    const NormalLaw law = make_normal_law(any(1e4, 1e10), std::uniform_real_distribution<double>(0, 1)(random), mass);
    const double dt = any(1e-7, 1e-1), penetration = any(1e-9, 1e-1), before = (coin(random) ? 1 : -1) * any(1e-4, 100);
    const double force = semi_implicit_normal_force(law, penetration, before, 1 / mass, dt);
    const double after = before + force / mass * dt;
    const double change = force * dt * 0.5 * (before + after);
    const double released =
        elastic_energy(law, penetration) - elastic_energy(law, penetration - std::max(after, 0.0) * dt);
    ASSERT_GE(force, 0);
    ASSERT_TRUE(std::isfinite(force));
    const double round_off = 1e-12 * (std::abs(change) + 0.5 * mass * before * before);
    ASSERT_LE(change, released + round_off) << "dt " << dt << ", penetration " << penetration << ", speed " << before;
  }
}

// A cord pressed against the target by a constant load ends at rest, with the spring carrying that load, at any step.
TEST(SemiImplicit, SettlesUnderLoadAtAnyStep) {
  const NormalLaw law = make_normal_law(kStiffness, 0.5, kMass);
  const double load = 20;
  for (double dt : {1e-6, 2e-5, 2e-4, 1e-3}) {
    Impact now{-1e-6, 0};
    double force = 0;
    for (int i = 0; i < 20000; ++i) {
      now.separation_speed -= load / kMass * dt;  // first, as the header asks
      force = semi_implicit_normal_force(law, now.penetration, now.separation_speed, 1 / kMass, dt);
      now.separation_speed += force / kMass * dt;
      now.penetration -= now.separation_speed * dt;
    }
    EXPECT_NEAR(force, load, 1e-9 * load) << "dt " << dt;
    EXPECT_NEAR(law.stiffness * std::pow(now.penetration, 1.5), load, 1e-9 * load) << "dt " << dt;
  }
}

}  // namespace
}  // namespace netpocket
