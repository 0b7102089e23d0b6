// Who is asked when, what is held, and how the commands of several controllers add up.
#include "engine/control/control_loop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/dynamics/stepping/step_choice.h"
#include "tests/engine/dynamics/models.h"

namespace netpocket {
namespace {

constexpr double kMass = 100, kInertia = 50;

// One free body, turned by a right angle about z, and a rope between two fixed nodes.
Model free_body() {
  test::Cable rope = test::straight_cable(test::net_cord(), {5, 0, 0}, {7, 0, 0}, 2);
  Model model = std::move(rope.model);
  model.fix_node(rope.nodes.front());
  model.fix_node(rope.nodes.back());
  model.ropes.push_back({rope.elements, {2.0}});
  const Eigen::Quaterniond quarter(Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitZ()));
  model.add_body({.name = "craft",
                  .shape = Box{{1, 1, 1}},
                  .mass = kMass,
                  .inertia = kInertia * Eigen::Matrix3d::Identity(),
                  .state = {.attitude = quarter}});
  return model;
}

// Does what a function says, and counts.
class Scripted : public Controller {
 public:
  using Script = std::function<void(const Measurements&, double interval, Commands&)>;
  Scripted(Script script, int& count) : script_(std::move(script)), count_(count) {}

  void update(const Measurements& measurements, double interval, Commands& commands) override {
    ++count_;
    script_(measurements, interval, commands);
  }
  void visit_state(const std::function<void(double&)>& /*visit*/) override {}

 private:
  Script script_;
  int& count_;
};

TEST(ControlLoop, AddsUpForcesAtDifferentPoints) {
  CableSystem system(free_body());
  ControlLoop loop(system);
  int count = 0;
  const auto push = [&](const Eigen::Vector3d& force, const Eigen::Vector3d& point) {
    loop.add(std::make_unique<Scripted>(
        [=](const Measurements&, double, Commands& commands) {
          commands.body(0).force = force;
          commands.body(0).point = point;
        },
        count));
  };
  push({0, 3, 0}, {1, 0, 0});  // the point is at (0, 1, 0) in world axes: no moment
  push({4, 0, 0}, {2, 0, 0});  // at (0, 2, 0): moment -8 about z
  loop.before_step(1e-3);
  system.step(1e-3);
  loop.after_step(1e-3);
  EXPECT_EQ(count, 2);
  const Wrench& exerted = system.exerted(0);
  EXPECT_TRUE(exerted.force.isApprox(Eigen::Vector3d(4, 3, 0), 1e-12)) << exerted.force.transpose();
  EXPECT_TRUE(exerted.torque.isApprox(Eigen::Vector3d(0, 0, -8), 1e-12)) << exerted.torque.transpose();
}

TEST(ControlLoop, AsksSampledControllersOnceAPeriodAndHoldsTheirForces) {
  CableSystem system(free_body());
  ControlLoop loop(system);
  int often = 0, seldom = 0;
  loop.add(std::make_unique<Scripted>([](const Measurements&, double, Commands&) {}, often));
  // A force that grows by 1 N with each sample.
  loop.add(std::make_unique<Scripted>(
               [&](const Measurements&, double interval, Commands& commands) {
                 EXPECT_EQ(interval, 0.01);
                 commands.body(0).at_centre.force.x() = seldom;
               },
               seldom),
           0.01);
  const double dt = 0.0007;  // does not divide the period
  int steps = 0;
  double impulse = 0;
  for (; system.time() < 0.1; ++steps) {
    loop.before_step(dt);
    const double expected = std::floor(system.time() / 0.01 + 1e-9) + 1;  // samples so far
    system.step(dt);
    loop.after_step(dt);
    EXPECT_EQ(system.exerted(0).force.x(), expected) << system.time();
    impulse += expected * (steps == 0 ? 0.5 * dt : dt);
  }
  EXPECT_EQ(often, steps);
  EXPECT_EQ(seldom, 10);
  EXPECT_NEAR(system.motion(0).velocity.x(), impulse / kMass, 1e-12);
}

TEST(ControlLoop, KeepsHeldCommandsInTheState) {
  int count = 0;
  const auto make = [&](CableSystem& system, ControlLoop& loop) {
    loop.add(std::make_unique<Scripted>(
                 [](const Measurements& measurements, double, Commands& commands) {
                   commands.body(0).at_centre.torque.y() = 1 + measurements.time();
                 },
                 count),
             0.05);
    (void)system;
  };
  CableSystem system(free_body()), other(free_body());
  ControlLoop loop(system), restored(other);
  make(system, loop);
  make(other, restored);
  const auto step = [](CableSystem& cables, ControlLoop& controls) {
    controls.before_step(1e-3);
    cables.step(1e-3);
    controls.after_step(1e-3);
  };
  for (int i = 0; i < 70; ++i) step(system, loop);
  std::vector<double> state;
  const auto save = [&](double& number) { state.push_back(number); };
  system.visit_state(save);
  loop.visit_state(save);
  std::size_t next = 0;
  const auto load = [&](double& number) { number = state[next++]; };
  other.visit_state(load);
  restored.visit_state(load);
  for (int i = 0; i < 70; ++i) {
    step(system, loop);
    step(other, restored);
  }
  EXPECT_EQ(system.motion(0).angular_velocity, other.motion(0).angular_velocity);
  EXPECT_EQ(count, 2 + 1 + 1);  // of the first until 0.07 s and beyond 0.1 s, and the same for the other
}

// A rope that a controller winds at a rate that nobody knew beforehand.
TEST(ControlLoop, WindsRopesAndTheStepChoiceCopes) {
  CableSystem system(free_body());
  ControlLoop loop(system);
  int count = 0;
  loop.add(std::make_unique<Scripted>(
               [](const Measurements& measurements, double, Commands& commands) {
                 const RopeMotion& rope = measurements.rope(0);
                 if (measurements.time() >= 0.1) commands.wind(0, {rope.length, -10, 0});
               },
               count),
           0.05);
  StepChoice choice(system);
  double step = 0.9 * choice.stable_step(loop.shortest_lengths(0.2));
  const double first_step = step;
  int outgrown = 0;
  while (system.time() < 0.2) {
    loop.before_step(step);
    system.step(step);
    loop.after_step(step);
    if (!choice.is_outgrown(step)) continue;
    ++outgrown;
    step = 0.9 * choice.stable_step(loop.shortest_lengths(system.time() + 1e-3));
  }
  // It kept the rate between the samples at 0.1 and 0.15 s and beyond, and lost a metre, less what the two steps of the
  // samples would have wound.
  EXPECT_NEAR(system.rope_motion(0).length, 2 - 10 * (system.time() - 0.1), 10 * 2 * first_step + 1e-3);
  EXPECT_GT(outgrown, 1);
  EXPECT_FALSE(system.fault()) << *system.fault();
  // Half as long, so the step that waves in an element allow is about half, too.
  EXPECT_LT(step, 0.6 * first_step);
}

TEST(ControlLoop, ExtrapolatesRopesThatNoControllerKnows) {
  Model model = free_body();
  model.ropes[0].motion = {2, -1, 4};  // shortest after 0.25 s: 2 - 0.125 m
  CableSystem system(std::move(model));
  ControlLoop loop(system);
  EXPECT_NEAR(loop.shortest_lengths(0.1)[0], 2 - 0.1 + 0.02, 1e-12);
  EXPECT_NEAR(loop.shortest_lengths(1)[0], 1.875, 1e-12);
}

}  // namespace
}  // namespace netpocket
