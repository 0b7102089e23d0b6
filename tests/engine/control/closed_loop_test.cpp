// The controllers that a scenario lists, at work on a free body.
#include "engine/control/closed_loop.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/control/attitude_error.h"
#include "engine/control/control_loop.h"
#include "engine/control/target_drive.h"
#include "tests/engine/dynamics/models.h"

namespace netpocket {
namespace {

constexpr double kMass = 100, kStep = 1e-3;
const Eigen::Vector3d kInertia(40, 50, 60);

// A spacecraft, a target far away, and a cable that neither touches.
Model two_bodies(const Eigen::Quaterniond& attitude) {
  test::Cable cable = test::straight_cable(test::net_cord(), {50, 0, 0}, {52, 0, 0}, 2);
  Model model = std::move(cable.model);
  model.fix_node(cable.nodes.front());
  model.fix_node(cable.nodes.back());
  const Eigen::Matrix3d inertia = kInertia.asDiagonal();
  model.add_body(
      {.name = "craft", .shape = Box{{1, 1, 1}}, .mass = kMass, .inertia = inertia, .state = {.attitude = attitude}});
  model.add_body(
      {.name = "target", .shape = Box{{1, 1, 1}}, .mass = 200, .inertia = inertia, .state = {.position = {0, 20, 0}}});
  return model;
}

const ControlledCraft kCraft{kInertia.asDiagonal(), kMass, kMass + 200, Eigen::Vector3d::Zero()};

// A run of the controllers of a scenario.
class ControlledRun {
 public:
  explicit ControlledRun(const Scenario& scenario, const Eigen::Quaterniond& attitude = Eigen::Quaterniond::Identity(),
                         const CaptureTimes& times = {})
      : system_(two_bodies(attitude)), controls_(system_) {
    auto loop = std::make_unique<ClosedLoop>(scenario, kCraft, std::make_shared<CaptureTimes>(times), 0, 1);
    loop_ = loop.get();
    controls_.add(std::move(loop));
    controls_.add(std::make_unique<TargetDrive>(scenario.target, 1));
  }

  void step() {
    controls_.before_step(kStep);
    system_.step(kStep);
    controls_.after_step(kStep);
  }
  void advance(double until) {
    while (system_.time() < until - 0.5 * kStep) step();
  }
  BodyState craft() const { return system_.body(0); }
  BodyState target() const { return system_.body(1); }
  Eigen::Vector3d turn() const { return rotation_vector(craft().attitude); }
  ClosedLoop& loop() { return *loop_; }
  ControlLoop& controls() { return controls_; }
  CableSystem& system() { return system_; }
  std::vector<double> state() {
    std::vector<double> numbers;
    const auto visit = [&](double& number) { numbers.push_back(number); };
    system_.visit_state(visit);
    controls_.visit_state(visit);
    return numbers;
  }
  void set_state(const std::vector<double>& numbers) {
    std::size_t next = 0;
    const auto visit = [&](double& number) { number = numbers.at(next++); };
    system_.visit_state(visit);
    controls_.visit_state(visit);
  }

