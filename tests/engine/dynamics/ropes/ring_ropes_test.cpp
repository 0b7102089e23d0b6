// Ropes through rings: the capstan's ratio at each ring, rope that is conserved, energy that is accounted for.

#include "engine/dynamics/ropes/ring_ropes.h"

#include <cmath>
#include <numeric>

#include "engine/dynamics/system/cable_system.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using namespace test;

constexpr double kStiffness = 5000;  // EA, N

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

// A rope of parts of 1 m through nodes that turn by `turn` (rad) from part to part; all nodes stand.
Model standing_rings(int parts, double turn, double friction, double extra_angle) {
  Model model;
  RingRope rope{.nodes = {},
                .lengths = {},
                .stiffness = kStiffness,
                .friction = friction,
                .extra_angle = extra_angle,
                .share_at_start = 0};
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  for (int i = 0; i <= parts; ++i) {
    rope.nodes.push_back(model.add_node(place));
    model.nodes.back().support = Support::fixed;
    place += Eigen::Vector3d(std::cos(i * turn), std::sin(i * turn), 0);
  }
  rope.lengths.assign(static_cast<std::size_t>(parts), 0.9999);
  model.ring_ropes = {rope};
  return model;
}

class VerificationRings : public VerificationTest {};

// The rope is drawn at its end, slowly, until it slides through all rings.
TEST_F(VerificationRings, CapstanRatioAtEachRing) {
  constexpr int kParts = 9;
  double error = 0, rope_error = 0, overall = 0;
  for (const double friction : {0.05, 0.2, 0.5}) {
    for (const double turn : {0.0, 0.3, 1.2}) {
      for (const double extra : {0.0, 0.4}) {
        CableSystem system(standing_rings(kParts, turn, friction, extra));
        const double start = sum(system.ring_rope_lengths(0));
        while (system.time() < 1) {
          system.wind(0, {start - 0.4 * (system.time() + 1e-3), -0.4, 0});
          system.step(1e-3);
          rope_error = std::max(rope_error, std::abs(sum(system.ring_rope_lengths(0)) + 0.4 * system.time() - start));
        }
        for (int i = 0; i < 100; ++i) {  // comes to rest
          system.wind(0, {system.rope_motion(0).length, 0, 0});
          system.step(1e-3);
        }
        const std::vector<double> tensions = system.ring_rope_tensions(0);
        const double ratio = std::exp(friction * (turn + extra));
        for (std::size_t ring = 0; ring + 1 < tensions.size(); ++ring) {
          error = std::max(error, std::abs(tensions[ring + 1] / tensions[ring] / ratio - 1));
        }
        overall = std::max(overall, std::abs(tensions.back() / tensions.front() / std::pow(ratio, kParts - 1) - 1));
      }
    }
  }
  expect_below("capstan ratio at each of 8 rings, mu 0.05 to 0.5, angles 0 to 1.6: relative error", error, 1e-6,
               "T2/T1 = exp(mu theta); the flow is solved to 1e-10 of the largest tension");
  expect_below("capstan ratio over all 8 rings: relative error", overall, 1e-6, "exp(8 mu theta)");
  expect_below("rope through 8 rings and wound in, error, m", rope_error, 1e-13, "round-off of sums of 9 m");
}

TEST(RingFlow, CapstanRatio) {
  for (const double angle : {0.0, 1e-9, 0.3, 3.0, 20.0, 40.0}) {
    EXPECT_NEAR(capstan_ratio(0.5, angle) / std::exp(0.5 * angle), 1, 1e-13) << angle;
  }
}

TEST_F(VerificationRings, NoFrictionMakesOneTension) {
  CableSystem system(standing_rings(6, 0.7, 0, 0));
  system.step(1e-3);
  Model uneven = standing_rings(6, 0.7, 0, 0);
  uneven.ring_ropes[0].lengths = {0.5, 1.4, 0.9, 1.1, 0.99, 0.98};
  CableSystem rope(uneven);
  for (int i = 0; i < 50; ++i) rope.step(1e-3);
  const double length = sum(uneven.ring_ropes[0].lengths);
  for (const double tension : rope.ring_rope_tensions(0)) {
    EXPECT_NEAR(tension, kStiffness * (6 - length) / length, 1e-7);
  }
}

