// Changes of strategy in the midst of a run: nothing jumps, the account of energy stays closed, and the state holds all
// that follows from them.

#include <gtest/gtest.h>

#include <cmath>

#include "engine/capture/simulation.h"
#include "engine/scenario/check_scenario.h"
#include "engine/scenario/pocket_outline.h"
#include "tests/engine/capture/state_validator.h"

namespace netpocket {
namespace {

// A coarse pocket that closes on a target far ahead of it, towed meanwhile.
Scenario coarse_scenario() {
  Scenario scenario;
  scenario.pocket.mesh_columns = scenario.pocket.mesh_rows = 2;
  scenario.pocket.elements_per_side = 1;
  scenario.target.position = {0, 40, 0};
  scenario.closing.duration = 3;
  scenario.towing.start = 0.2;
  scenario.towing.duration = 2;
  return scenario;
}

Simulation started(const Scenario& scenario, double time) {
  EXPECT_TRUE(check_scenario(scenario).ok()) << check_scenario(scenario).text();
  Simulation simulation(scenario);
  EXPECT_EQ(simulation.advance(time).reason, RunReason::finished);
  return simulation;
}

void change(Simulation& simulation, const Scenario& next) {
  EXPECT_TRUE(check_scenario(next).ok()) << check_scenario(next).text();
  EXPECT_TRUE(simulation.change_strategy(next).empty());
}

// The largest change of the spacecraft's velocity in one step (m/s) from now until `time`.
double largest_kick(Simulation& simulation, double time) {
  double largest = 0;
  Eigen::Vector3d last = simulation.snapshot().bodies[0].velocity;
  while (simulation.time() < time) {
    const double before = simulation.time();
    for (double ahead = 1e-5; simulation.time() == before; ahead *= 1.5) simulation.advance(before + ahead);
    const Eigen::Vector3d now = simulation.snapshot().bodies[0].velocity;
    largest = std::max(largest, (now - last).norm());
    last = now;
  }
  return largest;
}

// Of the energy put in.
double energy_error(Simulation& simulation) {
  const Snapshot snapshot = simulation.snapshot();
  return std::abs(snapshot.channel(Channel::energy_error)) /
         std::max(std::abs(snapshot.channel(Channel::energy_input)), 0.1);
}

std::vector<TowingParameters> tows(const TowingParameters& base, double factor) {
  std::vector<TowingParameters> list;
  for (const TowingMode mode : {TowingMode::none, TowingMode::force, TowingMode::acceleration, TowingMode::velocity}) {
    list.push_back(base);
    list.back().mode = mode;
    list.back().size = factor * (mode == TowingMode::force ? 60 : 0.05);
  }
  return list;
}

// 60 N or 0.05 m/s^2 move the spacecraft, and the rods that swing on it, by less than 0.1 m/s^2; a change that let the
// velocity jump would do so by some 0.05 m/s in a step of some 1e-4 s, 500 m/s^2.
TEST(StrategyChange, FromEachTowToEachOther) {
  Scenario scenario = coarse_scenario();
  for (const TowingParameters& before : tows(scenario.towing, 1)) {
    scenario.towing = before;
    Simulation begun = started(scenario, 1);
    const std::vector<double> state = begun.checkpoint();
    for (const TowingParameters& after : tows(scenario.towing, 0.5)) {
      SCOPED_TRACE(testing::Message() << static_cast<int>(before.mode) << " to " << static_cast<int>(after.mode));
      Simulation simulation(scenario);
      simulation.restore(state);
      const double usual = largest_kick(simulation, 1.01);
      Scenario next = scenario;
      next.towing = after;
      change(simulation, next);
      const double most = 0.1 * 2 * simulation.statistics().time_step;  // m/s
      const double kick = largest_kick(simulation, 1.03);
      test::advance_validated(simulation, 1.032);
      EXPECT_EQ(simulation.advance(1.1).reason, RunReason::finished);
      // What rods that vibrate do to a spacecraft whose velocity is not held.
      const double usual_after = largest_kick(simulation, 1.12);
      EXPECT_LT(kick, std::max({most, 1.5 * usual, 1.5 * usual_after}));
      EXPECT_EQ(simulation.advance(2.2).reason, RunReason::finished);
      EXPECT_LT(energy_error(simulation), 5e-3);  // 3.4e-3 without a change
    }
  }
}

TEST(StrategyChange, FromEachClosingLawToEachOther) {
  Scenario scenario = coarse_scenario();
  scenario.towing.mode = TowingMode::none;
  const double open = open_tip_distance(scenario);
  const std::vector<Eigen::Vector2d> table = {{0, open}, {0.8, 4.6}, {1.5, 5.1}, {3, 2.5}};
  constexpr std::array kLaws = {ClosingLaw::cycloid, ClosingLaw::quintic, ClosingLaw::trapezoid, ClosingLaw::linear,
                                ClosingLaw::table};
  for (const ClosingLaw before : kLaws) {
    scenario.closing.law = before;
    scenario.closing.table = table;
    Simulation begun = started(scenario, 0.9);
    const std::vector<double> state = begun.checkpoint();
    for (const ClosingLaw after : kLaws) {
      SCOPED_TRACE(testing::Message() << static_cast<int>(before) << " to " << static_cast<int>(after));
      Simulation simulation(scenario);
      simulation.restore(state);
      const Snapshot then = simulation.snapshot();
      Scenario next = scenario;
      next.closing.law = after;
      next.closing.duration = 2;
      change(simulation, next);
      EXPECT_EQ(simulation.advance(0.902).reason, RunReason::finished);
      const Snapshot now = simulation.snapshot();
      // A transition speeds up by less than 40 m/s^2: the quintic's 5.8 m/s times 1.1 times the largest speed in half a
      // second.
      const double elapsed = now.time - then.time;
      EXPECT_NEAR(now.channel(Channel::commanded_speed), then.channel(Channel::commanded_speed), 40 * elapsed + 1e-3);
      EXPECT_NEAR(now.channel(Channel::commanded_length), then.channel(Channel::commanded_length), 6 * elapsed);
      test::advance_validated(simulation, 0.905);
      EXPECT_EQ(simulation.advance(1.6).reason, RunReason::finished);
      test::advance_validated(simulation, 1.603);
      EXPECT_LT(energy_error(simulation), 5e-3);  // 3.4e-3 without a change
    }
  }
}

// Closes, pays out again all that was wound in, and closes: the account of energy stays closed as far as steps resolve
// the violent motion; as well as without the paying out (mean strain: 1.7e-3, 3e-3 and 8e-4 with a whole, half and a
// quarter of the step without, 3.2e-3, 3e-3 and 1.3e-3 with it).
TEST(StrategyChange, PayingOutKeepsTheAccount) {
  for (const Evaluation evaluation : {Evaluation::mean_strain, Evaluation::full}) {
    for (const auto& [safety, bound] : {std::pair(0.9, 5e-3), {0.225, 2e-3}}) {
      Scenario scenario = coarse_scenario();
      scenario.towing.mode = TowingMode::none;
      scenario.solver.evaluation = evaluation;
      scenario.solver.safety = safety;
      const double open = open_tip_distance(scenario);
      scenario.closing.law = ClosingLaw::table;
      scenario.closing.table = {{0, open}, {0.5, 5.2}, {1.0, open}, {1.4, 5}};
      Simulation simulation = started(scenario, 0.95);
      EXPECT_GT(simulation.snapshot().channel(Channel::commanded_speed), 0);
      EXPECT_EQ(simulation.advance(1.4).reason, RunReason::finished);
      EXPECT_LT(energy_error(simulation), bound);
    }
  }
}

TEST(StrategyChange, EveryOtherParameterGoesOverSmoothly) {
  Scenario scenario = coarse_scenario();
  scenario.target.position = {0, 7.5, 0};
  scenario.target.velocity = {3, -1.2, 1};
  Simulation simulation = started(scenario, 0.9);
  test::advance_validated(simulation, 0.91);
  const double usual = largest_kick(simulation, 1.0);
  Scenario next = scenario;
  next.contact.friction = 0.05;
  next.rods.pressure = 2e4;
  next.spacecraft.station_keeping = StationKeeping::lateral;
  change(simulation, next);
  EXPECT_LT(largest_kick(simulation, 1.1), 2 * usual);
  test::advance_validated(simulation, 1.12, 0.01);
  next.rods.pressure = 0;
  next.contact.friction = 0.5;
  next.spacecraft.station_keeping = StationKeeping::free;
  change(simulation, next);
  EXPECT_LT(largest_kick(simulation, 1.2), 2 * usual);
  test::advance_validated(simulation, 1.21, 0.01);
  simulation.advance(1.9);
  test::advance_validated(simulation, 1.91, 0.01);
  EXPECT_LT(energy_error(simulation), 1e-2);
}

}  // namespace
}  // namespace netpocket
