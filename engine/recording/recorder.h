#pragma once
// Writes a run to an HDF5 file, frame by frame. Layout: engine/recording/FORMAT.md.
// Thread contract: one thread at a time. Errors: throws RecordingError with one sentence that names the file.

#include <memory>
#include <stdexcept>
#include <string>

#include "engine/recording/run_status.h"
#include "engine/recording/snapshot.h"
#include "engine/recording/structure.h"

namespace netpocket {

class RecordingError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// What a recording says about where it comes from.
struct RunOrigin {
  std::string scenario_name;
  std::string scenario_text;     // complete TOML, as run (after --set)
  std::string netpocket_version;
  std::string commit;
  std::string command;           // command line or "workbench"
  int seed = 0;
  int threads = 1;
};

class Recorder {
 public:
  // Creates the file. Refuses to replace an existing one unless `overwrite`; then the old file stays until the new one
  // holds its first frame.
  Recorder(const std::string& path, const RunOrigin& origin, const Structure& structure, bool overwrite);
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  void write(const Snapshot& snapshot);
  // Stores how the run ended and closes the file. A recording without it is one whose program was killed.
  void finish(const RunStatus& status, const RunStatistics& statistics);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace netpocket
