// Captures by full elements: their own stable step as closing ropes shorten.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/capture/simulation.h"
#include "engine/scenario/check_scenario.h"
#include "engine/scenario/read_scenario.h"
#include "engine/state/channels.h"

namespace netpocket {
namespace {

// Ropes far shorter than the sides of the meshes: their elements set the step. With that of mean-strain elements they
// flew at 12 km/s.
TEST(FullEvaluation, CoarsePocketClosesToShortRopes) {
  ScenarioResult read = read_scenario_file(NETPOCKET_SOURCE_DIR "/scenarios/low_kink.toml");
  ASSERT_TRUE(read.ok()) << read.diagnostics.text();
  Scenario scenario = read.scenario;
  scenario.solver.evaluation = Evaluation::full;
  scenario.pocket.mesh_columns = scenario.pocket.mesh_rows = 2;
  scenario.pocket.elements_per_side = 1;
  scenario.closing.closed_length = 0.6;
  scenario.closing.duration = 3;
  scenario.target.radius = 1;
  ASSERT_TRUE(check_scenario(scenario).ok()) << check_scenario(scenario).text();
  Simulation simulation(scenario);
  double fastest = 0;
  for (int i = 1; i <= 65; ++i) {
    const RunStatus status = simulation.advance(0.05 * i);
    ASSERT_EQ(status.reason, RunReason::finished) << status.message;
    const Snapshot snapshot = simulation.snapshot();
    fastest = std::max(fastest, snapshot.velocities.colwise().norm().maxCoeff());
    EXPECT_LT(std::abs(snapshot.channel(Channel::energy_error)), 1e-3 * snapshot.channel(Channel::energy_input))
        << snapshot.time;
  }
  EXPECT_LT(fastest, 60);
  EXPECT_NEAR(simulation.snapshot().channel(Channel::closing_length), 0.6, 0.03);
}

}  // namespace
}  // namespace netpocket