// Two masses on a rope over a standing ring: the heavier one falls with a = g (m2 - R m1)/(m2 + R m1). The rope starts
// with the tensions of that motion.
struct Atwood {
  static constexpr double kLight = 1, kHeavy = 3, kGravity = 9.81, kStiff = 1e6, kHalfGap = 0.001;
  double ratio, fall, light_tension;
  Model model;

  explicit Atwood(double friction)
      : ratio(std::min(std::exp(friction * (M_PI - kHalfGap)), kHeavy / kLight)),
        fall(kGravity * (kHeavy - ratio * kLight) / (kHeavy + ratio * kLight)),
        light_tension(kLight * (kGravity + fall)) {
    model.gravity = {0, -kGravity, 0};
    for (const double x : {-kHalfGap, 0.0, kHalfGap}) model.add_node({x, x == 0 ? 0.0 : -2.0, 0});
    model.nodes[0].point_mass = kLight;
    model.nodes[1].support = Support::fixed;
    model.nodes[2].point_mass = kHeavy;
    model.ring_ropes = {{.nodes = {0, 1, 2},
                         .lengths = {2 / (1 + light_tension / kStiff), 2 / (1 + ratio * light_tension / kStiff)},
                         .stiffness = kStiff,
                         .damping = 1e-4,
                         .friction = friction}};
  }
};

TEST_F(VerificationRings, TwoMassesOverARing) {
  const Atwood atwood(0.2);
  CableSystem system(atwood.model);
  const double dt = 0.2 * system.stable_step().step;
  while (system.time() < 0.5) system.step(dt);
  const double way = system.position(0).y() + 2;
  expect_relative("two masses over a ring with friction, way in 0.5 s, m", way,
                  0.5 * atwood.fall * system.time() * system.time(), 1e-3,
                  "(m2 - R m1)/(m2 + R m1) g t^2/2; the rope is elastic and a little aslant");
  const EnergyAudit audit = system.audit();
  expect_relative("heat of that ring, J", audit.spent.by_friction, (atwood.ratio - 1) * atwood.light_tension * way,
                  1e-3, "(T2 - T1) way");
  expect_below("energy error / heat of that ring", std::abs(audit.error) / audit.spent.by_friction, 1e-6,
               "each part by its own law");
}

TEST(RingRopes, HeldByFrictionNothingSlides) {
  CableSystem system(Atwood(0.4).model);  // exp(0.4 pi) = 3.5 > 3
  const std::vector<double> start = system.ring_rope_lengths(0);
  const double dt = 0.2 * system.stable_step().step;
  while (system.time() < 0.3) system.step(dt);
  const std::vector<double> tensions = system.ring_rope_tensions(0), lengths = system.ring_rope_lengths(0);
  EXPECT_NEAR(tensions[1] / tensions[0], 3, 1e-2);
  EXPECT_NEAR(lengths[0], start[0], 1e-4);
}

// A loose ring of masses between two winches: what floats keeps its momentum, and its energy is accounted for.
Model floating_rings(double friction) {
  Model model;
  RingRope rope{.nodes = {},
                .lengths = {},
                .stiffness = 3000,
                .damping = 1e-4,
                .friction = friction,
                .extra_angle = 0.2,
                .least_part = 0.05};
  for (int i = 0; i <= 8; ++i) {
    const double angle = 0.35 * i;
    rope.nodes.push_back(model.add_node({2 * std::cos(angle), 0.3 * std::sin(3 * angle), 2 * std::sin(angle)}));
    model.nodes.back().point_mass = i % 8 == 0 ? 0.5 : 0.02 + 0.01 * (i % 3);
    model.nodes.back().velocity = {0.3 * (i % 2), 0.1 * i, -0.2};
  }
  for (std::size_t i = 0; i < 8; ++i) {
    rope.lengths.push_back(1.02 * (model.nodes[i + 1].position - model.nodes[i].position).norm());
  }
  model.ring_ropes = {rope};
  return model;
}

