#pragma once
// The recording behind a run of the session: written while the run goes on, read at the same time. Its functions throw
// RecordingError.
// Thread contract: made anywhere, used on the storage thread.

#include <memory>
#include <optional>
#include <string>

#include "engine/capture/checkpoint_log.h"
#include "engine/recording/recorder.h"
#include "engine/recording/recording.h"

namespace netpocket {

class RunFile {
 public:
  // A temporary recording, removed with the object.
  static std::shared_ptr<RunFile> temporary(const std::string& path);
  // An existing recording, which is only read; a temporary one is removed with the object.
  static std::shared_ptr<RunFile> existing(Recording recording, bool temporary);
  ~RunFile();

  const std::string& path() const { return path_; }

  void begin(const RunOrigin& origin, const Structure& structure);
  void write(const Snapshot& snapshot);
  void write(const Checkpoint& checkpoint);
  void finish(const RunStatus& status, const RunStatistics& statistics);
  // Begins as another run did, with its first `count` frames and what leads to `time` (s).
  void begin_branch(RunFile& source, std::size_t count, double time, const Structure& structure);
  // From where the run can be continued at `time` (s).
  CheckpointLog checkpoint_log(double time, const SimulationOptions& options);

  Snapshot frame(std::size_t index);
  // A complete recording of what there is so far, under another name.
  void save_as(const std::string& path);

 private:
  RunFile(std::string path, bool temporary) : path_(std::move(path)), temporary_(temporary) {}
  Recording& reader(std::size_t frame_count);
  // With everything written so far.
  Recording& complete_reader();

  std::string path_;
  bool temporary_;
  RunOrigin origin_;
  std::unique_ptr<Recorder> recorder_;
  std::optional<Recording> reader_;
  std::size_t written_ = 0;
};

}  // namespace netpocket
