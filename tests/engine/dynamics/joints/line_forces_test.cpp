// Tension lines: they pull and never push, keep energy and momentum, and reproduce a published snap of a tether.

#include "engine/dynamics/joints/line_forces.h"

#include "engine/dynamics/system/cable_system.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using namespace test;

TEST(LineForces, PullAndNeverPush) {
  const TensionLine line{0, 1, 2, 100, 5};
  const auto tension = [&](double distance, double rate) {
    return line_forces(line, {0, distance, 0}, {3, rate, 0}).tension;
  };
  EXPECT_EQ(tension(1.9, 10), 0);                          // slack
  EXPECT_NEAR(tension(2.5, 2), 100 * 0.5 + 5 * 2, 1e-12);  // only the rate along the line counts
  EXPECT_EQ(tension(2.1, -3), 0);                          // 10 N of the spring, -15 N of the damper
  const LineForces held = line_forces(line, {0, 2.1, 0}, {0, -3, 0});
  EXPECT_EQ(held.on_node1, Eigen::Vector3d::Zero().eval());
  EXPECT_NEAR(held.dissipated_power, 100 * 0.1 * 3, 1e-12);  // what the spring gives
  EXPECT_NEAR(line_forces(line, {0, 2.5, 0}, {0, 2, 0}).dissipated_power, 5 * 2 * 2, 1e-12);
  EXPECT_NEAR(line_forces(line, {0, 2.5, 0}, {0, 2, 0}).energy, 0.5 * 100 * 0.25, 1e-12);
}

TEST(LineForces, FaultsOfLinesAreNamed) {
  Model model;
  model.nodes.resize(2);
  model.lines = {{0, 2, 1, 1, 0}};
  EXPECT_EQ(model.find_fault(), "line 0 joins a node that does not exist");
  model.lines = {{0, 1, 0, 1, 0}};
  EXPECT_EQ(model.find_fault(), "line 0 has no length");
  model.lines = {{0, 1, 1, 1, -1}};
  EXPECT_EQ(model.find_fault(), "line 0 has a negative or infinite damping");
}

class VerificationLine : public VerificationTest {};

// w = sqrt(k (1/m1 + 1/m2)) while the line is taut: it is slack for the first time after half a period.
TEST_F(VerificationLine, TwoMassesOnATautLine) {
  Model model;
  for (const double x : {0.0, 1.01}) model.nodes[static_cast<std::size_t>(model.add_node({x, 0, 0}))].point_mass = 2;
  model.lines = {{0, 1, 1, 400, 0}};
  CableSystem system(model);
  const double dt = 0.01 * system.stable_step().step;
  while (system.position(1).x() - system.position(0).x() > 1) system.step(dt);
  expect_relative("time until a stretched line is slack, s", system.time(), M_PI / 2 / std::sqrt(400 * (0.5 + 0.5)),
                  0.02, "quarter of a period of two masses on a spring; a step is 1.3 % of it");
  while (system.time() < 1) system.step(dt);
  // Half of x w each, from the energy k x^2/2 = 2 m v^2/2.
  EXPECT_NEAR(system.velocity(1).x(), -0.01 * std::sqrt(400 / 4.0), 1e-4);
  expect_below("energy error of two masses on a line / energy", std::abs(system.audit().error) / (0.5 * 400 * 1e-4),
               1e-4, "no damping");
}

// Chaser and target in free space, at rest. The chaser pulls with 100 N; the tether from it splits into four lines.
struct TowedBodies {
  std::int32_t chaser, target, junction;
  Model model;

  TowedBodies() {
    chaser = add_body("chaser", BodyRole::spacecraft, 500.003809, 0, {1, 1, 1});
    target = add_body("target", BodyRole::target, 3000.003809, 31.375, {1.75, 1.25, 1.25});
    junction = model.add_node({16, 0, 0});
    model.nodes[static_cast<std::size_t>(junction)].point_mass = 0.007618;
    add_line(point_of(chaser, {0.5, 0, 0}), 15.6875);
    for (const double y : {-0.625, 0.625}) {
      for (const double z : {-0.625, 0.625}) add_line(point_of(target, {31.375 - 0.875, y, z}), 17.25625);
    }
  }
  std::int32_t add_body(const char* name, BodyRole role, double mass, double x, const Eigen::Vector3d& size) {
    return model.add_body({.name = name,
                           .role = role,
                           .shape = Box{size},
                           .mass = mass,
                           .inertia = mass / 6 * Eigen::Matrix3d::Identity(),
                           .state = {.position = {x, 0, 0}}});
  }
  std::int32_t point_of(std::int32_t body, const Eigen::Vector3d& position) {
    const std::int32_t index = model.add_node(position);
    ModelNode& node = model.nodes[static_cast<std::size_t>(index)];
    node.support = Support::body;
    node.body = body;
    return index;
  }
  void add_line(std::int32_t end, double length) { model.lines.push_back({junction, end, length, 58643.062867, 48}); }
};

TEST_F(VerificationLine, TetherSnapsTaut) {
  const TowedBodies bodies;
  CableSystem system(bodies.model);
  constexpr double dt = 1.0 / 32768;  // s: times are exact
  ASSERT_LT(dt, system.stable_step().step);
  BodyControl pull;
  pull.at_centre.force = {-100, 0, 0};
  system.control(bodies.chaser, pull);
  const auto run_until = [&](double time) {
    while (system.time() < time) system.step(dt);
  };
  const auto speed = [&](std::int32_t body) { return system.body(body).velocity.x(); };
  const char* published = "published run with Vortex (cables without mass), 2 mm and 2 mm/s";
  run_until(4);
  expect_value("tether snap, chaser at 4 s, m", system.body(bodies.chaser).position.x(), -1.59996, 2e-3, published);
  expect_value("tether snap, chaser's speed at 4 s, m/s", speed(bodies.chaser), -0.79998, 2e-3, published);
  while (speed(bodies.target) == 0) system.step(dt);
  expect_value("tether snap, first taut, s", system.time(), 5.4048, 1e-4, "published run; also sqrt(2 m gap/F)");
  run_until(8);
  expect_value("tether snap, chaser at 8 s, m", system.body(bodies.chaser).position.x(), -1.77470, 2e-3, published);
  expect_value("tether snap, chaser's speed at 8 s, m/s", speed(bodies.chaser), 0.29219, 2e-3, published);
  expect_value("tether snap, target at 8 s, m", system.body(bodies.target).position.x(), 30.60413, 2e-3, published);
  expect_value("tether snap, target's speed at 8 s, m/s", speed(bodies.target), -0.31537, 2e-3, published);
  run_until(90);
  const double momentum = 500.003809 * speed(bodies.chaser) + 3000.003809 * speed(bodies.target) +
                          0.007618 * system.velocity(bodies.junction).x();
  // Velocities belong to half a step before the time.
  expect_below("tether snap, error of 9000 N s of momentum at 90 s / that",
               std::abs(momentum / (-100 * (90 - dt / 2)) - 1), 1e-11, "round-off of 3e6 steps");
  expect_below("tether snap, energy error / work at 90 s", std::abs(system.audit().error / system.audit().input), 1e-4,
               "damping acts at the last half step's velocities: first order in the step");
}

}  // namespace
}  // namespace netpocket
