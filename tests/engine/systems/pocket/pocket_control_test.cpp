// Closed-loop control, winches and events in a capture by a pocket.

#include <gtest/gtest.h>

#include <cmath>

#include "engine/capture/run.h"
#include "engine/capture/simulation.h"
#include "engine/recording/recording.h"
#include "engine/scenario/check_scenario.h"
#include "engine/scenario/pocket_outline.h"

namespace netpocket {
namespace {

// A coarse pocket around a small target.
Scenario coarse() {
  Scenario scenario;
  scenario.pocket.mesh_columns = scenario.pocket.mesh_rows = 2;
  scenario.pocket.elements_per_side = 1;
  scenario.target.radius = 1;
  scenario.closing.duration = 2;
  scenario.towing.mode = TowingMode::none;
  scenario.output.end_time = 1;
  return scenario;
}

void expect_valid(const Scenario& scenario) { EXPECT_EQ(check_scenario(scenario).text(), ""); }

double channel(const Snapshot& snapshot, const std::string& name) {
  const auto index = snapshot.channel_list->find(name);
  return index ? snapshot.channels[*index] : std::nan("");
}

Snapshot after(Simulation& simulation, double time) {
  EXPECT_EQ(simulation.advance(time).reason, RunReason::finished);
  return simulation.snapshot();
}

TEST(PocketControl, ChannelsComeWithTheirParts) {
  Scenario scenario = coarse();
  EXPECT_EQ(Simulation(scenario).structure().channels->size(), kKnownChannelCount);
  scenario.controllers = {{}};
  const auto with_loop = Simulation(scenario).structure().channels;
  EXPECT_TRUE(with_loop->find("attitude_angle"));
  EXPECT_TRUE(with_loop->find("exerted_torque_z"));
  EXPECT_FALSE(with_loop->find("disturbance_torque_x"));
  EXPECT_FALSE(with_loop->find("wheel_momentum_1"));
  EXPECT_FALSE(with_loop->find("winch_length_1"));
  scenario.winch.drive = WinchDrive::length;
  scenario.wheels = {{}};
  scenario.controllers[0] = {.kind = ControllerKind::attitude_sliding_mode, .observer = 1};
  const auto with_all = Simulation(scenario).structure().channels;
  EXPECT_TRUE(with_all->find("disturbance_torque_x"));
  EXPECT_TRUE(with_all->find("wheel_momentum_1"));
  EXPECT_TRUE(with_all->find("winch_length_8"));
  EXPECT_FALSE(with_all->find("winch_length_9"));
}

// The target drifts in and the closing starts when its centre passes the mouth: at 12 m from the root, or a little
// later, as the spacecraft is not held.
TEST(PocketControl, ClosingStartsWhenTheTargetIsInside) {
  Scenario scenario = coarse();
  scenario.closing.starts_at = ClosingStart::target_inside;
  scenario.towing = {.mode = TowingMode::force, .starts_at = TowingStart::closed, .size = 5};
  scenario.closing.duration = 0.4;
  scenario.closing.closed_length = 5;
  scenario.target.position = {0, 12.5, 0};
  scenario.target.velocity = {0, -2, 0};
  expect_valid(scenario);
  Simulation simulation(scenario);
  const double open = open_tip_distance(scenario);
  EXPECT_EQ(channel(after(simulation, 0.24), "commanded_length"), open);
  EXPECT_LT(channel(after(simulation, 0.4), "commanded_length"), open);
  EXPECT_EQ(channel(simulation.snapshot(), "capture_phase"), 1);
  EXPECT_GT(channel(after(simulation, 0.64), "commanded_length"), 5);
  const Snapshot closed = after(simulation, 0.68);
  EXPECT_EQ(channel(closed, "commanded_length"), 5);
  EXPECT_EQ(channel(closed, "capture_phase"), 3);
}

TEST(PocketControl, RecordingsTellThePhasesThatEventsBegan) {
  Scenario scenario = coarse();
  scenario.closing.starts_at = ClosingStart::distance;
  scenario.closing.distance = 8.3;
  scenario.closing.duration = 0.4;
  scenario.closing.closed_length = 5;
  scenario.target.velocity = {0, -1, 0};
  const std::string path = testing::TempDir() + "/phases.h5";
  run_to_recording(scenario, path, {.overwrite = true});
  const std::vector<Phase> phases = Recording(path).origin().phases;
  ASSERT_EQ(phases.size(), 3u);
  EXPECT_EQ(phases[1].name, kClosing);
  EXPECT_NEAR(phases[1].begin, 0.2, 0.021);  // after 0.2 m; frames are 0.02 s apart
  EXPECT_NEAR(phases[1].end, 0.6, 0.021);
  EXPECT_EQ(phases[2].name, "closed");
}

// Such a run is whole, and says that it waited in vain.
TEST(PocketControl, RunsTellWhichEventNeverCame) {
  Scenario scenario = coarse();
  scenario.closing.starts_at = ClosingStart::distance;
  scenario.closing.distance = 8.4;  // they are 8.5 m apart, at rest
  scenario.closing.duration = 0.2;
  scenario.towing = {.mode = TowingMode::force, .starts_at = TowingStart::closed, .size = 5};
  scenario.output.end_time = 0.3;
  expect_valid(scenario);
  const std::string path = testing::TempDir() + "/awaited.h5";
  EXPECT_EQ(run_to_recording(scenario, path, {.overwrite = true}).status.message,
            "reached the end time; the closing never started, since spacecraft and target came no nearer than 8.4 m; "
            "nor did the towing");
  scenario.target.velocity = {0, -1, 0};  // 0.1 m takes 0.1 s, and the closing 0.2 s more
  scenario.closing.duration = 0.25;
  Simulation late(scenario);
  after(late, 0.3);
  EXPECT_EQ(late.awaited().substr(0, 59), "the towing never started, since the mouth is closed at 0.35");
  scenario.closing.starts_at = ClosingStart::target_inside;
  scenario.target.position = {0, 13, 0};
  scenario.towing.mode = TowingMode::none;
  Simulation outside(scenario);
  after(outside, 0.3);
  EXPECT_EQ(outside.awaited(), "the closing never started, since the target was never inside the pocket");
  scenario.target.position = {0, 12, 0};
  Simulation inside(scenario);
  after(inside, 0.3);
  EXPECT_EQ(inside.awaited(), "");
}

TEST(PocketControl, ClosingStartsAtADistance) {
  Scenario scenario = coarse();
  scenario.closing.starts_at = ClosingStart::distance;
  scenario.closing.distance = 8;
  scenario.target.velocity = {0, -1, 0};  // from 7.5 m above the root, 8.5 m from the spacecraft's centre
  Simulation simulation(scenario);
  EXPECT_EQ(channel(after(simulation, 0.48), "commanded_length"), open_tip_distance(scenario));
  EXPECT_LT(channel(after(simulation, 0.8), "commanded_length"), open_tip_distance(scenario));
}

// The rope of a jammed retractor keeps its length, the others follow the law.
TEST(PocketControl, WinchesFollowTheLawAndAJammedOneStays) {
  Scenario scenario = coarse();
  scenario.winch.drive = WinchDrive::length;
  scenario.closing.duration = 5;
  scenario.winch.jammed = {{3, 1.49}};
  scenario.winch.late = {{5, 0.24}};
  expect_valid(scenario);
  Scenario ideal = coarse();
  ideal.closing.duration = 5;
  Simulation driven(scenario), prescribed(ideal);
  const Snapshot at_jam = after(driven, 1.5);
  const Snapshot wanted_early = after(prescribed, 2.26);
  const Snapshot end = after(driven, 2.5), wanted = after(prescribed, 2.5);
  EXPECT_NEAR(channel(end, "winch_length_1"), channel(wanted, "commanded_length"), 0.02);
  EXPECT_NEAR(channel(end, "winch_length_5"), channel(wanted_early, "commanded_length"), 0.02);
  EXPECT_EQ(channel(end, "winch_length_3"), channel(at_jam, "winch_length_3"));
  EXPECT_EQ(channel(end, "winch_rate_3"), 0);
  EXPECT_GT(channel(end, "winch_length_3"), channel(end, "winch_length_1") + 0.5);
  EXPECT_GT(channel(end, "winch_work"), 0);
  // What the ropes did to the system is in its account.
  EXPECT_LT(std::abs(channel(end, "energy_error")), 0.02 * channel(end, "energy_input"));
}

// What the mouth is compared with is what the ropes that still move come to, whichever rope jams.
TEST(PocketControl, TheCommandedLengthIsNotThatOfAJammedRope) {
  Scenario scenario = coarse();
  scenario.winch.drive = WinchDrive::length;
  scenario.closing.duration = 5;
  scenario.winch.jammed = {{1, 1.0}};
  Simulation jammed(scenario);
  const Snapshot end = after(jammed, 2.0);
  EXPECT_NEAR(channel(end, "commanded_length"), channel(end, "winch_length_5"), 1e-3);
  EXPECT_LT(channel(end, "commanded_length"), channel(end, "winch_length_1") - 0.3);
}

// A proportional loop: rate = gain (tension - wanted), on average over the sensor's noise.
TEST(PocketControl, WinchesWindByTheErrorOfTheTension) {
  Scenario scenario = coarse();
  scenario.winch.drive = WinchDrive::tension;
  scenario.winch.tension = 5;
  scenario.winch.tension_gain = 0.02;
  scenario.winch.take_up_rate = 0;
  scenario.sensors = {{.kind = SensorKind::rope_tension, .rate = 500, .noise = 0.05}};
  expect_valid(scenario);
  Simulation simulation(scenario);
  double tension = 0, rate = 0;
  constexpr int kFrames = 40;
  for (int i = 0; i < kFrames; ++i) {
    const Snapshot snapshot = after(simulation, 0.6 + 0.02 * i);
    tension += channel(snapshot, "rope_tension_1") / kFrames;
    rate += channel(snapshot, "winch_rate_1") / kFrames;
  }
  EXPECT_LT(rate, -0.04);
  EXPECT_NEAR(rate, 0.02 * (tension - 5), 0.01);
}

// Rods that are deflated at once are rods of the pressure that stays: both wrinkle at pi p r^3/2 (Comer & Levy 1963).
TEST(PocketControl, DeflatedRodsAreThoseOfTheirPressure) {
  Scenario limp = coarse(), deflated = coarse(), stiff = coarse();
  limp.rods.pressure = 5e3;
  deflated.rods.pressure = stiff.rods.pressure = 200e3;
  deflated.deflation = {.starts_at = DeflationStart::closing, .rate = 1e9, .pressure = 5e3};
  for (Scenario* scenario : {&limp, &deflated, &stiff}) scenario->rods.hinge_stiffness = 1000;
  expect_valid(deflated);
  Simulation a(limp), b(deflated), c(stiff);
  const Snapshot expected = after(a, 1.5), found = after(b, 1.5), unlike = after(c, 1.5);
  EXPECT_LT((found.positions - expected.positions).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_GT((unlike.positions - expected.positions).cwiseAbs().maxCoeff(), 1e-2);
  EXPECT_DOUBLE_EQ(channel(found, "rod_pressure"), 5e3);
  EXPECT_TRUE(std::isnan(channel(expected, "rod_pressure")));
  // The gas leaves before the rods bend, so that no energy is taken from them, and none is lost in the account.
  EXPECT_LT(std::abs(channel(found, "energy_error")), 0.02 * channel(found, "energy_input"));
}

// All parts, with random noise: a restored run goes on with the same bits.
Scenario everything() {
  Scenario scenario = coarse();
  scenario.closing.starts_at = ClosingStart::distance;
  scenario.closing.distance = 8.4;
  scenario.target.velocity = {0.1, -1, 0};
  scenario.target.torque = {1, 0, 0};
  scenario.towing.mode = TowingMode::controlled;
  scenario.towing.start = 0.3;
  scenario.towing.abort_force = 1000;
  scenario.winch.drive = WinchDrive::tension;
  scenario.controllers = {
      {.kind = ControllerKind::attitude_sliding_mode, .rate = 100, .observer = 2, .feed_forward = true},
      {.kind = ControllerKind::position_pd, .rate = 50, .axes = ControlledAxes::lateral},
      {.kind = ControllerKind::tow, .phase = ControlPhase::towing, .most_tension = 50}};
  scenario.sensors = {{.kind = SensorKind::attitude, .noise = 1e-3, .delay = 0.03},
                      {.kind = SensorKind::rope_tension, .rate = 200, .noise = 0.1, .dropout = 0.1}};
  scenario.actuators = {.kind = ActuatorKind::box, .time_constant = 0.02};
  scenario.wheels = {{{1, 0, 0}, 5, 50}};
  scenario.rods.pressure = 20e3;
  scenario.deflation = {.starts_at = DeflationStart::closing, .start = 0.05, .rate = 20e3, .pressure = 5e3};
  return scenario;
}

void expect_same(const Snapshot& a, const Snapshot& b) {
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.velocities, b.velocities);
  EXPECT_EQ(a.channels, b.channels);
}

TEST(PocketControl, ResumesToTheLastBit) {
  expect_valid(everything());
  Simulation whole(everything());
  after(whole, 0.4);
  const std::vector<double> state = whole.checkpoint();
  const Snapshot expected = after(whole, 0.6);
  Simulation resumed(everything());
  resumed.restore(state);
  expect_same(after(resumed, 0.6), expected);
  EXPECT_GT(channel(expected, "propellant"), 0);
}

// The branch: gains and set points of the second half of a run are others.
TEST(PocketControl, BranchesWithOtherGainsToTheLastBit) {
  Scenario other = everything();
  other.controllers[0].slope = 2;
  other.controllers[0].kind = ControllerKind::spin_damping;
  other.winch.tension = 10;
  other.sensors.clear();
  Simulation whole(everything());
  after(whole, 0.3);
  EXPECT_EQ(whole.change_strategy(other), (std::vector<std::string>{"sensor", "controller.0.kind"}));
  EXPECT_EQ(whole.scenario().controllers[0].slope, 2);
  after(whole, 0.4);
  const std::vector<double> state = whole.checkpoint();
  const Snapshot expected = after(whole, 0.6);
  Simulation resumed(whole.scenario());
  resumed.restore(state);
  expect_same(after(resumed, 0.6), expected);
}

// A push of 100 N for 0.2 s, which is no whole number of steps, gives the target of 200 kg 0.1 m/s. Its work is
// 1/2 200 kg (0.1 m/s)^2 = 1 J, and it is input of the account of energy.
TEST(PocketControl, DisturbancesGiveTheirImpulseAndAreInTheAccount) {
  Scenario scenario = coarse();
  scenario.target.mass = 200;
  scenario.closing.start = 50;
  scenario.disturbances = {{DisturbedBody::target, {100, 0, 0}, {0, 0, 0}, 0.1234567, 0.2}};
  expect_valid(scenario);
  Simulation simulation(scenario);
  const Snapshot before = after(simulation, 0.12);
  EXPECT_EQ(before.bodies[1].velocity.x(), 0);
  EXPECT_EQ(channel(before, "disturbance_on_target_force_x"), 0);
  const Snapshot during = after(simulation, 0.2);
  EXPECT_NEAR(channel(during, "disturbance_on_target_force_x"), 100 * (0.2 - 0.1234567) / 0.08, 1e-9);
  const Snapshot end = after(simulation, 0.4);
  EXPECT_NEAR(end.bodies[1].velocity.x(), 0.1, 1e-12);
  EXPECT_NEAR(channel(end, "energy_input") - channel(before, "energy_input"), 1, 0.01);
  EXPECT_LT(std::abs(channel(end, "energy_error")), 1e-3);
}

// A disturbance that comes during a run, as at a click, is part of the strategy: it acts at once, and the run resumes
// with it. A torque of 20 N m turns the spacecraft of 12736 kg m^2 by half its acceleration times the square of time.
TEST(PocketControl, DisturbancesCanBeAddedDuringARun) {
  Scenario scenario = everything();
  scenario.controllers[0].phase = ControlPhase::off;
  Simulation whole(scenario);
  after(whole, 0.3);
  const Snapshot at_rest = whole.snapshot();
  const double before = channel(at_rest, "controller_1_actual_y") + 0.1 * channel(at_rest, "spin_y");
  Scenario pushed = whole.scenario();
  pushed.disturbances = {{DisturbedBody::spacecraft, {0, 0, 0}, {0, 2000, 0}, whole.time(), 0.15}};
  const std::vector<double> at_change = whole.checkpoint();
  EXPECT_TRUE(whole.change_strategy(pushed).empty());
  const double turned = channel(after(whole, 0.4), "controller_1_actual_y") - before;
  EXPECT_GT(turned, 0.5 * 2000.0 / 12736 * 0.1 * 0.1 / 2) << "the pocket adds to the inertia";
  EXPECT_LT(turned, 1.02 * 2000.0 / 12736 * 0.1 * 0.1 / 2) << "a force that begins with a step acts half a step early";
  const std::vector<double> state = whole.checkpoint();
  const Snapshot expected = after(whole, 0.6);
  Simulation repeated(scenario);
  repeated.restore(at_change);
  repeated.change_strategy(pushed);
  after(repeated, 0.4);
  expect_same(after(repeated, 0.6), expected);
  Simulation resumed(pushed);
  resumed.restore(state);
  EXPECT_EQ(after(resumed, 0.6).positions, expected.positions);
}

std::vector<std::string> all_channels(const ControlLoopInfo& loop) {
  std::vector<std::string> names;
  for (const LoopQuantity& quantity : kLoopQuantities) {
    names.insert(names.end(), (loop.*quantity.channels).begin(), (loop.*quantity.channels).end());
  }
  return names;
}

// What panels and figures know of the loops: the structure names them, and all channels that they name exist.
TEST(PocketControl, LoopsAreDescribedAsData) {
  Simulation simulation(everything());
  const auto& loops = simulation.structure().loops;
  ASSERT_EQ(loops.size(), 3u + 8u);
  EXPECT_EQ(loops[0].name, "Attitude sliding mode");
  EXPECT_EQ(loops[0].table, "controller.0");
  EXPECT_EQ(loops[0].load, (std::vector<std::string>{"torque_load"}));
  EXPECT_EQ(loops[0].disturbance.size(), 3u);
  EXPECT_EQ(loops[1].load, (std::vector<std::string>{"force_load"}));
  EXPECT_TRUE(loops[1].disturbance.empty());
  EXPECT_EQ(loops[2].set_point.size(), 1u);
  EXPECT_EQ(loops[10].acts_on, "closing rope 8");
  for (const ControlLoopInfo& loop : loops) {
    for (const std::string& name : all_channels(loop)) {
      EXPECT_TRUE(simulation.structure().channels->find(name)) << name;
    }
  }
}

// At 0.2 s the target has come near enough: the winches wake up. At 0.3 s the towing starts.
TEST(PocketControl, LoopsTellTheirStateAndTheirError) {
  Simulation simulation(everything());
  const Snapshot before = after(simulation, 0.04);
  EXPECT_EQ(channel(before, "controller_1_state"), 1);
  EXPECT_EQ(channel(before, "controller_3_state"), 0);
  EXPECT_EQ(channel(before, "winch_state_1"), 0);
  const Snapshot later = after(simulation, 0.4);
  EXPECT_EQ(channel(later, "controller_3_state"), 1);
  EXPECT_EQ(channel(later, "winch_state_1"), 1);
  EXPECT_EQ(channel(later, "winch_set_point_1"), 20);
  EXPECT_NEAR(channel(later, "controller_2_actual_x") - channel(later, "controller_2_set_point_x"),
              channel(later, "controller_2_error_x"), 1e-15);
  EXPECT_EQ(channel(later, "controller_2_error_y"), 0) << "it is not controlled";
  EXPECT_EQ(channel(later, "controller_3_actual"), -later.bodies[0].velocity.y());
}

// With its controllers off, a scenario has the same channels and no control.
TEST(PocketControl, ControllersCanBeOff) {
  Scenario scenario = everything();
  for (ControllerParameters& controller : scenario.controllers) controller.phase = ControlPhase::off;
  expect_valid(scenario);
  Simulation simulation(scenario);
  EXPECT_EQ(simulation.structure().channels->size(), Simulation(everything()).structure().channels->size());
  const Snapshot end = after(simulation, 0.4);
  EXPECT_EQ(channel(end, "controller_1_state"), 3);
  EXPECT_EQ(channel(end, "demanded_torque_x"), 0);
  EXPECT_EQ(channel(end, "propellant"), 0);
}

// J w^2 times the error of 0.1 rad is demanded, many times what the box gives.
TEST(PocketControl, LoadsShowSaturation) {
  Scenario scenario = coarse();
  scenario.controllers = {{.attitude = {0.1, 0, 0}}};
  scenario.actuators = {.kind = ActuatorKind::box, .most_torque = {2, 50, 50}};
  Simulation simulation(scenario);
  const Snapshot at_start = after(simulation, 0.02);
  const double wanted = scenario.spacecraft.inertia.x() * 0.25 * 0.1;
  EXPECT_NEAR(channel(at_start, "torque_load"), wanted / 2, 0.05 * wanted / 2);
  EXPECT_LE(std::abs(channel(at_start, "exerted_torque_x")), 2 + 1e-9);
}

TEST(PocketControl, TowingEndsBeyondTheForceThatAborts) {
  Scenario scenario = coarse();
  scenario.target.radius = 4.5;
  scenario.closing.duration = 1;
  scenario.closing.closed_length = 2.1;
  scenario.towing = {.mode = TowingMode::force, .start = 0.2, .duration = 5, .size = 100, .offset = 0};
  scenario.towing.abort_force = 1e-3;  // the first touch
  Simulation simulation(scenario);
  after(simulation, 2.5);
  const double before = simulation.snapshot().bodies[0].velocity.y();
  scenario.towing.abort_force = 0;
  Simulation unaborted(scenario);
  after(unaborted, 2.5);
  EXPECT_LT(unaborted.snapshot().bodies[0].velocity.y(), before - 0.01);
}

}  // namespace
}  // namespace netpocket