struct Drawn {
  double energy_error, spent, momentum_error, least = 1e9, friction_fell = 0;
};

Drawn draw(double friction, double part_of_step) {
  CableSystem system(floating_rings(friction));
  const double dt = part_of_step * system.stable_step().step, start = sum(system.ring_rope_lengths(0));
  const auto momentum = [&] {
    Eigen::Vector3d total = Eigen::Vector3d::Zero();
    for (std::int32_t node = 0; node < 9; ++node) {
      total += system.model().nodes[static_cast<std::size_t>(node)].point_mass * system.velocity(node);
    }
    return total;
  };
  const Eigen::Vector3d before = momentum();
  Drawn drawn{};
  double heat = 0;
  while (system.time() < 2) {
    const double length = std::max(start - 1.5 * system.time() * system.time() * 0.5, 0.9);
    const double rate = length > 0.9 ? -1.5 * system.time() : 0;
    system.wind(0, {length, rate, 0});
    system.step(dt);
    if (system.steps() % 50 != 0) continue;
    const double now = system.audit().spent.by_friction;
    drawn.friction_fell = std::max(drawn.friction_fell, heat - now);
    heat = now;
    for (const double part : system.ring_rope_lengths(0)) drawn.least = std::min(drawn.least, part);
  }
  const EnergyAudit audit = system.audit();
  drawn.energy_error = std::abs(audit.error);
  drawn.spent = audit.spent.total();
  drawn.momentum_error = (momentum() - before).norm() / before.norm();
  return drawn;
}

TEST_F(VerificationRings, FloatingRingsKeepMomentumAndEnergy) {
  const Drawn drawn = draw(0.2, 0.5);
  expect_below("rope drawn through floating rings: momentum error", drawn.momentum_error, 1e-13, "round-off");
  expect_below("rope drawn through floating rings: energy error / spent", drawn.energy_error / drawn.spent, 1e-3,
               "each part by its own law");
  EXPECT_EQ(drawn.friction_fell, 0);
  EXPECT_GT(drawn.least, 0.9 * 0.05);
  EXPECT_GT(drawn.spent, 0.2);
}

TEST(RingRopes, StateIsComplete) {
  CableSystem system(floating_rings(0.3)), other(floating_rings(0.3));
  const double dt = 0.5 * system.stable_step().step;
  const auto advance = [dt](CableSystem& which, int count) {
    for (int i = 0; i < count; ++i) {
      which.wind(0, {which.rope_motion(0).length - 0.8 * dt, -0.8, 0});
      which.step(dt);
    }
  };
  advance(system, 300);
  std::vector<double> state;
  system.visit_state([&](double& number) { state.push_back(number); });
  std::size_t place = 0;
  other.visit_state([&](double& number) { number = state[place++]; });
  advance(system, 200);
  advance(other, 200);
  EXPECT_EQ(system.ring_rope_lengths(0), other.ring_rope_lengths(0));
  EXPECT_EQ(system.position(4), other.position(4));
  EXPECT_EQ(system.audit().spent.total(), other.audit().spent.total());
}

TEST(RingRopes, FaultsAreNamed) {
  Model model = floating_rings(0);
  model.ring_ropes[0].lengths.pop_back();
  EXPECT_EQ(model.find_fault(), "rope through rings 0 has other than one length between two nodes");
  model = floating_rings(-1);
  EXPECT_EQ(model.find_fault(), "rope through rings 0 has a negative or infinite damping, friction or angle");
}

}  // namespace
}  // namespace netpocket
