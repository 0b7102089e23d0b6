#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "engine/capture/simulation.h"
#include "gui/workbench/editor/parameter_words.h"
#include "gui/workbench/simulation/simulation_worker.h"
#include "tests/gui/workbench/window_fixture.h"

namespace netpocket {
namespace {

using namespace std::chrono_literals;

// Takes reports until one fits; empty after a minute.
template <typename Report>
std::optional<Report> next(SimulationWorker& worker, const std::function<bool(const Report&)>& fits) {
  const auto deadline = std::chrono::steady_clock::now() + 60s;
  while (std::chrono::steady_clock::now() < deadline) {
    const auto report = worker.take_report();
    if (!report) {
      std::this_thread::sleep_for(1ms);
    } else if (const auto* wanted = std::get_if<Report>(&*report); wanted && fits(*wanted)) {
      return *wanted;
    }
  }
  return std::nullopt;
}

std::shared_ptr<const Snapshot> frame_at(SimulationWorker& worker, RunId run, double time) {
  const auto report =
      next<FrameReady>(worker, [=](const FrameReady& f) { return f.run == run && f.snapshot->time >= time - 1e-9; });
  return report ? report->snapshot : nullptr;
}

TEST(SimulationWorker, BranchContinuesToTheLastBit) {
  SimulationWorker worker([] {});
  worker.post(BeginRun{0, quick_scenario()});
  worker.post(Resume{.until = 0.6});
  const auto original = frame_at(worker, 0, 0.6);
  ASSERT_TRUE(original);
  worker.post(BeginBranch{1, 0, 0.4, quick_scenario()});
  worker.post(Resume{.until = 0.6});
  const auto branched = frame_at(worker, 1, 0.6);
  ASSERT_TRUE(branched);
  EXPECT_EQ(original->time, branched->time);
  EXPECT_EQ((original->positions - branched->positions).cwiseAbs().maxCoeff(), 0);
  EXPECT_EQ((original->velocities - branched->velocities).cwiseAbs().maxCoeff(), 0);
}

TEST(SimulationWorker, PausingDoesNotChangeTheRun) {
  SimulationWorker straight([] {});
  straight.post(BeginRun{0, quick_scenario()});
  straight.post(Resume{.until = 0.3});
  const auto expected = frame_at(straight, 0, 0.3);
  ASSERT_TRUE(expected);
  SimulationWorker paused([] {});
  paused.post(BeginRun{0, quick_scenario()});
  for (int i = 0; i < 5; ++i) {
    paused.post(Resume{.until = 0.3});
    std::this_thread::sleep_for(3ms);
    paused.post(Pause{});
    paused.post(SingleStep{});
  }
  paused.post(Resume{.until = 0.3});
  const auto actual = frame_at(paused, 0, 0.3);
  ASSERT_TRUE(actual);
  EXPECT_EQ((expected->positions - actual->positions).cwiseAbs().maxCoeff(), 0);
}

TEST(SimulationWorker, SingleStepIsOneStep) {
  SimulationWorker worker([] {});
  worker.post(BeginRun{0, quick_scenario()});
  worker.post(SingleStep{});
  const auto first = next<FrameReady>(worker, [](const FrameReady& f) { return f.snapshot->step > 0; });
  ASSERT_TRUE(first);
  EXPECT_EQ(first->snapshot->step, 1);
  worker.post(SingleStep{});
  const auto second = next<FrameReady>(worker, [](const FrameReady& f) { return f.snapshot->step > 1; });
  ASSERT_TRUE(second);
  EXPECT_EQ(second->snapshot->step, 2);
}

TEST(SimulationWorker, SingleStepOfADivergedRunComesToAnEnd) {
  SimulationWorker worker([] {});
  Scenario scenario = quick_scenario();
  scenario.solver.time_step = 4e-3;  // ten times what its elements allow
  worker.post(BeginRun{0, scenario});
  worker.post(Resume{});
  const auto diverged = [](const StateChanged& s) { return s.status.reason == RunReason::diverged; };
  ASSERT_TRUE(next<StateChanged>(worker, diverged));
  // From its last sound state it may make some steps; then it diverges again.
  bool again = false;
  for (int i = 0; i < 1000 && !again; ++i) {
    worker.post(SingleStep{});
    const auto answer = next<StateChanged>(worker, [](const StateChanged&) { return true; });
    ASSERT_TRUE(answer);
    again = diverged(*answer);
  }
  EXPECT_TRUE(again);
  worker.post(BeginRun{1, quick_scenario()});
  EXPECT_TRUE(frame_at(worker, 1, 0));
}

TEST(SimulationWorker, RealTimeIsRealTime) {
  SimulationWorker worker([] {});
  worker.post(SetPace{0.5});
  worker.post(BeginRun{0, quick_scenario()});
  ASSERT_TRUE(frame_at(worker, 0, 0));
  const auto start = std::chrono::steady_clock::now();
  worker.post(Resume{.until = 0.4});
  ASSERT_TRUE(frame_at(worker, 0, 0.4));
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  // The last frame comes when it is due; a busy machine may be late, never early.
  EXPECT_GT(elapsed.count(), 0.7);
}

TEST(SimulationWorker, ManyRunsAtOnceEndWithTheLast) {
  SimulationWorker worker([] {});
  constexpr RunId kLast = 40;
  for (RunId run = 0; run < kLast; ++run) {
    worker.post(BeginRun{run, quick_scenario()});
    worker.post(Resume{});
  }
  worker.post(BeginBranch{kLast, kLast - 1, 0, quick_scenario()});
  worker.post(Resume{.until = 0.1});
  EXPECT_TRUE(frame_at(worker, kLast, 0.1));
}

TEST(SimulationWorker, EndsWhileItRuns) {
  auto worker = std::make_unique<SimulationWorker>([] {});
  worker->post(BeginRun{0, Scenario{}});
  worker->post(Resume{});
  ASSERT_TRUE(frame_at(*worker, 0, 0.02));
  worker.reset();
}

// What the editor says of a parameter is what the simulation does.
TEST(SimulationWorker, TakesUpWhatTheEditorSaysActsAtOnce) {
  Simulation simulation(quick_scenario());
  for (const Parameter& parameter : parameters()) {
    Scenario edited = simulation.scenario();
    const ParameterValue value = parameter.get(edited);
    if (parameter.group().empty() || !std::holds_alternative<double>(value)) continue;
    parameter.set(edited, 1.01 * std::get<double>(value) + 1e-3);
    EXPECT_EQ(simulation.change_strategy(edited).empty(), edit_effect(parameter) == EditEffect::at_once)
        << parameter.key;
  }
}

TEST(SimulationWorker, StrategyActsFromNowOnAndRefusesTheRest) {
  SimulationWorker worker([] {});
  worker.post(BeginRun{0, quick_scenario()});
  worker.post(Resume{.until = 0.2});
  ASSERT_TRUE(frame_at(worker, 0, 0.2));
  Scenario edited = quick_scenario();
  edited.closing.duration = 3;
  edited.net.diameter = 0.006;
  worker.post(ChangeStrategy{edited});
  const auto answer = next<StrategyChanged>(worker, [](const StrategyChanged&) { return true; });
  ASSERT_TRUE(answer);
  EXPECT_NEAR(answer->time, 0.2, 1e-6);
  EXPECT_EQ(answer->scenario.closing.duration, 3);
  ASSERT_EQ(answer->diagnostics.list().size(), 1u);
  EXPECT_EQ(answer->diagnostics.list().front().key, "net.diameter");
}

}  // namespace
}  // namespace netpocket
