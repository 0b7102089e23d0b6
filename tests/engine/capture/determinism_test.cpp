// V6: the same scenario gives the same bits, whatever the number of threads, the instruction set or the way in which a
// run is cut into pieces and looked at.

#include <unistd.h>

#include <cstdio>
#include <functional>

#include "engine/capture/simulation.h"
#include "engine/scenario/check_scenario.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

void expect_same_state(const Snapshot& a, const Snapshot& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.step, b.step);
  EXPECT_TRUE(a.positions == b.positions);
  EXPECT_TRUE(a.velocities == b.velocities);
  EXPECT_TRUE(a.gradients == b.gradients);
  EXPECT_TRUE(a.tension == b.tension);
  ASSERT_EQ(a.bodies.size(), b.bodies.size());
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    EXPECT_EQ(a.bodies[i].position, b.bodies[i].position);
    EXPECT_EQ(a.bodies[i].attitude.coeffs(), b.bodies[i].attitude.coeffs());
    EXPECT_EQ(a.bodies[i].velocity, b.bodies[i].velocity);
  }
}

// Closes fast on a tumbling box: in contact after less than two seconds.
Scenario busy_scenario() {
  Scenario scenario;
  scenario.pocket.mesh_columns = scenario.pocket.mesh_rows = 4;
  scenario.target.shape = TargetShape::box;
  scenario.target.size = {5, 5, 5};
  scenario.target.spin = {0.1, 0.3, 0.2};
  scenario.target.velocity = {0.6, -0.2, 0.3};
  scenario.closing.duration = 3;
  scenario.towing.start = 1.5;
  return scenario;
}

Snapshot run(const Scenario& scenario, const SimulationOptions& options, const std::vector<double>& stops) {
  EXPECT_TRUE(check_scenario(scenario).ok());
  Simulation simulation(scenario, options);
  for (const double stop : stops) {
    const RunStatus status = simulation.advance(stop);
    EXPECT_EQ(status.reason, RunReason::finished) << status.message;
    simulation.snapshot();
  }
  return simulation.snapshot();
}

TEST(Determinism, PiecesAndLooksDoNotMatter) {
  const Snapshot whole = run(busy_scenario(), {}, {2.5});
  const Snapshot pieces = run(busy_scenario(), {}, {0.1, 0.1234567, 0.5, 0.5, 1.99, 2.0001, 2.5});
  ASSERT_GT((whole.bodies[1].velocity - busy_scenario().target.velocity).norm(), 1e-3) << "no contact so far";
  expect_same_state(whole, pieces);
}

TEST(Determinism, PiecesDoNotMatterWhereCordsTouch) {
  Scenario scenario = busy_scenario();
  scenario.pocket.elements_per_side = 1;
  scenario.closing.duration = 2;
  scenario.closing.closed_length = 0.3;
  scenario.closing.elements = 2;
  scenario.target.size = {1, 1, 1};
  scenario.target.velocity = {0, 0, 0};
  const Snapshot whole = run(scenario, {}, {1.8});
  expect_same_state(whole, run(scenario, {}, {0.8, 1.6, 1.7123456, 1.8}));
  // A run restored from a checkpoint looks for contacts anew.
  Simulation first(scenario), second(scenario);
  ASSERT_EQ(first.advance(1.7).reason, RunReason::finished);
  second.restore(first.checkpoint());
  ASSERT_EQ(second.advance(1.8).reason, RunReason::finished);
  expect_same_state(whole, second.snapshot());
  scenario.contact.cords = false;
  EXPECT_FALSE(run(scenario, {}, {1.8}).positions == whole.positions) << "no cord has touched another";
}

TEST(Determinism, ThreadsDoNotMatter) {
  // Threads are used from 8,000 elements on; each step of this pocket is 4e-5 s.
  Scenario scenario = busy_scenario();
  scenario.pocket.mesh_columns = scenario.pocket.mesh_rows = 20;
  const Snapshot one = run(scenario, {.threads = 1}, {0.002});
  ASSERT_GT(one.tension.size(), 20000) << "too few elements for a second thread";
  ASSERT_GT(one.step, 20);
  expect_same_state(one, run(scenario, {.threads = 2}, {0.002}));
}

// Prints the state after a short run: the same in child processes that are told to use another instruction set.
TEST(Determinism, InstructionSetsDoNotMatter) {
  const auto fingerprint = [&](const std::string& set) {
    const std::string command = "NETPOCKET_ISA=" + set + " /proc/" + std::to_string(getpid()) +
                                "/exe --gtest_also_run_disabled_tests --gtest_filter=Determinism.DISABLED_Fingerprint";
    std::string output;
    FILE* pipe = popen(command.c_str(), "r");
    for (char line[256]; fgets(line, sizeof line, pipe) != nullptr;) {
      if (std::string(line).starts_with("fingerprint")) output += line;
    }
    EXPECT_EQ(pclose(pipe), 0);
    return output;
  };
  const std::string baseline = fingerprint("baseline");
  ASSERT_FALSE(baseline.empty());
  EXPECT_EQ(fingerprint("avx2"), baseline);
  EXPECT_EQ(fingerprint("avx512"), baseline);
}

TEST(Determinism, DISABLED_Fingerprint) {
  const Snapshot snapshot = run(busy_scenario(), {}, {0.3});
  std::size_t hash = 0;
  for (const double value : snapshot.positions.reshaped()) hash = hash * 1099511628211u ^ std::hash<double>{}(value);
  std::printf("fingerprint %zx\n", hash);
}

}  // namespace
}  // namespace netpocket