 private:
  CableSystem system_;
  ControlLoop controls_;
  ClosedLoop* loop_;
};

Scenario with(const ControllerParameters& controller) {
  Scenario scenario;
  scenario.controllers = {controller};
  return scenario;
}

Eigen::Quaterniond rotation_of(double angle, const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
}

// A body under critical damping: e = e0 (1 + f t) exp(-f t). Sampling at 1 kHz holds the torque for half a step on
// average, which shifts the poles by about f dt.
TEST(ClosedLoop, AttitudePdFollowsTheClosedSolution) {
  constexpr double kFrequency = 2, kAngle = 0.1;
  ControlledRun run(
      with({.kind = ControllerKind::attitude_pd, .rate = 1000, .frequency = kFrequency, .damping_ratio = 1}),
      rotation_of(kAngle, Eigen::Vector3d::UnitX()));
  for (const double time : {0.5, 1.0, 2.0}) {
    run.advance(time);
    const double expected = kAngle * (1 + kFrequency * time) * std::exp(-kFrequency * time);
    EXPECT_NEAR(run.turn().x(), expected, 2e-3 * kAngle) << time;
    EXPECT_NEAR(run.turn().y(), 0, 1e-12);
  }
}

TEST(ClosedLoop, PositionSlidingModeHoldsTheLateralAxesOnly) {
  ControllerParameters controller{.kind = ControllerKind::position_sliding_mode,
                                  .position = {0.2, 0.2, -0.1},
                                  .axes = ControlledAxes::lateral,
                                  .slope = 1,
                                  .reaching = 2,
                                  .switching = 0.01,
                                  .layer = 0.01};
  ControlledRun run(with(controller));
  run.advance(20);
  EXPECT_NEAR(run.craft().position.x(), 0.2, 1e-6);
  EXPECT_NEAR(run.craft().position.z(), -0.1, 1e-6);
  EXPECT_EQ(run.craft().position.y(), 0);
}

TEST(ClosedLoop, BoxLimitsTheForceAndCountsPropellant) {
  ControllerParameters controller{.kind = ControllerKind::position_pd, .position = {100, 0, 0}};
  Scenario scenario = with(controller);
  scenario.actuators = {.kind = ActuatorKind::box, .most_force = {3, 3, 3}, .specific_impulse = 200};
  ControlledRun run(scenario);
  run.advance(2);
  // Constant force of 3 N: v = F t/m, propellant = F t/(Isp g0).
  EXPECT_NEAR(run.craft().velocity.x(), 3 * 2 / kMass, 1e-4);
  EXPECT_NEAR(run.loop().actuators().propellant(), 3 * 2 / (200 * 9.80665), 1e-9);
  const ClosedLoop::Effort effort = run.loop().take_effort(2);
  EXPECT_GT(effort.demanded.force.x(), 3);
  EXPECT_NEAR(effort.exerted.force.x(), 3, 1e-9);
}

// Angular momentum of body and wheels is constant: once the body rests, the wheels rest.
TEST(ClosedLoop, WheelsTurnTheBodyAndEndAtRest) {
  Scenario scenario = with({.kind = ControllerKind::attitude_pd, .frequency = 1});
  for (const Eigen::Vector3d& axis : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1)}) {
    scenario.wheels.push_back({axis, 50, 100});
  }
  ControlledRun run(scenario, rotation_of(0.05, Eigen::Vector3d(1, 2, 2) / 3));
  run.advance(15);
  EXPECT_LT(run.turn().norm(), 1e-4);
  EXPECT_EQ(run.loop().actuators().propellant(), 0);
  ASSERT_EQ(run.loop().actuators().momenta().size(), 3u);
  for (const double momentum : run.loop().actuators().momenta()) EXPECT_NEAR(momentum, 0, 1e-2);
}

// A body held at what a biased sensor takes for zero is off by the bias.
TEST(ClosedLoop, BiasOfASensorBecomesAnErrorOfTheBody) {
  Scenario scenario = with({.kind = ControllerKind::attitude_pd, .frequency = 1});
  scenario.sensors = {{.kind = SensorKind::attitude, .bias = {0.01, 0, -0.02}}};
  ControlledRun run(scenario);
  run.advance(25);
  EXPECT_NEAR(run.turn().x(), -0.01, 1e-5);
  EXPECT_NEAR(run.turn().z(), 0.02, 1e-5);
}

