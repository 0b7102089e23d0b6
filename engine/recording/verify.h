#pragma once
// Checks a complete recording.

#include <cstdint>
#include <string>
#include <vector>

namespace netpocket {

struct Verification {
  std::size_t frames = 0;
  std::size_t checkpoints = 0;
  std::uint64_t chunks = 0;           // number of chunks whose checksum was verified
  std::uint64_t bytes = 0;            // of these chunks, as stored
  std::vector<std::string> problems;  // one sentence each; at most twenty are listed

  bool ok() const { return problems.empty(); }
};

// Reads the whole recording: the checksum of every chunk and of all metadata, every frame and every checkpoint. Checks
// that numbers are finite and times in order. Throws RecordingError when the file cannot be opened as a recording.
Verification verify_recording(const std::string& path);

}  // namespace netpocket
