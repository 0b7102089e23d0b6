#pragma once
// All runs of the session with their frames: in memory as far as the cache reaches, in recordings for the rest.
// Thread contract: the user interface's thread.

#include <QObject>
#include <map>

#include "engine/capture/run.h"
#include "gui/workbench/session/frame_cache.h"
#include "gui/workbench/session/run.h"
#include "gui/workbench/session/run_folder.h"
#include "gui/workbench/session/storage_thread.h"

namespace netpocket {

class RunLibrary : public QObject {
  Q_OBJECT
 public:
  // Recordings of runs simulated here carry `origin` and lie below `folder` until they are saved.
  RunLibrary(RunOptions origin, std::size_t cache_bytes, const QString& folder);
  ~RunLibrary() override;

  // A run whose frames are still to come.
  RunId add(const QString& name, const Scenario& scenario);
  // A branch that shares the parent's frames up to `time`, s.
  RunId add_branch(RunId parent, double time);
  // Reads a recording in the background; then run_added() or failed() follows.
  void open(const QString& path);
  // Takes over what a crashed session has left; as open(), and unsaved as it was.
  void recover(const LostRuns& lost);
  void remove(RunId id);

  // In the order in which they were added.
  std::vector<RunId> ids() const;
  // Null when there is none.
  const Run* find(RunId id) const;
  std::vector<RunId> unsaved() const;
  void rename(RunId id, const QString& name);
  // The name, or with a number after it when a run has it already.
  QString unused_name(const QString& name) const;
  void add_note(RunId id, const TimeMark& mark);
  void remove_note(RunId id, double time);

  void begin(RunId id, std::shared_ptr<const Structure> structure, const Scenario& scenario);
  void append(RunId id, const std::shared_ptr<const Snapshot>& frame, const RunStatistics& statistics, double speed);
  void append(RunId id, std::shared_ptr<const Checkpoint> checkpoint);
  // Reads from a run's recording what leads to `time` (s), then calls `use` on the user interface's thread: with
  // nothing when it cannot be read, which is reported.
  void read_checkpoints(RunId id, double time, std::function<void(std::optional<CheckpointLog>)> use);
  void set_state(RunId id, RunState state, const RunStatus& status, const RunStatistics& statistics);
  void set_scenario(RunId id, const Scenario& scenario);
  // Stores how the run ended; no frame follows.
  void finish(RunId id);

  // Null when it has to be read first: then frame_loaded() follows. Of several such requests for a run the last counts.
  std::shared_ptr<const Snapshot> frame(RunId id, std::size_t index);
  // Null when it would have to be read.
  std::shared_ptr<const Snapshot> frame_in_memory(RunId id, std::size_t index) const { return cache_.peek(id, index); }

  // Frames wait to be written: no more should come for now.
  bool is_busy() const { return storage_.waiting() > kMostWaiting; }
  void set_cache_bytes(std::size_t bytes) { cache_.set_capacity(bytes); }
  // Of the recordings made from now on.
  void set_threads(int threads) { origin_.threads = threads; }
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
  void saved(const QString& path);  // and the run is not unsaved any more
  void failed(const QString& reason);

 private:
  static constexpr std::size_t kMostWaiting = 64;

  RunId insert(Run run);
  Run* get(RunId id);
  QString temporary_path(RunId id) const;
  // Runs a job on the storage thread; a RecordingError is reported.
  void store(std::function<void()> job);
  void later(std::function<void()> action);
  struct OpenedRecording;
  void add_recording(OpenedRecording opened);
  void read_recording(const QString& path, bool recovered);
  void load(RunId id, std::size_t index);
  void load_next();

  RunOptions origin_;
  RunFolder folder_;
  std::map<RunId, Run> runs_;
  RunId next_ = 0;
  FrameCache cache_;
  std::map<RunId, std::size_t> wanted_;  // frames to load next
  bool loading_ = false;
  bool write_failed_ = false;
  StorageThread storage_;  // last: it ends before the rest goes
};

}  // namespace netpocket
