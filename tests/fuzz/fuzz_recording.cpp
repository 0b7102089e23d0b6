#include <hdf5.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <string>

#include "engine/recording/verify.h"
#include "engine/recording/hdf5_support.h"
#include "engine/recording/recording.h"
#include "tests/engine/recording/synthetic_run.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/recording_edits.h"

namespace netpocket {
namespace {

constexpr std::size_t kMostFrames = 16;

// A file of this process's own, in memory where the system has a place for that. HDF5 opens no memfd: it wants the
// path that /proc stands for.
class MemoryFile {
 public:
  explicit MemoryFile(std::span<const std::uint8_t> bytes)
      : path_((access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp") + ("/netpocket-fuzz-" + std::to_string(getpid()))) {
    write_bytes(path_, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
  ~MemoryFile() { unlink(path_.c_str()); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

const std::string& sound_recording() {
  static const std::string bytes = [] {
    const TemporaryFolder folder;
    write_synthetic_run(folder.file("run.h5"), 3, 4, 20);
    return read_bytes(folder.file("run.h5"));
  }();
  return bytes;
}

// HDF5 gives back memory beyond 64 KB of each kind at once, half a megabyte for every file that it opens; under the
// sanitizers getting it anew takes most of the time.
void keep_memory() {
  constexpr int kDefault = 1 << 20, kMost = 64 << 20;
  static const bool kept =
      H5set_free_list_limits(kMost, kMost, 4 * kDefault, kDefault / 4, 16 * kDefault, kDefault) >= 0;
  (void)kept;
}

// The check from end to end opens the file twice more and takes most of the time: one in so many of the edits has it.
bool is_to_be_verified(std::span<const std::uint8_t> edits) {
  constexpr unsigned kVerified = 32;
  return std::accumulate(edits.begin(), edits.end(), 0u) % kVerified == 0;
}

// Returns whether it was read and, if so wanted, found sound; or else refused with a reason.
bool read_all(const std::string& path, bool verify) {
  try {
    const Recording recording(path);
    for (std::size_t i = 0; i < std::min(kMostFrames, recording.frame_count()); ++i) recording.frame(i);
    for (std::size_t i = 0; i < std::min(kMostFrames, recording.checkpoint_times().size()); ++i) {
      recording.checkpoint(i);
    }
    return !verify || verify_recording(path).ok();
  } catch (const RecordingError&) {
    return false;
  }
}

}  // namespace

void fuzz_recording(std::span<const std::uint8_t> bytes) {
  silence_hdf5();
  keep_memory();
  const bool is_file = !bytes.empty() && bytes[0] == 0x89;
  if (is_file) {
    read_all(MemoryFile(bytes).path(), true);
    return;
  }
  const std::string& sound = sound_recording();
  const MemoryFile file({reinterpret_cast<const std::uint8_t*>(sound.data()), sound.size()});
  edit_recording(file.path(), bytes);
  const bool is_read = read_all(file.path(), is_to_be_verified(bytes));
  if (bytes.empty() && !is_read) {
    std::fputs("the recording that the edits start from cannot be read\n", stderr);
    std::abort();
  }
}

}  // namespace netpocket
