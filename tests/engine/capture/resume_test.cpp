// A run that was cut off is continued as if it had not been.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "engine/capture/run.h"
#include "engine/recording/recording.h"
#include "engine/scenario/check_scenario.h"
#include "tests/engine/bodies/mesh_samples.h"

namespace netpocket {
namespace {

// A coarse pocket that is in contact after 1.2 s.
Scenario quick_scenario(double end_time) {
  Scenario scenario;
  scenario.pocket.mesh_columns = scenario.pocket.mesh_rows = 3;
  scenario.target.velocity = {0.8, -0.4, 0.3};
  scenario.target.spin = {0.1, 0.3, 0.2};
  scenario.closing.duration = 3;
  scenario.towing.start = 1.5;
  scenario.output.end_time = end_time;
  scenario.output.frame_rate = 20;
  EXPECT_TRUE(check_scenario(scenario).ok());
  return scenario;
}

const RunOptions kProgram = {.version = "1", .commit = "a", .command = "test"};

class Resume : public testing::Test {
 protected:
  Resume() {
    std::string name = testing::TempDir() + "/resume-XXXXXX";
    folder_ = mkdtemp(name.data());
  }
  ~Resume() override { std::filesystem::remove_all(folder_); }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  // Runs until a number of frames is recorded, as Ctrl-C would stop it.
  void run_and_stop(const Scenario& scenario, const std::string& path, int frames) const {
    std::stop_source stop;
    const auto count = [&](const RunProgress&) {
      if (--frames < 0) stop.request_stop();
    };
    const RunResult result = run_to_recording(scenario, path, kProgram, count, stop.get_token());
    EXPECT_EQ(result.status.reason, RunReason::stopped);
  }

