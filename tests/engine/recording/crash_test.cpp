// A recording survives the death of its program and a full disk.
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "engine/recording/recording.h"
#include "tests/engine/recording/synthetic_run.h"
#include "tests/hardening/hardening_table.h"

namespace netpocket {
namespace {

constexpr int kElements = 200;

// Records frames until it is killed. After each it says so through a pipe.
[[noreturn]] void record_forever(const std::string& path, int pipe) {
  const Structure structure = synthetic_structure(kElements);
  Recorder recorder(path, synthetic_origin(), structure, false);
  for (int i = 0; true; ++i) {
    recorder.write(synthetic_frame(structure, i));
    if (write(pipe, "", 1) != 1) _exit(1);
  }
}

// Frames that a child wrote, and of them those that were a second old when it was killed.
struct Progress {
  std::size_t frames = 0;
  std::size_t frames_a_second_ago = 0;
};

Progress kill_after(std::chrono::milliseconds delay, const std::string& path) {
  using Clock = std::chrono::steady_clock;
  int ends[2];
  EXPECT_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0) record_forever(path, ends[1]);
  close(ends[1]);
  // The delay counts from the first frame on: on a busy machine that one takes its time.
  char first = 0;
  EXPECT_EQ(read(ends[0], &first, 1), 1);
  std::vector<Clock::time_point> written = {Clock::now()};
  std::thread reader([&] {
    for (char byte; read(ends[0], &byte, 1) == 1;) written.push_back(Clock::now());
  });
  std::this_thread::sleep_for(delay);
  const auto end = Clock::now();
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  reader.join();
  close(ends[0]);
  // A busy machine may take longer for a single flush, also for the one in which it is killed: then for the frames of
  // that flush there is no second.
  Clock::duration longest_write = end - written.back();
  for (std::size_t i = 1; i < written.size(); ++i) longest_write = std::max(longest_write, written[i] - written[i - 1]);
  const auto age =
      std::max<Clock::duration>(std::chrono::seconds(1), std::chrono::milliseconds(500) + 2 * longest_write);
  const auto old = std::lower_bound(written.begin(), written.end(), end - age) - written.begin();
  return {written.size(), static_cast<std::size_t>(old)};
}

TEST(CrashHardening, KilledRecorderLosesAtMostASecond) {
  std::mt19937 random(20230916);
  std::uniform_int_distribution<int> milliseconds(50, 2500);
  const int trials = test::trial_count(5, 50);
  std::size_t frames = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const TemporaryFolder folder;
    const std::string path = folder.file("run.h5");
    const Progress progress = kill_after(std::chrono::milliseconds(milliseconds(random)), path);
    ASSERT_GT(progress.frames, 0u);
    const Recording recording(path);
    EXPECT_GE(recording.frame_count(), std::max<std::size_t>(1, progress.frames_a_second_ago));
    EXPECT_LE(recording.frame_count(), progress.frames + 1);
    EXPECT_EQ(recording.status().reason, RunReason::running);
    for (std::size_t i = recording.frame_count(); i-- > 0; i -= i / 20) {  // the last ones, fewer of those before
      const Snapshot expected = synthetic_frame(recording.structure(), static_cast<int>(i));
      const Snapshot found = recording.frame(i);
      ASSERT_EQ(found.channels, expected.channels);
      ASSERT_EQ(found.positions, expected.positions.cast<float>().cast<double>());
      ASSERT_EQ(found.strain, expected.strain.cast<float>().cast<double>());
      ASSERT_EQ(found.contacts.size(), expected.contacts.size());
      ASSERT_EQ(found.bodies[0].position, expected.bodies[0].position);
    }
    frames += recording.frame_count();
  }
  if (HasFailure()) return;
  EXPECT_TRUE(test::record_hardening({"recorder killed (SIGKILL) at a random moment", std::to_string(trials) + " kills",
                                      "every file opened with each of its frames right (" + std::to_string(frames) +
                                          " in all) and none missing that was a second old"}));
}

TEST(Crash, KilledRecordingCanBeReplaced) {
  const TemporaryFolder folder;
  const std::string path = folder.file("run.h5");
  kill_after(std::chrono::milliseconds(100), path);
  write_synthetic_run(path, 3);
  EXPECT_EQ(Recording(path).frame_count(), 3u);
}

// A limit on the size of files stands for the full disk: it can be set without being root. 0 is success, else a line.
int record_on_a_full_disk(const std::string& path) {
  signal(SIGXFSZ, SIG_IGN);
  const rlimit limit = {64u << 20, 64u << 20};
  if (setrlimit(RLIMIT_FSIZE, &limit) != 0) return __LINE__;
  const Structure structure = synthetic_structure(2000);
  Recorder recorder(path, synthetic_origin(), structure, false);
  const Snapshot frame = synthetic_frame(structure, 0);
  try {
    for (int i = 0; i < 10000; ++i) recorder.write(frame);
  } catch (const FileError& error) {
    recorder.finish({RunReason::storage_failed, frame.time, error.what()}, {});
    return 0;
  }
  return __LINE__;
}

TEST(Crash, FullDiskKeepsTheFramesBefore) {
  const TemporaryFolder folder;
  const std::string path = folder.file("run.h5");
  const pid_t child = fork();
  if (child == 0) _exit(record_on_a_full_disk(path));
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  ASSERT_EQ(WEXITSTATUS(status), 0);
  const Recording recording(path);
  EXPECT_GT(recording.frame_count(), 100u);
  EXPECT_NO_THROW(recording.frame(recording.frame_count() - 1));
  EXPECT_EQ(recording.status().reason, RunReason::storage_failed);
  EXPECT_NE(recording.status().message.find("size limit"), std::string::npos) << recording.status().message;
}

// A disk of its own, seen by this process alone; false where the system does not allow it.
bool mount_small_disk(const std::string& folder) {
  if (unshare(CLONE_NEWNS | (geteuid() == 0 ? 0 : CLONE_NEWUSER)) != 0) return false;
  if (mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) return false;
  return mount("none", folder.c_str(), "tmpfs", 0, "size=48m") == 0;
}

constexpr int kNoDisk = 77;

// As the process sees it that fills the disk: 0 is success, kNoDisk that there is none, else a line.
int fill_a_disk(const std::string& folder) {
  if (!mount_small_disk(folder)) return kNoDisk;
  const std::string path = folder + "/run.h5";
  const Structure structure = synthetic_structure(2000);
  const Snapshot frame = synthetic_frame(structure, 0);
  std::size_t written = 0;
  {
    Recorder recorder(path, synthetic_origin(), structure, false);
    try {
      for (; written < 10000; ++written) recorder.write(frame);
      return __LINE__;
    } catch (const FileError& error) {
      recorder.finish({RunReason::storage_failed, frame.time, error.what()}, {});
    }
  }
  const Recording recording(path);
  if (recording.frame_count() != written || written < 10) return __LINE__;
  recording.frame(written - 1);
  if (recording.status().reason != RunReason::storage_failed) return __LINE__;
  return recording.status().message.find("the disk is full") != std::string::npos ? 0 : __LINE__;
}

TEST(Crash, RealFullDiskKeepsEveryFrame) {
  const TemporaryFolder folder;
  const pid_t child = fork();
  if (child == 0) _exit(fill_a_disk(folder.path().string()));
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  if (WEXITSTATUS(status) == kNoDisk) GTEST_SKIP() << "this system lets nobody mount a small disk";
  EXPECT_EQ(WEXITSTATUS(status), 0) << "line of this file";
}

}  // namespace
}  // namespace netpocket
