#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <string>

#include "engine/recording/hdf5_support.h"
#include "engine/recording/recording.h"
#include "engine/recording/verify.h"
#include "tests/engine/recording/synthetic_run.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/recording_edits.h"

namespace netpocket {
namespace {

constexpr std::size_t kMostFrames = 16;

// A file in memory that has a path.
class MemoryFile {
 public:
  explicit MemoryFile(std::span<const std::uint8_t> bytes) : descriptor_(memfd_create("fuzz", MFD_CLOEXEC)) {
    for (std::size_t at = 0; at < bytes.size();) {
      const ssize_t written = ::write(descriptor_, bytes.data() + at, bytes.size() - at);
      if (written <= 0) break;
      at += static_cast<std::size_t>(written);
    }
  }
  ~MemoryFile() { close(descriptor_); }
  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

const std::string& sound_recording() {
  static const std::string bytes = [] {
    const TemporaryFolder folder;
    write_synthetic_run(folder.file("run.h5"), 3, 4);
    return read_bytes(folder.file("run.h5"));
  }();
  return bytes;
}

void read_all(const std::string& path) {
  try {
    const Recording recording(path);
    for (std::size_t i = 0; i < std::min(kMostFrames, recording.frame_count()); ++i) recording.frame(i);
    for (std::size_t i = 0; i < std::min(kMostFrames, recording.checkpoint_times().size()); ++i) {
      recording.checkpoint(i);
    }
    verify_recording(path);
  } catch (const RecordingError&) {
    // Refused with a reason.
  }
}

}  // namespace

void fuzz_recording(std::span<const std::uint8_t> bytes) {
  silence_hdf5();
  const bool is_file = !bytes.empty() && bytes[0] == 0x89;
  if (is_file) {
    read_all(MemoryFile(bytes).path());
    return;
  }
  const std::string& sound = sound_recording();
  const MemoryFile file({reinterpret_cast<const std::uint8_t*>(sound.data()), sound.size()});
  edit_recording(file.path(), bytes);
  read_all(file.path());
}

}  // namespace netpocket
