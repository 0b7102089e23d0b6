// A recording is checked from end to end.
#include "engine/recording/verify.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/recording/recording.h"
#include "tests/engine/recording/synthetic_run.h"

namespace netpocket {
namespace {

TEST(Verify, SoundRecording) {
  const TemporaryFolder folder;
  const std::string path = folder.file("run.h5");
  write_synthetic_run(path, 70);
  const Verification result = verify_recording(path);
  EXPECT_TRUE(result.ok()) << result.problems[0];
  EXPECT_EQ(result.frames, 70u);
  EXPECT_EQ(result.checkpoints, 2u);  // at 0 and 1 s
  EXPECT_GT(result.chunks, 350u);     // five tables with a chunk for each frame, and the rest
}

// Node data make up the most of a file: no reader looks at all of it, and yet no byte changes unnoticed.
TEST(Verify, FindsEveryDamagedChunk) {
  const TemporaryFolder folder;
  const std::string path = folder.file("run.h5");
  write_synthetic_run(path, 3, 4000);
  const std::string whole = read_bytes(path);
  const std::uint64_t chunk_bytes = verify_recording(path).bytes;
  std::mt19937 random(7);
  int found = 0;
  constexpr int kTrials = 40;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::string damaged = whole;
    damaged[random() % damaged.size()] ^= 0x10;
    write_bytes(path, damaged);
    try {
      if (!verify_recording(path).ok()) ++found;
    } catch (const RecordingError&) {
      ++found;  // damaged where it says what it holds
    }
  }
  // The rest of the file is unused room.
  const double used = static_cast<double>(chunk_bytes) / static_cast<double>(whole.size());
  EXPECT_GE(found, kTrials * used * 0.8) << "of " << kTrials << ", " << used << " of the file are chunks";
}

TEST(Verify, NamesTheDamage) {
  const TemporaryFolder folder;
  const std::string path = folder.file("run.h5");
  write_synthetic_run(path, 3, 4000);
  std::string bytes = read_bytes(path);
  bytes[bytes.size() / 2] ^= 1;
  write_bytes(path, bytes);
  const Verification result = verify_recording(path);
  ASSERT_FALSE(result.ok());
  EXPECT_NE(result.problems.back().find("the chunk at row "), std::string::npos) << result.problems.back();
}

TEST(Verify, CheckpointsReadBack) {
  const TemporaryFolder folder;
  const std::string path = folder.file("run.h5");
  write_synthetic_run(path, 70);
  const Recording recording(path);
  EXPECT_EQ(recording.checkpoint_times(), (std::vector<double>{0, 1}));
  EXPECT_FALSE(recording.changes_strategy(0));
  EXPECT_TRUE(recording.changes_strategy(1));
  EXPECT_EQ(recording.checkpoint(1).state, synthetic_checkpoint(1).state);
  EXPECT_EQ(recording.checkpoint(1).strategy, synthetic_checkpoint(1).strategy);
  EXPECT_THROW(recording.checkpoint(2), RecordingError);
}

}  // namespace
}  // namespace netpocket