 private:
  std::filesystem::path folder_;
};

// Everything but the times that the computation took.
void expect_same_run(const std::string& path, const std::string& expected_path) {
  const Recording a(path), b(expected_path);
  EXPECT_EQ(a.origin().scenario_text, b.origin().scenario_text);
  EXPECT_EQ(a.status().reason, b.status().reason);
  EXPECT_EQ(a.status().time, b.status().time);
  EXPECT_EQ(a.statistics().steps, b.statistics().steps);
  EXPECT_EQ(a.statistics().time_step, b.statistics().time_step);
  ASSERT_EQ(a.frame_count(), b.frame_count());
  for (std::size_t i = 0; i < a.frame_count(); ++i) {
    const Snapshot one = a.frame(i), other = b.frame(i);
    EXPECT_EQ(one.step, other.step);
    EXPECT_EQ(one.channels, other.channels) << "frame " << i;
    EXPECT_EQ(one.positions, other.positions);
    EXPECT_EQ(one.velocities, other.velocities);
    EXPECT_EQ(one.tension, other.tension);
    EXPECT_EQ(one.contacts.size(), other.contacts.size());
  }
  // All but the last two numbers of the states: wall and processor time.
  ASSERT_EQ(a.checkpoint_times(), b.checkpoint_times());
  for (std::size_t i = 0; i < a.checkpoint_times().size(); ++i) {
    auto one = a.checkpoint(i).state, other = b.checkpoint(i).state;
    ASSERT_EQ(one.size(), other.size());
    one.resize(one.size() - 2);
    other.resize(other.size() - 2);
    EXPECT_EQ(one, other) << "checkpoint " << i;
  }
}

TEST_F(Resume, EqualsTheUninterruptedRunToTheLastBit) {
  const Scenario scenario = quick_scenario(2.52);  // ends in the midst of an output interval
  const std::string whole = file("whole.h5"), cut = file("cut.h5");
  run_to_recording(scenario, whole, kProgram);
  ASSERT_GT(Recording(whole).channel(Channel::energy_dissipated).back(), 0);
  run_and_stop(scenario, cut, 27);
  ASSERT_EQ(Recording(cut).frame_count(), 28u);
  RunOptions again = kProgram;
  again.overwrite = true;
  const RunResult result = resume_recording(cut, cut, again);
  EXPECT_EQ(result.status.reason, RunReason::finished);
  EXPECT_TRUE(result.recorded);
  expect_same_run(cut, whole);
  EXPECT_EQ(Recording(cut).checkpoint_times().size(), 3u);  // at 0, 1 and 2 s
}

// The recording holds all that is needed, also of a mesh whose file has gone or changed.
TEST_F(Resume, WithATargetOfAnyShape) {
  for (const TargetShape shape :
       {TargetShape::sphere, TargetShape::box, TargetShape::cylinder, TargetShape::satellite, TargetShape::mesh}) {
    Scenario scenario = quick_scenario(1.4);
    scenario.target.shape = shape;
    scenario.target.radius = 2.5;
    scenario.target.size = {2.5, 2.6, 2.7};
    scenario.target.velocity = {4, -0.4, 0.3};
    scenario.target.mesh_file = "body.obj";
    scenario.target.mesh_unit = MeshUnit::centimetre;
    scenario.files.folder = file("");
    const MeshData body = samples::moved(samples::torus(210, 90, 24, 12), {31, -17, 7});
    samples::write_file(file("body.obj"), samples::obj(body));
    ASSERT_EQ(check_scenario(scenario).text(), "");
    const std::string whole = file("whole.h5"), cut = file("cut.h5"), again = file("again.h5");
    for (const std::string& path : {whole, cut, again}) std::filesystem::remove(path);
    run_to_recording(scenario, whole, kProgram);
    constexpr int kCut = 22;
    const std::vector<double> contacts = Recording(whole).channel(Channel::penetration_max);
    ASSERT_GT(*std::max_element(contacts.begin() + kCut, contacts.end()), 0) << static_cast<int>(shape);
    run_and_stop(scenario, cut, kCut);
    std::filesystem::remove(file("body.obj"));
    resume_recording(cut, again, kProgram);
    expect_same_run(again, whole);
    samples::write_file(file("body.obj"), samples::obj(samples::box({100, 100, 100})));
    std::filesystem::remove(again);
    resume_recording(cut, again, kProgram);
    expect_same_run(again, whole);
  }
}

TEST_F(Resume, GoesOnBeyondTheEndAsALongerRunWould) {
  run_to_recording(quick_scenario(1.1), file("short.h5"), kProgram);
  run_to_recording(quick_scenario(1.4), file("long.h5"), kProgram);
  resume_recording(file("short.h5"), file("continued.h5"), kProgram, 1.4);
  expect_same_run(file("continued.h5"), file("long.h5"));
  EXPECT_EQ(Recording(file("short.h5")).times().back(), Recording(file("long.h5")).times()[22]);
}

TEST_F(Resume, KeepsTheOldFileUntilTheNewOneHoldsAsMuch) {
  const std::string path = file("run.h5");
  run_and_stop(quick_scenario(2), path, 30);
  const std::size_t frames = Recording(path).frame_count();
  std::stop_source stop;
  stop.request_stop();
  RunOptions again = kProgram;
  again.overwrite = true;
  const RunResult result = resume_recording(path, path, again, 0, {}, stop.get_token());
  EXPECT_EQ(result.status.reason, RunReason::stopped);
  EXPECT_FALSE(result.recorded);
  EXPECT_EQ(Recording(path).frame_count(), frames);
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

TEST_F(Resume, RefusesWhatAnotherProgramRecorded) {
  const std::string path = file("run.h5");
  run_and_stop(quick_scenario(1), path, 3);
  const auto refusal = [&](const RunOptions& program) -> std::string {
    try {
      resume_recording(path, path, program);
    } catch (const ResumeError& error) {
      return error.what();
    }
    return "it was resumed";
  };
  EXPECT_EQ(refusal({.overwrite = true, .version = "1", .commit = "b"}),
            "netpocket 1 (a) recorded it and this is 1 (b), whose results may differ");
  EXPECT_EQ(refusal({.overwrite = true, .version = "2", .commit = "a"}),
            "netpocket 1 (a) recorded it and this is 2 (a), whose results may differ");
}

TEST_F(Resume, ChangesOfStrategyAreRepeated) {
  const Scenario scenario = quick_scenario(1);
  Scenario faster = scenario;
  faster.closing.duration = 2;
  Simulation straight(scenario), before(scenario);
  CheckpointLog log(scenario, {});
  for (Simulation* simulation : {&straight, &before}) {
    simulation->advance(0.3);
    if (simulation == &before) log.note_change(std::make_shared<const Checkpoint>(take_checkpoint(before, &faster)));
    simulation->change_strategy(faster);
    simulation->advance(0.5);
  }
  EXPECT_EQ(log.simulation_at(0.5).checkpoint().size(), straight.checkpoint().size());
  EXPECT_EQ(log.simulation_at(0.5).snapshot().positions, straight.snapshot().positions);
  EXPECT_EQ(log.simulation_at(0.5).scenario().closing.duration, 2);
}

TEST_F(Resume, DivergedRunEndsWithItsLastSoundState) {
  Scenario scenario = quick_scenario(2);
  scenario.solver.time_step = 0.004;
  const RunResult result = run_to_recording(scenario, file("run.h5"), kProgram);
  ASSERT_EQ(result.status.reason, RunReason::diverged);
  const std::string& message = result.status.message;
  for (const char* part :
       {"(element ", "contact", " km/s in step ", " of 3.33 ms, at t = 0.", "; try a solver.time_step below 0.0033"}) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }
  const Recording recording(file("run.h5"));
  EXPECT_EQ(recording.times().back(), result.status.time);
  const Snapshot last = recording.frame(recording.frame_count() - 1);
  EXPECT_TRUE(last.positions.allFinite() && last.velocities.allFinite());
  // The step that failed is the one after it.
  EXPECT_NE(message.find("in step " + std::to_string(last.step + 1) + " of"), std::string::npos) << message;
}

// Far beyond the stable step the state overflows before it is looked at.
TEST(Divergence, OverflowIsSurvivedAndExplained) {
  Scenario scenario = quick_scenario(3);
  scenario.solver.time_step = 0.05;
  const RunStatus status = Simulation(scenario).advance(3);
  EXPECT_EQ(status.reason, RunReason::diverged);
  EXPECT_NE(status.message.find(" in step "), std::string::npos) << status.message;
  // The state before it is that of the start, which has no step yet.
  EXPECT_NE(status.message.find(" of 10 ms, at t = "), std::string::npos) << status.message;
}

// Next to rods with hardly any mass their hinge is what limits the step, in both evaluations.
TEST(Divergence, StiffHingesOfLightRodsLimitTheStep) {
  for (const Evaluation evaluation : {Evaluation::mean_strain, Evaluation::full}) {
    Scenario scenario = quick_scenario(1);
    scenario.rods.density = 1e-2;
    scenario.rods.youngs_modulus = 1e4;
    scenario.rods.hinge_damping = 0;
    scenario.rods.tip_mass = 0;
    scenario.net.density = 10;
    scenario.net.youngs_modulus = 1e7;
    scenario.solver.evaluation = evaluation;
    const RunStatus status = Simulation(scenario).advance(0.002);
    EXPECT_EQ(status.reason, RunReason::finished) << status.message;
  }
}

}  // namespace
}  // namespace netpocket
