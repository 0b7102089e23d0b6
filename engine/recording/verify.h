#pragma once
// Checks a recording from end to end.

#include <cstdint>
#include <string>
#include <vector>

namespace netpocket {

struct Verification {
  std::size_t frames = 0;
  std::size_t checkpoints = 0;
  std::uint64_t chunks = 0;           // whose checksum was computed
  std::uint64_t bytes = 0;            // of these chunks, as stored
  std::vector<std::string> problems;  // one sentence each; after twenty the rest is not listed

  bool ok() const { return problems.empty(); }
};

// Reads all of a recording: the checksum of every chunk and of all metadata, every frame and checkpoint, and that their
// numbers are finite and their times in order. Throws RecordingError when the file cannot be opened as a recording.
Verification verify_recording(const std::string& path);

}  // namespace netpocket
