// The state of a run is complete: saved, restored and stepped twice it gives the same numbers to the last bit.

#include <gtest/gtest.h>

#include <filesystem>

#include "engine/scenario/check_scenario.h"
#include "engine/scenario/read_scenario.h"
#include "tests/engine/capture/state_validator.h"

namespace netpocket {
namespace {

using test::advance_validated;

// A coarse pocket that is in contact after 1.2 s.
Scenario coarse_capture() {
  Scenario scenario;
  scenario.pocket.mesh_columns = scenario.pocket.mesh_rows = 3;
  scenario.target.velocity = {0.8, -0.4, 0.3};
  scenario.target.spin = {0.1, 0.3, 0.2};
  scenario.closing.duration = 3;
  scenario.towing.start = 1.25;
  scenario.towing.duration = 1;
  return scenario;
}

Simulation advanced(const Scenario& scenario, double time) {
  EXPECT_TRUE(check_scenario(scenario).ok()) << check_scenario(scenario).text();
  Simulation simulation(scenario);
  const RunStatus status = simulation.advance(time);
  EXPECT_EQ(status.reason, RunReason::finished) << status.message;
  return simulation;
}

TEST(StateValidation, EveryScenarioFromItsStart) {
  for (const auto& entry : std::filesystem::directory_iterator(NETPOCKET_SOURCE_DIR "/scenarios")) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path().filename().string());
    const ScenarioResult read = read_scenario_file(entry.path().string());
    ASSERT_TRUE(read.ok()) << read.diagnostics.text();
    Simulation simulation = advanced(read.scenario, 0);
    advance_validated(simulation, 0.006, 0.003);
  }
}

class StateValidation : public testing::TestWithParam<TargetShape> {};

TEST_P(StateValidation, EveryShapeInContact) {
  Scenario scenario = coarse_capture();
  scenario.target.shape = GetParam();
  scenario.target.mesh_file = NETPOCKET_SOURCE_DIR "/scenarios/meshes/upper_stage.obj";
  scenario.target.mesh_unit = MeshUnit::millimetre;
  scenario.files.allows_absolute = true;
  scenario.target.size = {5, 5, 5};
  scenario.target.radius = GetParam() == TargetShape::sphere ? 4.5 : 3.5;
  // Fast enough that the net is met within a second.
  scenario.target.velocity = {3, -1.2, 1};
  Simulation simulation = advanced(scenario, 0.2);
  const auto touches = [&] { return simulation.snapshot().channel(Channel::contact_count) > 0; };
  while (!touches() && simulation.time() < 2) simulation.advance(simulation.time() + 0.02);
  ASSERT_TRUE(touches());
  advance_validated(simulation, simulation.time() + 0.03, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Shapes, StateValidation,
                         testing::Values(TargetShape::sphere, TargetShape::box, TargetShape::cylinder,
                                         TargetShape::satellite, TargetShape::mesh));

TEST(StateValidation, WhereCordsTouch) {
  Scenario scenario = coarse_capture();
  scenario.pocket.elements_per_side = 1;
  scenario.closing.duration = 2;
  scenario.closing.closed_length = 0.3;
  scenario.target.radius = 0.5;
  scenario.target.velocity = {0, 0, 0};
  Simulation simulation = advanced(scenario, 1.7);
  advance_validated(simulation, 1.72, 0.01);
}

TEST(StateValidation, FullEvaluation) {
  Scenario scenario = coarse_capture();
  scenario.solver.evaluation = Evaluation::full;
  scenario.target.velocity = {3, -1.2, 1};
  Simulation simulation = advanced(scenario, 0.3);
  advance_validated(simulation, 0.304, 0.002);
}

TEST(StateValidation, InflatedRodsUnderGravityWithDisplacedNodes) {
  Scenario scenario = coarse_capture();
  scenario.rods.pressure = 3e4;
  scenario.solver.gravity = {0.3, -0.5, 0.1};
  scenario.solver.perturbation = 1e-3;
  Simulation simulation = advanced(scenario, 0);
  advance_validated(simulation, 0.01, 0.005);
  simulation.advance(0.3);
  advance_validated(simulation, 0.32, 0.01);
}

TEST(StateValidation, EveryTowAndHold) {
  for (const TowingMode mode : {TowingMode::none, TowingMode::force, TowingMode::acceleration, TowingMode::velocity}) {
    for (const StationKeeping hold : {StationKeeping::free, StationKeeping::attitude, StationKeeping::lateral}) {
      Scenario scenario = coarse_capture();
      scenario.towing.mode = mode;
      scenario.towing.start = 0.105;
      scenario.towing.size = mode == TowingMode::force ? 10 : 0.05;
      scenario.spacecraft.station_keeping = hold;
      Simulation simulation = advanced(scenario, 0.1);
      advance_validated(simulation, 0.12, 0.01);
    }
  }
}

// To restore what differs in the sign of a zero only.
TEST(StateValidation, SignsOfZeroAreRestored) {
  Simulation simulation(coarse_capture());
  std::vector<double> state = simulation.checkpoint();
  const std::vector<double> before = state;
  std::size_t zeros = 0;
  for (double& number : state) {
    if (number != 0) continue;
    number = -number;
    ++zeros;
  }
  ASSERT_GT(zeros, 100U);
  simulation.restore(state);
  const std::vector<double> restored = simulation.checkpoint();
  std::size_t negative = 0, negative_wanted = 0;
  for (std::size_t i = 0; i < state.size(); ++i) {
    negative += std::signbit(restored[i]) ? 1 : 0;
    negative_wanted += std::signbit(state[i]) ? 1 : 0;
  }
  // Counts and flags have no signed zero: of more than the positions and velocities they are a handful.
  EXPECT_GT(negative + 40, negative_wanted);
  simulation.restore(before);
  EXPECT_EQ(simulation.checkpoint(), before);
}

}  // namespace
}  // namespace netpocket