// The closed form of the delay margin, THEORY.md 11.2. The held torque counts as half a period more.
TEST(ClosedLoop, DelayOfSensorsDestabilisesBeyondTheDelayMargin) {
  constexpr double kFrequency = 2, kDamping = 0.7;
  const double crossing = kFrequency * std::sqrt(2 * kDamping * kDamping + std::sqrt(4 * std::pow(kDamping, 4) + 1));
  const double margin = std::atan(2 * kDamping * crossing / kFrequency) / crossing;
  const auto error_after = [&](double part) {
    Scenario scenario =
        with({.kind = ControllerKind::attitude_pd, .rate = 1000, .frequency = kFrequency, .damping_ratio = kDamping});
    const double delay = part * margin - 0.5e-3;
    scenario.sensors = {{.kind = SensorKind::attitude, .rate = 1000, .delay = delay},
                        {.kind = SensorKind::angular_velocity, .rate = 1000, .delay = delay}};
    ControlledRun run(scenario, rotation_of(1e-3, Eigen::Vector3d::UnitZ()));
    run.advance(60);
    double largest = 0;
    for (int i = 0; i < 4000; ++i) {
      run.step();
      largest = std::max(largest, run.turn().norm());
    }
    return largest;
  };
  EXPECT_LT(error_after(0.93), 1e-3);
  EXPECT_GT(error_after(1.07), 1e-3);
}

// In its boundary layer a sliding mode leaves d/((k + h/phi) c) of a disturbance d. Its observer takes it away.
TEST(ClosedLoop, ObserverTakesTheDisturbanceAway) {
  constexpr double kTorque = 0.4;
  ControllerParameters controller{
      .kind = ControllerKind::attitude_sliding_mode, .slope = 0.5, .reaching = 1, .switching = 0.02, .layer = 0.02};
  const auto error_under_torque = [&](double bandwidth, double* estimate) {
    controller.observer = bandwidth;
    ControlledRun run(with(controller));
    // The disturbance: another controller that the loop does not know.
    class Push : public Controller {
     public:
      void update(const Measurements&, double, Commands& commands) override {
        commands.body(0).at_centre.torque.x() = kTorque;
      }
      void visit_state(const std::function<void(double&)>&) override {}
    };
    run.controls().add(std::make_unique<Push>());
    run.advance(40);
    *estimate = run.loop().disturbance().torque.x();
    return run.turn().x();
  };
  double estimate = 0;
  EXPECT_NEAR(error_under_torque(0, &estimate), kTorque / kInertia.x() / (2 * 0.5), 1e-5);
  EXPECT_EQ(estimate, 0);
  EXPECT_NEAR(error_under_torque(5, &estimate), 0, 1e-6);
  EXPECT_NEAR(estimate, kTorque, 1e-3 * kTorque);
}

// Towing by speed reaches it and stays: v = F dt/m along -Y, with the mass that is captured.
TEST(ClosedLoop, TowActsInItsPhaseOnly) {
  Scenario scenario = with({.kind = ControllerKind::tow, .wanted = 0.2, .ramp = 2});
  CaptureTimes times;
  times.towing_start = 1;
  times.towing_end = 6;
  ControlledRun run(scenario, Eigen::Quaterniond::Identity(), times);
  run.advance(0.99);
  EXPECT_EQ(run.craft().velocity.y(), 0);
  run.advance(5.99);
  EXPECT_NEAR(run.craft().velocity.y(), -0.2, 1e-3);
  run.advance(6.1);
  EXPECT_EQ(run.loop().take_effort(6.1).demanded.force.y(), 0);
}

TEST(ClosedLoop, TargetActsBetweenItsTimes) {
  Scenario scenario = with({});
  scenario.target.thrust = {10, 0, 0};
  scenario.target.torque = {0, 5, 0};
  scenario.target.acts_from = 1;
  scenario.target.acts_until = 3;
  ControlledRun run(scenario);
  run.advance(5);
  // The thrust turns with the body: the velocity is a little less than F t/m = 0.1 m/s. Spin = M t/I.
  // Times are sums of steps, so it may act for a step more.
  EXPECT_NEAR(run.target().angular_velocity.y(), 5.0 * 2 / kInertia.y(), 1.01 * 5 * kStep / kInertia.y());
  EXPECT_LT(run.target().velocity.x(), 0.1);
  EXPECT_GT(run.target().velocity.x(), 0.098);
}

