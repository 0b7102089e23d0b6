// Disks that are full or fail, and files that others meddle with: the reason in one sentence, status 5, and what stood
// there before stays.
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <thread>

#include "engine/recording/recording.h"
#include "tests/gui/output_commands.h"
#include "tests/hardening/hardening_table.h"

namespace netpocket {
namespace {

using namespace test;
using namespace std::chrono_literals;

class FailingDisk : public OutputTest {
 protected:
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.file(""))) {
      found.push_back(entry.path().string());
    }
    std::ranges::sort(found);
    return found;
  }

  Words table(const std::string& folder) const { return {"export", recording_, "--csv", folder}; }
  Words series(const std::string& folder) const { return {"export", recording_, "--vtp", folder, "--quiet"}; }
  Words figures(const std::string& folder) const {
    return {"plot", recording_, "-o", folder, "--figure", "figure03_closing", "--format", "svg"};
  }
  Words pictures(const std::string& folder) const {
    return {"render", recording_, "-o", folder, "--times", "0", "--size", "320x200", "--quiet"};
  }

  // A program called ffmpeg that reads all pictures and does this; `$last` is the file it should write.
  std::string fake_ffmpeg(const std::string& script) const {
    std::filesystem::create_directories(folder_.file("bin"));
    const std::string path = folder_.write(
        "bin/ffmpeg", "#!/bin/sh\ncat > /dev/null\nfor last; do :; done\nlast=${last#file:}\n" + script + "\n");
    chmod(path.c_str(), 0755);
    return "PATH=" + folder_.file("bin") + ":" + std::getenv("PATH");
  }
};

// A limit on the size of files stands for the full disk; messages fit into it.
TEST_F(FailingDisk, IsSaidOfEveryOutput) {
  const std::string png = folder_.file("a.png"), glb = folder_.file("a.glb"), mp4 = folder_.file("a.mp4"),
                    html = folder_.file("a.html"), csv = folder_.file("csv"), vtp = folder_.file("vtp"),
                    svg = folder_.file("svg"), frames = folder_.file("frames");
  const std::vector<std::pair<Words, std::string>> outputs = {{sheet(png), png},
                                                              {gltf(glb), glb},
                                                              {video(mp4), mp4},
                                                              {report(html), html},
                                                              {table(csv), csv + "/channels.csv"},
                                                              {series(vtp), vtp + "/lines_0000.vtp"},
                                                              {figures(svg), svg + "/figure03_closing.svg"},
                                                              {pictures(frames), frames + "/0000.png"}};
  for (const bool replacing : {false, true}) {
    std::vector<std::string> before;
    for (const auto& [command, path] : outputs) {
      if (replacing) {
        ASSERT_EQ(run_program(command).exit_code, 0) << path;
      }
    }
    for (const auto& [command, path] : outputs) {
      const std::string old = content(path);
      expect_sentence(run_program(command, {.largest_file = 1000}), 5,
                      {"cannot write \"" + path + "\": ", "File too large"});
      EXPECT_EQ(content(path), old) << path;
    }
  }
  for (const std::string& name : names()) EXPECT_FALSE(contains(name, ".part")) << name;
}

TEST_F(FailingDisk, IsSaidOfAReportWithAVideo) {
  const std::string html = folder_.file("a.html");
  const Words command = {"report", recording_, "-o", html, "--fps", "20", "--quiet"};
  expect_sentence(run_program(command, {.largest_file = 1000}), 5,
                  {"cannot write \"" + html + "\": ", "File too large"});
  EXPECT_FALSE(std::filesystem::exists(html));
}

TEST_F(FailingDisk, IsSaidOfARecording) {
  const std::string path = folder_.file("new.h5");
  const auto result = run_program(run_words(path), {.largest_file = 1000});
  expect_sentence(result, 5, {"cannot write \"" + path + "\": ", "size limit"});
  EXPECT_FALSE(std::filesystem::exists(path));
}

