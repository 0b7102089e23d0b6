// Runs that are killed, disturbed or short of room, with the real program.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <fstream>
#include <iterator>
#include <random>
#include <thread>

#include "engine/recording/recording.h"
#include "tests/gui/program.h"
#include "tests/hardening/hardening_table.h"

namespace netpocket {
namespace {

using namespace std::chrono_literals;

// A coarse pocket, so that much happens in little time.
std::vector<std::string> run_arguments(const std::string& path, const std::string& until) {
  return {"run",   scenario_file("case1.toml"), "-o",      path,
          "--set", "pocket.mesh_columns=2",     "--set",   "pocket.mesh_rows=2",
          "--set", "target.velocity=[1.5,0,0]", "--until", until};
}

void wait_for(const std::string& path) {
  for (int tries = 0; tries < 3000 && !std::filesystem::exists(path); ++tries) std::this_thread::sleep_for(10ms);
}

void expect_same_frames(const std::string& path, const std::string& expected) {
  const Recording a(path), b(expected);
  ASSERT_EQ(a.frame_count(), b.frame_count());
  EXPECT_EQ(a.status().reason, b.status().reason);
  for (std::size_t i = 0; i < a.frame_count(); ++i) {
    const Snapshot one = a.frame(i), other = b.frame(i);
    ASSERT_EQ(one.channels, other.channels) << "frame " << i;
    ASSERT_EQ(one.positions, other.positions) << "frame " << i;
    ASSERT_EQ(one.velocities, other.velocities) << "frame " << i;
  }
}

TEST(RobustnessHardening, KilledRunsAreSoundAndResumeToTheSameBits) {
  const TestFolder folder;
  const std::string whole = folder.file("whole.h5");
  ASSERT_EQ(run_program(run_arguments(whole, "2.5")).exit_code, 0);
  std::mt19937 random(5);
  const int trials = test::trial_count(1, 20);
  std::size_t kept = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const std::string path = folder.file("cut" + std::to_string(trial) + ".h5");
    {
      RunningProgram program(run_arguments(path, "2.5"));
      wait_for(path);
      std::this_thread::sleep_for(std::chrono::milliseconds(random() % 1500));
      program.signal(SIGKILL);
      program.wait();
    }
    kept += Recording(path).frame_count();
    const auto verified = run_program({"info", path, "--verify"});
    EXPECT_EQ(verified.exit_code, 0) << verified.error;
    const auto resumed = run_program({"run", "--resume", path});
    ASSERT_EQ(resumed.exit_code, 0) << resumed.error;
    expect_same_frames(path, whole);
    std::filesystem::remove(path);
  }
  if (HasFailure()) return;
  EXPECT_TRUE(test::record_hardening(
      {"netpocket run killed (SIGKILL) at a random moment, then resumed", std::to_string(trials) + " kills",
       "every checksum right, " + std::to_string(kept) +
           " frames kept; every resumed run equal to the uninterrupted one, bit by bit"}));
}

TEST(Robustness, ASecondWriterIsRefusedAndReadersAreNot) {
  const TestFolder folder;
  const std::string path = folder.file("run.h5");
  RunningProgram first(run_arguments(path, "1000"));
  wait_for(path);
  auto arguments = run_arguments(path, "0.1");
  arguments.push_back("--overwrite");
  const auto second = run_program(arguments);
  EXPECT_EQ(second.exit_code, 5);
  EXPECT_TRUE(contains(second.error, "another program is writing it")) << second.error;
  const auto resumed = run_program({"run", "--resume", path});
  EXPECT_EQ(resumed.exit_code, 5);
  EXPECT_TRUE(contains(resumed.error, "another program is writing it")) << resumed.error;
  const auto reader = run_program({"info", path});
  EXPECT_EQ(reader.exit_code, 0) << reader.error;
  first.signal(SIGINT);
  EXPECT_EQ(first.wait().exit_code, 130);
  EXPECT_EQ(Recording(path).status().reason, RunReason::stopped);
}

// A limit on the size of files stands for the full disk. The program takes over that of the test.
TEST(Robustness, AFullDiskEndsTheRunWithTheReason) {
  const TestFolder folder;
  const std::string path = folder.file("run.h5");
  rlimit before = {};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit limit = {44u << 20, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &limit);
  auto arguments = run_arguments(path, "100");
  arguments.insert(arguments.end(), {"--set", "output.frame_rate=5000"});
  const auto result = run_program(arguments);
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_TRUE(contains(result.error, "size limit")) << result.error;
  const Recording recording(path);
  EXPECT_EQ(recording.status().reason, RunReason::storage_failed);
  EXPECT_GT(recording.frame_count(), 10u);
}

TEST(Robustness, AMeshTargetIsResumedWithoutItsFile) {
  const TestFolder folder;
  std::filesystem::copy(scenario_file("meshes"), folder.file("meshes"));
  const std::string scenario = folder.file("stage.toml"), whole = folder.file("whole.h5"), cut = folder.file("cut.h5");
  std::filesystem::copy_file(scenario_file("spent_stage.toml"), scenario);
  const auto run = [&](const std::string& path, const std::string& until) {
    const auto result = run_program({"run", scenario, "-o", path, "--until", until, "--quiet", "--set",
                                     "pocket.mesh_columns=2", "--set", "pocket.mesh_rows=2"});
    ASSERT_EQ(result.exit_code, 0) << result.error;
  };
  run(whole, "1.4");
  run(cut, "1.1");
  std::filesystem::remove_all(folder.file("meshes"));
  const auto resumed = run_program({"run", "--resume", cut, "--until", "1.4", "--quiet"});
  ASSERT_EQ(resumed.exit_code, 0) << resumed.error;
  expect_same_frames(cut, whole);
}

TEST(Robustness, ResumeRefusesAnotherScenario) {
  const TestFolder folder;
  const std::string path = short_recording(folder);
  const auto other = run_program({"run", scenario_file("case1.toml"), "--resume", path, "--set", "net.diameter=0.006"});
  EXPECT_EQ(other.exit_code, 3);
  EXPECT_TRUE(contains(other.error, "net.diameter is 0.006 in ")) << other.error;
  EXPECT_TRUE(contains(other.error, " and was 0.004")) << other.error;
  const auto complete = run_program({"run", "--resume", path});
  EXPECT_EQ(complete.exit_code, 0) << complete.error;
  EXPECT_TRUE(contains(complete.out, "is complete at t = 0.1 s")) << complete.out;
}

TEST(Robustness, DamageIsFoundByVerify) {
  const TestFolder folder;
  const std::string path = short_recording(folder);
  // In many places: some lie where no data are.
  constexpr int kPlaces = 16;
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  const auto size = static_cast<std::streamoff>(std::filesystem::file_size(path));
  for (int i = 1; i < kPlaces; ++i) {
    file.seekg(i * size / kPlaces);
    const char byte = static_cast<char>(file.get() ^ 1);
    file.seekp(i * size / kPlaces);
    file.put(byte);
  }
  file.close();
  const auto result = run_program({"info", path, "--verify"});
  EXPECT_EQ(result.exit_code, 3) << result.out;
}

// Names that a shell would take for commands, of files and in files, stay names.
TEST(Robustness, NoShellSeesNames) {
  const TestFolder folder;
  const std::string trap = "$(touch " + folder.file("trapped") + ")`touch " + folder.file("trapped") + "`;'\"|&";
  const std::string name = "x $(touch trapped) `touch trapped` ;touch trapped; '";
  const std::string scenario = folder.write("own $(touch trapped);.toml", "name = '''" + trap + "'''\n");
  const std::string run = folder.file(name + ".h5"), video = folder.file(name + ".mp4");
  const auto expect_done = [](const std::vector<std::string>& arguments) {
    const auto result = run_program(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.error;
  };
  expect_done({"run", scenario, "-o", run, "--until", "0.1"});
  expect_done({"render", run, "--video", video, "--size", "64x64"});
  EXPECT_TRUE(std::filesystem::exists(video));
  EXPECT_FALSE(std::filesystem::exists(folder.file("trapped")));
  EXPECT_FALSE(std::filesystem::exists("trapped"));
}

TEST(Robustness, TheLogSaysWhatWasRun) {
  const TestFolder folder;
  const std::string path = short_recording(folder);
  std::ifstream file(folder.file("run.h5.log"));
  const std::string log{std::istreambuf_iterator<char>(file), {}};
  for (const char* part : {" netpocket 0.", "HDF5 1.", "command: netpocket run ", "scenario case1, hash ", "t = 0.1 s",
                           "finished at t = 0.1 s", " elements, ", "limited by "}) {
    EXPECT_TRUE(contains(log, part)) << part << " is not in\n" << log;
  }
}

}  // namespace
}  // namespace netpocket
