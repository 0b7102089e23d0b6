#pragma once
// Writes a run to an HDF5 file, frame by frame. Layout: engine/recording/FORMAT.md.
// Thread contract: one thread at a time. Errors: FileError with one sentence that names the file; RecordingError for
// what no recording can hold.

#include <limits>
#include <memory>
#include <string>

#include "engine/base/file_error.h"
#include "engine/state/checkpoint.h"
#include "engine/state/run_status.h"
#include "engine/state/snapshot.h"
#include "engine/state/structure.h"

namespace netpocket {

// What is, or would become, no valid recording.
class RecordingError : public FileError {
 public:
  using FileError::FileError;
};

// What a recording says about where it comes from.
struct RunOrigin {
  std::string scenario_name;
  std::string scenario_text;  // complete TOML, as run (after --set)
  std::string netpocket_version;
  std::string commit;
  std::string command;  // command line or "workbench"
  int seed = 0;
  int threads = 1;
  double closing_end = std::numeric_limits<double>::quiet_NaN();   // s, when the closing law ends; NaN: unknown
  double towing_start = std::numeric_limits<double>::quiet_NaN();  // s; NaN: no towing
};

class Recorder {
 public:
  // Creates the file. Refuses to replace an existing one unless `overwrite`; then the old file stays until the new one
  // holds its first frame: until that moment the recording is called `path` + ".part". Two recorders never write the
  // same file; one Recording or more may read it meanwhile.
  Recorder(const std::string& path, const RunOrigin& origin, const Structure& structure, bool overwrite);
  // Without finish(): keeps every frame written, with the reason `running`. A recording without a frame is removed.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  // For a recording that repeats an older one: it keeps its working name until it holds this many frames, and is
  // removed when it ends with fewer. To be called before the first frame.
  void hold_back(std::size_t frame_count);

  // Adds a frame. Its sizes are those of the structure, its numbers are finite and its time is not before the last
  // frame's. At most one second of wall time after the previous flush, all frames are flushed: they survive the death
  // of the program and of the machine.
  void write(const Snapshot& snapshot);
  // Adds a state from which the run can be resumed. Its time is not before the last checkpoint's.
  void write(const Checkpoint& checkpoint);
  // Makes all frames survive now; for callers that pause.
  void flush();
  bool is_published() const;  // under the name asked for
  // Stores how the run ended and closes the file. A recording without it is one whose program was killed. Where the
  // disk is full the frames before remain, and finish() still stores the reason. After a write that failed on the way
  // to the disk nothing more is written: what the system has stored of it is not known. When the file has lost its
  // name, all is written and FileError thrown.
  void finish(const RunStatus& status, const RunStatistics& statistics);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace netpocket
