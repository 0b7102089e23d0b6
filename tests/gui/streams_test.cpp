// Standard streams that are closed or full, and signals: the status says what happened, files stay sound.
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "engine/recording/recording.h"
#include "tests/gui/output_commands.h"

namespace netpocket {
namespace {

using namespace test;
using namespace std::chrono_literals;

const std::vector<int> kAll = {0, 1, 2};

// Those messages that cannot be given leave their status.
TEST(Streams, ClosedOrFullOnesDoNotChangeTheStatus) {
  const TestFolder folder;
  const std::vector<std::pair<Words, int>> commands = {
      {{"rund"}, 2},
      {{"info", folder.file("missing.h5")}, 3},
      {{"check", scenario_file("case1.toml"), "--set", "net.diameter=-1"}, 3},
      {run_words(folder.file("no/folder/run.h5")), 5}};
  for (const Surroundings& surroundings :
       {Surroundings{.error = "/dev/full"}, Surroundings{.closed = {2}}, Surroundings{.closed = kAll}}) {
    for (const auto& [command, status] : commands) {
      EXPECT_EQ(run_program(command, surroundings).exit_code, status) << command.front();
    }
  }
}

TEST(Streams, OutputThatDoesNotArriveIsAnError) {
  for (const Words& command : {Words{"--version"}, Words{"--help"}, Words{"check", scenario_file("case1.toml")}}) {
    expect_sentence(run_program(command, {.out = "/dev/full"}), 5, {"standard output", "No space left on device"});
    expect_sentence(run_program(command, {.closed = {1}}), 5, {"standard output", "Bad file descriptor"});
    EXPECT_EQ(run_program(command, {.out = "/dev/full", .error = "/dev/full"}).exit_code, 5);
  }
}

// Without care a recording becomes descriptor 2, and progress is written into it.
TEST(Streams, RecordingsStaySoundWithoutThem) {
  const TestFolder folder;
  const std::string path = folder.file("run.h5");
  for (const std::vector<int>& closed : {kAll, {2}, {0, 2}}) {
    Words command = run_words(path) + Words{"--overwrite"};
    std::erase(command, "--quiet");
    const int status = run_program(command, {.closed = closed}).exit_code;
    EXPECT_EQ(status, closed == kAll ? 5 : 0);  // the summary had nowhere to go
    const auto verified = run_program({"info", path, "--verify"});
    EXPECT_EQ(verified.exit_code, 0) << verified.error;
    EXPECT_EQ(Recording(path).status().reason, RunReason::finished);
  }
}

void wait_for(const std::function<bool()>& condition) {
  for (int tries = 0; tries < 6000 && !condition(); ++tries) std::this_thread::sleep_for(10ms);
}

ProgramResult interrupt(const Words& command, int number, const std::function<bool()>& when) {
  RunningProgram program(command);
  wait_for(when);
  program.signal(number);
  return program.wait();
}

std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().filename());
  std::ranges::sort(names);
  return names;
}

TEST(Signals, TheLossOfTheTerminalEndsARunCleanly) {
  const TestFolder folder;
  const std::string path = folder.file("run.h5");
  for (const int number : {SIGHUP, SIGTERM}) {
    std::filesystem::remove(path);
    const auto result = interrupt(run_words(path, "1000"), number, [&] { return std::filesystem::exists(path); });
    expect_sentence(result, 130, {"interrupted at t = ", path, "holds what was recorded"});
    EXPECT_EQ(Recording(path).status().reason, RunReason::stopped);
  }
  EXPECT_EQ(names_in(folder.file("")), (Words{"run.h5", "run.h5.log"}));
}

TEST(Signals, InterruptedDrawingSaysSoAndLeavesNothingHalf) {
  const TestFolder folder;
  const std::string recording = folder.file("run.h5");
  ASSERT_EQ(run_program(run_words(recording, "0.5") + Words{"--set", "output.frame_rate=1000"}).exit_code, 0);
  const auto has_part = [&] {
    const auto names = names_in(folder.file(""));
    return std::ranges::any_of(names, [](const auto& name) { return name.ends_with(".part"); });
  };
  const auto exists = [&](const std::string& name) {
    return [path = folder.file(name)] { return std::filesystem::exists(path); };
  };
  const auto reported =
      interrupt({"report", recording, "-o", folder.file("a.html"), "--fps", "1000", "--quiet"}, SIGHUP, has_part);
  expect_sentence(reported, 130, {"interrupted", "a.html", "was not written"});
  const auto filmed = interrupt({"render", recording, "-o", folder.file("f"), "--video", folder.file("a.mp4"), "--fps",
                                 "1000", "--size", "320x200", "--quiet"},
                                SIGHUP, exists("f/0000.png"));
  expect_sentence(filmed, 130, {"interrupted", "kept"});
  const auto exported =
      interrupt({"export", recording, "--vtp", folder.file("v"), "--quiet"}, SIGHUP, exists("v/lines_0000.vtp"));
  expect_sentence(exported, 130, {"interrupted", "netpocket.pvd"});
  EXPECT_EQ(names_in(folder.file("")), (Words{"f", "run.h5", "run.h5.log", "v"}));
  for (const std::string place : {"f", "v"}) {
    for (const std::string& name : names_in(folder.file(place))) EXPECT_FALSE(name.ends_with(".part")) << name;
  }
}

}  // namespace
}  // namespace netpocket