// All parts at once.
Scenario everything() {
  Scenario scenario;
  scenario.controllers = {
      {.kind = ControllerKind::attitude_sliding_mode, .rate = 50, .observer = 2, .feed_forward = true},
      {.kind = ControllerKind::attitude_double_loop, .rate = 25, .observer = 1},
      {.kind = ControllerKind::position_sliding_mode, .rate = 20, .position = {0.1, 0, 0}, .observer = 1},
      {.kind = ControllerKind::tow, .rate = 100, .integral = 10, .most_tension = 50},
      {.kind = ControllerKind::spin_damping}};
  scenario.sensors = {{.kind = SensorKind::attitude, .rate = 40, .noise = 1e-3, .delay = 0.08, .dropout = 0.2},
                      {.kind = SensorKind::velocity, .rate = 60, .noise = 1e-3, .seed = 4}};
  scenario.actuators = {.kind = ActuatorKind::thrusters, .time_constant = 0.05, .impulse_bit = 0.02};
  for (const double sign : {-1.0, 1.0}) {
    scenario.thrusters.push_back({{0, 1, 0}, {sign, 0, 0}, 10});
    scenario.thrusters.push_back({{0, -1, 0}, {sign, 0, 0}, 10});
    scenario.thrusters.push_back({{1, 0, 0}, {0, sign, 0}, 10});
    scenario.thrusters.push_back({{0, 0.5, 1}, {0, 0, sign}, 10});
  }
  scenario.wheels = {{{0, 0, 1}, 1, 10}};
  return scenario;
}

CaptureTimes towing_at_once() {
  CaptureTimes times;
  times.towing_start = 0;
  return times;
}

TEST(ClosedLoop, ContinuesFromItsStateToTheLastBit) {
  const Eigen::Quaterniond attitude = rotation_of(0.1, Eigen::Vector3d(2, 1, 2) / 3);
  ControlledRun whole(everything(), attitude, towing_at_once());
  whole.advance(1.337);
  const std::vector<double> state = whole.state();
  whole.advance(3);
  ControlledRun resumed(everything(), Eigen::Quaterniond::Identity(), towing_at_once());
  resumed.set_state(state);
  resumed.advance(3);
  EXPECT_EQ(resumed.state(), whole.state());
  EXPECT_GT(whole.loop().actuators().propellant(), 0);
}

TEST(ClosedLoop, ChangedGainsMoveTheDemandWithoutAJump) {
  ControllerParameters controller{.kind = ControllerKind::attitude_pd, .rate = 1000, .frequency = 1};
  ControlledRun run(with(controller), rotation_of(0.1, Eigen::Vector3d::UnitX()));
  run.advance(0.2);
  const double before = run.loop().take_effort(0.2).demanded.torque.x();
  controller.frequency = 2;
  run.controls().change(with(controller));
  double last = before, largest_jump = 0;
  const auto torque = [&] { return run.loop().take_effort(run.system().time()).demanded.torque.x(); };
  for (int i = 0; i < 700; ++i) {
    run.step();
    largest_jump = std::max(largest_jump, std::abs(torque() - last));
    last = torque();
  }
  // The gain alone grows fourfold: a jump by three times the torque. Over 0.5 s it is at most 15/8 of 1/500 of it.
  EXPECT_LT(largest_jump, 0.02 * std::abs(before));
  const double expected = -kInertia.x() * (4 * run.turn().x() + 4 * run.craft().angular_velocity.x());
  run.step();
  EXPECT_NEAR(torque(), expected, 1e-9);
}

// A run that was changed is restored into a loop of the changed scenario.
TEST(ClosedLoop, ContinuesAfterAChangeToTheLastBit) {
  const Scenario first = everything();
  Scenario second = first;
  second.controllers[0].slope = 1;
  second.controllers[3].wanted = 0.3;
  ControlledRun whole(first, rotation_of(0.1, Eigen::Vector3d::UnitX()), towing_at_once());
  whole.advance(1);
  whole.controls().change(second);
  whole.advance(1.2);
  const std::vector<double> state = whole.state();
  whole.advance(2);
  ControlledRun resumed(second, Eigen::Quaterniond::Identity(), towing_at_once());
  resumed.set_state(state);
  resumed.advance(2);
  EXPECT_EQ(resumed.state(), whole.state());
}

}  // namespace
}  // namespace netpocket
