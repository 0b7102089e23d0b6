#pragma once
// Writes a run to an HDF5 file, frame by frame. engine/recording/FORMAT.md describes the layout.
// Thread contract: one thread at a time. Errors: FileError with one sentence that names the file; RecordingError for
// data that no recording can hold.

#include <memory>
#include <string>
#include <vector>

#include "engine/base/file_error.h"
#include "engine/state/checkpoint.h"
#include "engine/state/phase.h"
#include "engine/state/run_status.h"
#include "engine/state/snapshot.h"
#include "engine/state/structure.h"

namespace netpocket {

// A file that is not a valid recording, or data that would not give one.
class RecordingError : public FileError {
 public:
  using FileError::FileError;
};

// Origin of a run as its recording stores it.
struct RunOrigin {
  std::string scenario_name;
  std::string scenario_text;  // complete TOML, as run (after --set)
  std::string netpocket_version;
  std::string commit;
  std::string command;  // command line or "workbench"
  int seed = 0;
  int threads = 1;
  std::vector<Phase> phases;  // of the capture, as planned
  std::string draft;          // of a draft: what it is and its measured bias (scenario/fidelity.h); else empty
};

class Recorder {
 public:
  // Creates the file. Refuses to replace an existing one unless `overwrite`. Until it holds its first frame, the
  // recording is called `path` + ".part", and an existing file stays. Two recorders never write the same file. Any
  // number of Recording objects may read it meanwhile.
  Recorder(const std::string& path, const RunOrigin& origin, const Structure& structure, bool overwrite);
  // Without finish(): keeps every frame written, with the reason `running`. A recording without a frame is removed.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  // For a recording that repeats an older one. It keeps its working name until it has this many frames, and is removed
  // when it ends with fewer. To be called before the first frame.
  void hold_back(std::size_t frame_count);

  // Adds a frame. Its sizes must be those of the structure, its numbers finite, and its time not before that of the
  // last frame. All frames are flushed at most one second (wall time) after the previous flush. They then survive the
  // death of the program and of the machine.
  void write(const Snapshot& snapshot);
  // Adds a state from which the run can be resumed. Its time must not be before that of the last checkpoint.
  void write(const Checkpoint& checkpoint);
  // Flushes all frames now, for callers that pause.
  void flush();
  bool is_published() const;  // whether it has its final name
  // Stores how the run ended and closes the file. A recording without an outcome is one whose program was killed. When
  // the disk is full, earlier frames remain and finish() still stores the reason. After a write failed on the way to
  // the disk, nothing more is written, because it is not known what the system has stored. When the file has lost its
  // name, everything is written and FileError is thrown.
  void finish(const RunStatus& status, const RunStatistics& statistics);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace netpocket