// The recording fits, its log does not.
TEST_F(FailingDisk, IsSaidOfALog) {
  const std::string path = folder_.file("new.h5"), log = path + ".log";
  folder_.write("new.h5.log", "2026-01-31 10:11:12 netpocket 0.1.0\n");
  std::filesystem::resize_file(log, 60u << 20);
  const auto result = run_program(run_words(path), {.largest_file = 50u << 20});
  expect_sentence(result, 5, {"cannot write \"" + log + "\": File too large"});
  EXPECT_EQ(Recording(path).status().reason, RunReason::finished);
}

// Ffmpeg ends with success where only the end of the file did not fit.
TEST_F(FailingDisk, AVideoWithoutItsEndDoesNotReplaceAWholeOne) {
  const std::string mp4 = folder_.file("a.mp4");
  ASSERT_EQ(run_program(video(mp4)).exit_code, 0);
  const std::string whole = content(mp4);
  const std::string half = "head -c 2000 " + mp4 + " > \"$last\"";
  const auto full = run_program(
      video(mp4), {.environment = {fake_ffmpeg(
                       half + "\necho \"Error writing trailer of file:$last: No space left on device\" >&2")}});
  expect_sentence(full, 5, {"cannot write \"" + mp4 + "\": No space left on device"});
  const auto silent = run_program(video(mp4), {.environment = {fake_ffmpeg(half)}});
  expect_sentence(silent, 6, {mp4, "not whole"});
  const auto named = run_program(video(mp4), {.environment = {fake_ffmpeg("echo \"no codec for $last\" >&2\nexit 1")}});
  expect_sentence(named, 6, {"no codec for " + mp4});
  EXPECT_EQ(content(mp4), whole);
}

// Linux reports a page that it could not store once; the next synchronisation succeeds.
TEST_F(FailingDisk, ASynchronisationThatFailsOnceIsNotForgotten) {
  const std::string path = folder_.file("new.h5");
  // At the first frame four, at the end four and one when all is closed; more on a slow machine.
  for (const std::string number : {"1", "2", "4", "5", "8", "9"}) {
    std::filesystem::remove(path);
    const auto result = run_program(
        run_words(path), {.environment = {"LD_PRELOAD=" NETPOCKET_FAULT_LIBRARY, "NETPOCKET_FAIL_SYNC=" + number,
                                          "ASAN_OPTIONS=verify_asan_link_order=0"}});
    expect_sentence(result, 5, {path, "Input/output error"});
    EXPECT_FALSE(contains(result.error, "holds what was recorded"));
    EXPECT_EQ(std::filesystem::exists(path), std::stoi(number) > 4) << number;  // it is named by its first flush
  }
}

TEST_F(FailingDisk, TextThatMattersIsOnTheDiskBeforeItReplacesOlder) {
  const std::string csv = folder_.file("csv");
  ASSERT_EQ(run_program(table(csv)).exit_code, 0);
  const std::string before = content(csv + "/channels.csv");
  const auto result =
      run_program(table(csv), {.environment = {"LD_PRELOAD=" NETPOCKET_FAULT_LIBRARY, "NETPOCKET_FAIL_SYNC=1",
                                               "ASAN_OPTIONS=verify_asan_link_order=0"}});
  expect_sentence(result, 5, {csv + "/channels.csv", "Input/output error"});
  EXPECT_EQ(content(csv + "/channels.csv"), before);
}

TEST_F(FailingDisk, AFileWithoutPermissionIsNotDamaged) {
  for (const Words& command :
       {Words{"info", recording_}, Words{"info", recording_, "--verify"}, report(folder_.file("a.html"))}) {
    const auto result = run_program(
        command, {.environment = {"LD_PRELOAD=" NETPOCKET_FAULT_LIBRARY, "NETPOCKET_UNREADABLE=" + recording_,
                                  "ASAN_OPTIONS=verify_asan_link_order=0"}});
    expect_sentence(result, 5, {recording_, "Permission denied"});
    EXPECT_FALSE(contains(result.error, "damaged"));
  }
}

