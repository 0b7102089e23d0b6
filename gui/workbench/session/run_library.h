#pragma once
// All runs of the session with their frames: in memory as far as the cache reaches, in recordings for the rest.
// Thread contract: the user interface's thread.

#include <QObject>
#include <QTemporaryDir>
#include <map>
#include <optional>

#include "engine/dynamics/run.h"
#include "gui/workbench/session/frame_cache.h"
#include "gui/workbench/session/run.h"
#include "gui/workbench/session/storage_thread.h"

namespace netpocket {

class RunLibrary : public QObject {
  Q_OBJECT
 public:
  // Recordings of runs simulated here carry `origin`.
  explicit RunLibrary(RunOptions origin, std::size_t cache_bytes);
  ~RunLibrary() override;

  // A run whose frames are still to come.
  RunId add(const QString& name, const Scenario& scenario);
  // A branch that shares the parent's frames up to `time`, s.
  RunId add_branch(RunId parent, double time);
  // Reads a recording in the background; then run_added() or failed() follows.
  void open(const QString& path);
  void remove(RunId id);

  // In the order in which they were added.
  std::vector<RunId> ids() const;
  // Null when there is none.
  const Run* find(RunId id) const;
  void rename(RunId id, const QString& name);
  void add_note(RunId id, const TimeMark& mark);
  void remove_note(RunId id, double time);

  void begin(RunId id, std::shared_ptr<const Structure> structure, const Scenario& scenario);
  void append(RunId id, std::shared_ptr<const Snapshot> frame, const RunStatistics& statistics, double speed);
  void append(RunId id, std::shared_ptr<const Checkpoint> checkpoint);
  // Reads from a run's recording what leads to `time` (s), then calls `use` on the user interface's thread.
  void read_checkpoints(RunId id, double time, std::function<void(CheckpointLog)> use);
  void set_state(RunId id, RunState state, const RunStatus& status, const RunStatistics& statistics);
  void set_scenario(RunId id, const Scenario& scenario);
  // Stores how the run ended; no frame follows.
  void finish(RunId id);

  // Null when it has to be read first: then frame_loaded() follows. Of several such requests the last one counts.
  std::shared_ptr<const Snapshot> frame(RunId id, std::size_t index);

  // Frames wait to be written: no more should come for now.
  bool is_busy() const { return storage_.waiting() > kMostWaiting; }
  void set_cache_bytes(std::size_t bytes) { cache_.set_capacity(bytes); }
  std::size_t cache_bytes() const { return cache_.bytes(); }

  // Writes the run as a recording of its own in the background; then saved() or failed() follows.
  void save(RunId id, const QString& path);
  // Calls `use` on the user interface's thread when everything simulated so far is in the run's recording.
  void flush(RunId id, std::function<void(const QString& path)> use);
  // Computes a row of numbers from every frame of a run in the background, then calls `use` on the user interface's
  // thread with the frames' times and rows.
  using FrameValues = std::function<std::vector<double>(const Snapshot&)>;
  using CollectedRows = std::function<void(const std::vector<double>& times, const std::vector<std::vector<double>>&)>;
  void collect(RunId id, FrameValues values, CollectedRows use);
  // Waits until nothing is left to write. For closing and for tests.
  void finish_writing() { storage_.finish(); }

 signals:
  void run_added(netpocket::RunId id);
  void run_removed(netpocket::RunId id);
  void run_changed(netpocket::RunId id);  // state, name or notes
  void frames_added(netpocket::RunId id);
  void frame_loaded(netpocket::RunId id, std::size_t index);
  void saved(const QString& path);
  void failed(const QString& reason);

 private:
  static constexpr std::size_t kMostWaiting = 64;

  struct Request {
    RunId run;
    std::size_t index;
  };

  RunId insert(Run run);
  Run* get(RunId id);
  QString temporary_path(RunId id) const;
  // Runs a job on the storage thread; a RecordingError is reported.
  void store(std::function<void()> job);
  void later(std::function<void()> action);
  void add_recording(Recording recording, const Scenario& scenario);
  void load(const Request& request);

  RunOptions origin_;
  QTemporaryDir folder_;
  std::map<RunId, Run> runs_;
  RunId next_ = 0;
  FrameCache cache_;
  std::optional<Request> wanted_;
  bool loading_ = false;
  bool write_failed_ = false;
  StorageThread storage_;  // last: it ends before the rest goes
};

}  // namespace netpocket
