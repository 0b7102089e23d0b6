// netpocket run and check, with the real engine.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "engine/recording/recording.h"
#include "tests/gui/program.h"

namespace netpocket {
namespace {

TEST(Check, PrintsTheModel) {
  const auto result = run_program({"check", scenario_file("case1.toml")});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  // 8 rods, 6 x 6 cells, 2 elements a side; open tip distance 2 * 7.56 m * sin(pi/8).
  for (const char* part : {"nodes ", "elements ", "coordinates ", "spacecraft 1210, target 200 kg",
                           "5.786 m to 2.1 m between rod tips", "limited by "}) {
    EXPECT_TRUE(contains(result.out, part)) << part << " is not in\n" << result.out;
  }
}

TEST(Check, PrintsTheTargetsShape) {
  const auto sphere = run_program({"check", scenario_file("low_kink.toml")});
  EXPECT_TRUE(contains(sphere.out, "target         sphere, 9 x 9 x 9 m, volume 381.7 m^3")) << sphere.out;
  const auto stage = run_program({"check", scenario_file("spent_stage.toml")});
  EXPECT_EQ(stage.exit_code, 0) << stage.error;
  for (const char* part : {"mesh \"meshes/upper_stage.obj\", ", " triangles, ", " volume ", "(shape)"}) {
    EXPECT_TRUE(contains(stage.out, part)) << part << " is not in\n" << stage.out;
  }
}

TEST(Check, AppliesSettings) {
  const auto result =
      run_program({"check", scenario_file("case1.toml"), "--set", "closing.duration=5", "--set", "towing.mode=none"});
  EXPECT_TRUE(contains(result.out, "from t = 0 s to 5 s")) << result.out;
}

TEST(Run, RecordsEveryOutputInterval) {
  const TestFolder folder;
  const std::string path = folder.file("run.h5");
  const auto result = run_program({"run", scenario_file("case2.toml"), "-o", path, "--until", "0.2", "--set",
                                   "towing.mode=none", "--set", "output.frame_rate=40"});
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_TRUE(contains(result.out, "finished at t = 0.2 s")) << result.out;
  EXPECT_TRUE(contains(result.error, "100 %  t = 0.20 of 0.2 s")) << result.error;

  const Recording recording(path);
  ASSERT_EQ(recording.frame_count(), 9u);
  // Times are sums of steps: round-off of about 1e3 additions.
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(recording.times()[i], static_cast<double>(i) / 40, 1e-10);
  EXPECT_EQ(recording.status().reason, RunReason::finished);
  const RunOrigin& origin = recording.origin();
  EXPECT_EQ(origin.scenario_name, "case2");
  EXPECT_EQ(phase_end(origin.phases, kClosing), 7.5);
  EXPECT_TRUE(std::isnan(phase_begin(origin.phases, kTowing)));
  EXPECT_TRUE(contains(origin.scenario_text, "frame_rate = 40"));
  EXPECT_TRUE(contains(origin.command, "--set towing.mode=none")) << origin.command;
  EXPECT_TRUE(origin.netpocket_version.starts_with("0."));
}

TEST(Run, EndsAtTheEndTimeInMidInterval) {
  const TestFolder folder;
  const std::string path = folder.file("run.h5");
  ASSERT_EQ(run_program({"run", scenario_file("case1.toml"), "-o", path, "--until", "0.05"}).exit_code, 0);
  const Recording recording(path);
  ASSERT_EQ(recording.frame_count(), 4u);  // 0, 0.02, 0.04 and 0.05 s
  // To the nearest step, which is about 1e-4 s.
  EXPECT_NEAR(recording.times().back(), 0.05, 1e-4);
}

TEST(Run, QuietSaysNothing) {
  const TestFolder folder;
  const auto result =
      run_program({"run", scenario_file("case1.toml"), "-o", folder.file("run.h5"), "--until", "0.04", "--quiet"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out + result.error, "");
}

TEST(Run, ThreadsDoNotChangeTheResult) {
  const TestFolder folder;
  const auto last_frame = [&](const std::string& threads) {
    const std::string path = folder.file(threads + ".h5");
    run_program({"run", scenario_file("case1.toml"), "-o", path, "--until", "0.1", "--threads", threads});
    const Recording recording(path);
    return recording.frame(recording.frame_count() - 1);
  };
  const Snapshot one = last_frame("1"), two = last_frame("2");
  EXPECT_EQ(one.positions, two.positions);
  EXPECT_EQ(one.channels, two.channels);
}

TEST(Run, NeverReplacesARecordingUnasked) {
  const TestFolder folder;
  const std::string path = short_recording(folder);
  const std::vector<std::string> arguments = {"run", scenario_file("case1.toml"), "-o", path, "--until", "0.04"};
  const auto refused = run_program(arguments);
  EXPECT_EQ(refused.exit_code, 5);
  EXPECT_TRUE(contains(refused.error, "exists already; --overwrite replaces it")) << refused.error;
  EXPECT_EQ(Recording(path).frame_count(), 6u);

  auto overwriting = arguments;
  overwriting.push_back("--overwrite");
  EXPECT_EQ(run_program(overwriting).exit_code, 0);
  EXPECT_EQ(Recording(path).frame_count(), 3u);
}

TEST(Run, DivergenceKeepsTheRecordingAndSaysWhy) {
  const TestFolder folder;
  const std::string path = folder.file("run.h5");
  // Thirty times the stable step.
  const auto result =
      run_program({"run", scenario_file("case1.toml"), "-o", path, "--until", "1", "--set", "solver.time_step=0.003"});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_TRUE(contains(result.error, " in step ")) << result.error;
  const Recording recording(path);
  EXPECT_EQ(recording.status().reason, RunReason::diverged);
  EXPECT_GE(recording.frame_count(), 1u);
}

TEST(Run, EndsAtItsLimitOfSteps) {
  const TestFolder folder;
  const std::string path = folder.file("run.h5");
  const auto result =
      run_program({"run", scenario_file("case1.toml"), "-o", path, "--until", "1", "--set", "solver.most_steps=700"});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_TRUE(contains(result.error, "reached the limit of 700 steps (solver.most_steps) at t = ")) << result.error;
  const Recording recording(path);
  EXPECT_EQ(recording.status().reason, RunReason::limited);
  EXPECT_EQ(recording.statistics().steps, 700);
  EXPECT_EQ(recording.times().back(), recording.status().time) << "the frame at which it ended";
  const auto resumed = run_program({"run", "--resume", path});
  EXPECT_NE(resumed.exit_code, 0);
  EXPECT_TRUE(contains(resumed.error, "has made as many steps as it may")) << resumed.error;
}

class Interrupted : public testing::TestWithParam<int> {};

TEST_P(Interrupted, RunKeepsWhatItRecorded) {
  const TestFolder folder;
  const std::string path = folder.file("run.h5");
  RunningProgram program({"run", scenario_file("case1.toml"), "-o", path, "--until", "1000"});
  // The file has its name from the first frame on.
  for (int tries = 0; tries < 1000 && !std::filesystem::exists(path); ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  program.signal(GetParam());
  const auto result = program.wait();
  EXPECT_EQ(result.exit_code, 130) << result.error;
  EXPECT_TRUE(contains(result.error, "interrupted at t = ")) << result.error;
  EXPECT_TRUE(contains(result.out, "stopped at t = ")) << result.out;
  const Recording recording(path);
  EXPECT_EQ(recording.status().reason, RunReason::stopped);
  EXPECT_GE(recording.frame_count(), 1u);
  EXPECT_LE(recording.times().back(), recording.status().time);
}

INSTANTIATE_TEST_SUITE_P(Run, Interrupted, testing::Values(SIGINT, SIGTERM));

}  // namespace
}  // namespace netpocket