// Wherever the disk becomes full: the file that stood there, or the whole new one.
TEST_F(FailingDisk, HardeningAtARandomByte) {
  const std::string png = folder_.file("a.png"), glb = folder_.file("a.glb"), html = folder_.file("a.html"),
                    csv = folder_.file("csv"), svg = folder_.file("svg");
  const std::vector<std::pair<Words, std::string>> outputs = {{sheet(png), png},
                                                              {gltf(glb), glb},
                                                              {report(html), html},
                                                              {table(csv), csv + "/channels.csv"},
                                                              {figures(svg), svg + "/figure03_closing.svg"}};
  for (const auto& [command, path] : outputs) ASSERT_EQ(run_program(command).exit_code, 0) << path;
  const std::vector<std::string> before = names();
  std::mt19937 random(7);
  const int trials = test::trial_count(3, 500);
  int full = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const auto& [command, path] = outputs[random() % outputs.size()];
    const std::string old = content(path);
    const std::size_t limit = 1 + random() % (old.size() + old.size() / 4);
    const auto result = run_program(command, {.largest_file = limit});
    if (result.exit_code == 0) {
      EXPECT_EQ(content(path).size(), old.size()) << path;
      continue;
    }
    ++full;
    if (result.error.size() < limit) expect_sentence(result, 5, {"cannot write \"" + path + "\": ", "File too large"});
    EXPECT_EQ(content(path), old) << path << " at byte " << limit;
  }
  EXPECT_EQ(names(), before);
  if (HasFailure()) return;
  EXPECT_TRUE(
      test::record_hardening({"picture, scene, report, table or figure on a disk that becomes full at a random byte",
                              std::to_string(trials) + " outputs",
                              std::to_string(full) + " said so in one sentence and left the older file as it "
                                                     "was, the others were whole; nothing half-written stayed"}));
}

class MeddledRun : public testing::Test {
 protected:
  // Does something to the recording of a run that goes on, which then ends by itself; if not, the test ends it.
  ProgramResult run_while(const std::function<void()>& meddle) const {
    RunningProgram program(run_words(path_, "1000"));
    for (int tries = 0; tries < 3000 && !std::filesystem::exists(path_); ++tries) std::this_thread::sleep_for(10ms);
    std::this_thread::sleep_for(1s);
    meddle();
    return program.wait();
  }

  TestFolder folder_;
  std::string path_ = folder_.file("run.h5");
};

TEST_F(MeddledRun, EndsWhenItsRecordingIsCutShort) {
  const auto result = run_while([&] { std::filesystem::resize_file(path_, std::filesystem::file_size(path_) / 2); });
  expect_sentence(result, 5, {path_, "another program has cut it short"});
  EXPECT_FALSE(contains(result.error, "holds what was recorded"));
}

TEST_F(MeddledRun, EndsWhenItsRecordingIsDeleted) {
  const auto result = run_while([&] { std::filesystem::remove(path_); });
  expect_sentence(result, 5, {path_, "deleted, moved or replaced"});
  EXPECT_FALSE(contains(result.error, "holds what was recorded"));
}

TEST_F(MeddledRun, EndsWhenItsRecordingIsMovedWhichStaysSound) {
  const std::string moved = folder_.file("moved.h5");
  const auto result = run_while([&] { std::filesystem::rename(path_, moved); });
  expect_sentence(result, 5, {path_, "deleted, moved or replaced"});
  EXPECT_EQ(Recording(moved).status().reason, RunReason::storage_failed);
  EXPECT_GT(Recording(moved).frame_count(), 5u);
  EXPECT_EQ(run_program({"info", moved, "--verify"}).exit_code, 0);
}

TEST_F(MeddledRun, LeavesTheFileThatTookItsPlace) {
  const auto result = run_while([&] {
    std::filesystem::remove(path_);
    folder_.write("run.h5", "mine");
  });
  expect_sentence(result, 5, {path_, "deleted, moved or replaced"});
  EXPECT_EQ(content(path_), "mine");
}

}  // namespace
}  // namespace netpocket
