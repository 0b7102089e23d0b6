// A recording survives the loss of power: whatever the system had stored of the last writes, the file opens and holds
// every frame that was flushed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "engine/recording/hdf5_support.h"
#include "engine/recording/recording.h"
#include "tests/engine/recording/disk_log.h"
#include "tests/engine/recording/synthetic_run.h"
#include "tests/hardening/hardening_table.h"

namespace netpocket {
namespace {

constexpr int kFewElements = 20;
constexpr std::size_t kFrames = 300;
constexpr std::size_t kFramesPerFlush = 7;

// What had to be on the disk once the log held so many events.
struct Promise {
  std::size_t events;
  std::size_t frames;
};

std::vector<Promise> record_by_flushes(const std::string& path, const test::DiskLog& log) {
  const Structure structure = synthetic_structure(kFewElements);
  Recorder recorder(path, synthetic_origin(), structure, false);
  std::vector<Promise> promises;
  for (std::size_t i = 0; i < kFrames; ++i) {
    recorder.write(synthetic_frame(structure, static_cast<int>(i)));
    if (i % 50 == 0) recorder.write(synthetic_checkpoint(static_cast<int>(i / 50)));
    if (i % kFramesPerFlush == 0) {
      recorder.flush();
      promises.push_back({log.size(), i + 1});
    }
  }
  return promises;
}

// What is wrong with a file that must hold a number of frames; empty when nothing is.
std::string fault(const std::string& path, std::size_t promised) {
  try {
    const Recording recording(path);
    if (recording.frame_count() < promised) {
      return "holds " + std::to_string(recording.frame_count()) + " of " + std::to_string(promised) + " frames";
    }
    for (std::size_t i = recording.frame_count(); i-- > 0; i -= i / 10) {  // the last ones, fewer of those before
      const Snapshot expected = synthetic_frame(recording.structure(), static_cast<int>(i));
      const Snapshot found = recording.frame(i);
      const bool same = found.channels == expected.channels &&
                        found.positions == expected.positions.cast<float>().cast<double>() &&
                        found.contacts.size() == expected.contacts.size();
      if (!same) return "frame " + std::to_string(i) + " is not what was written";
    }
  } catch (const RecordingError& error) {
    return error.what();
  }
  return "";
}

constexpr int kRowsPerChunk = 64;  // of /frames/channels

// Overwrites what is stored of the second chunk of /frames/channels.
void damage_second_chunk(const std::string& path) {
  haddr_t address = 0;
  {
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "");
    H5Pset_file_locking(access.get(), false, true);
    const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access.get()), H5Fclose, "");
    const Handle table(H5Dopen2(file.get(), "/frames/channels", H5P_DEFAULT), H5Dclose, "");
    const hsize_t offset[] = {kRowsPerChunk, 0};
    hsize_t size = 0;
    unsigned filters = 0;
    checked(H5Dget_chunk_info_by_coord(table.get(), offset, &filters, &address, &size), "find the chunk");
  }
  std::string bytes = read_bytes(path);
  bytes.replace(address, 8, 8, '\0');
  write_bytes(path, bytes);
}

TEST(PowerCut, LeavesTheFramesBeforeAChunkThatIsNotThere) {
  const TemporaryFolder folder;
  const Structure structure = synthetic_structure(kFewElements);
  Recorder recorder(folder.file("run.h5"), synthetic_origin(), structure, false);
  for (int i = 0; i < kRowsPerChunk + 3; ++i) recorder.write(synthetic_frame(structure, i));
  recorder.flush();
  write_bytes(folder.file("cut.h5"), read_bytes(folder.file("run.h5")));
  damage_second_chunk(folder.file("cut.h5"));
  EXPECT_EQ(fault(folder.file("cut.h5"), kRowsPerChunk), "");
  EXPECT_EQ(Recording(folder.file("cut.h5")).frame_count(), kRowsPerChunk);
}

TEST(PowerCut, OfAFinishedRecordingNothingIsLeftOut) {
  const TemporaryFolder folder;
  write_synthetic_run(folder.file("run.h5"), kRowsPerChunk + 3, kFewElements);
  damage_second_chunk(folder.file("run.h5"));
  EXPECT_THROW(Recording(folder.file("run.h5")), RecordingError);
}

TEST(PowerCutHardening, LeavesEveryFrameThatWasFlushed) {
  const TemporaryFolder folder;
  const std::string path = std::filesystem::canonical(folder.path()) / "run.h5";
  const test::DiskLog log(path);
  const std::vector<Promise> promises = record_by_flushes(path, log);
  ASSERT_GT(log.size(), kFrames);
  std::mt19937 random(12);
  const int trials = test::trial_count(50, 2000);
  int lost = 0;
  std::size_t kept = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const std::size_t cut = promises.front().events + random() % (promises.back().events - promises.front().events + 1);
    const auto next = std::ranges::upper_bound(promises, cut, {}, &Promise::events);
    const std::string left = folder.file("left.h5");
    write_bytes(left, log.after_power_cut(cut, random));
    const std::string problem = fault(left, std::prev(next)->frames);
    if (!problem.empty()) {
      ++lost;
      std::printf("cut after event %zu of %zu: %s\n", cut, log.size(), problem.c_str());
    }
    kept += std::prev(next)->frames;
  }
  EXPECT_EQ(lost, 0);
  EXPECT_TRUE(test::record_hardening({"power lost at a random moment (any mixture of stored and lost 4 KiB pages)",
                                      std::to_string(trials) + " cuts",
                                      std::to_string(trials - lost) + " files opened with every frame flushed (" +
                                          std::to_string(kept) + " in all), " + std::to_string(lost) + " did not"}));
}

}  // namespace
}  // namespace netpocket
