#pragma once
// What the window works with: the runs, the simulation's thread and which frame of which run is shown.
// Thread contract: the user interface's thread.

#include <QObject>
#include <atomic>
#include <memory>

#include "gui/workbench/session/run_library.h"
#include "gui/workbench/simulation/simulation_worker.h"

namespace netpocket {

struct SessionOptions {
  RunOptions origin;                                 // of the recordings made
  std::size_t cache_bytes = std::size_t{512} << 20;  // of frames in memory
  QString folder;                                    // for recordings until they are saved; empty: the system's
};

class CaptureSession : public QObject {
  Q_OBJECT
 public:
  explicit CaptureSession(const SessionOptions& options);
  ~CaptureSession() override;

  RunLibrary& runs() { return runs_; }
  // The run that is shown; null when there is none.
  const Run* current() const { return runs_.find(current_); }
  // The run that the worker holds and can step; null when there is none.
  const Run* live() const { return runs_.find(live_); }
  bool is_running() const { return live() != nullptr && live()->state == RunState::running; }

  void show_run(RunId id);
  void show_frame(std::size_t index);
  // Shows the frame nearest to a time, s.
  void show_time(double time);
  std::size_t shown_index() const { return shown_; }
  // Whether new frames are shown as they come.
  bool follows() const { return follow_; }
  void set_follow(bool follow);

  // Makes a new run and starts it, or leaves it paused at its first frame.
  void start(const Scenario& scenario, bool run);
  void resume(const Resume& goal = {});
  void pause();
  // One integration step of the live run.
  void single_step();
  void set_pace(double rate);
  // Of the runs started from now on.
  void set_threads(int threads);
  // Closing, towing and friction of the live run from now on.
  void change_strategy(const Scenario& scenario);
  // Disturbs the live run from its present time on.
  void disturb(const DisturbanceParameters& disturbance);
  // Continues the shown run from the shown frame as a run of its own; the strategy is the scenario's. False when it was
  // opened from a file and so has no complete state to continue from.
  bool branch(const Scenario& scenario);
  void remove_run(RunId id);

 signals:
  void current_changed();                                                 // another run is shown
  void frame_wanted();                                                    // of the current run, to be shown when read
  void frame_shown(std::shared_ptr<const netpocket::Snapshot> snapshot);  // of the current run
  void strategy_answered(netpocket::RunId run, const netpocket::Diagnostics& refused,
                         double time);  // change_strategy()
  void run_diverged(const QString& message);
  void failed(const QString& reason);

 private:
  void take_reports();
  void take(const RunBegun& report);
  void take(const FrameReady& report);
  void take(const StateChanged& report);
  void take(const StrategyChanged& report);
  void take(const CheckpointTaken& report);
  void take(const WorkerFailed& report);
  void leave_live_run();
  void finish_left_runs(RunId reporting);
  void post(WorkerCommand command);
  void begin_from_file(RunId parent, double time, const Scenario& scenario);
  void release_held();
  void frame_loaded(RunId run, std::size_t index);

  RunLibrary runs_;
  static constexpr RunId kNoRun = -1;

  RunId current_ = kNoRun;
  RunId live_ = kNoRun;
  std::vector<RunId> left_;  // that the worker has not answered for yet
  std::optional<std::vector<WorkerCommand>> held_;
  int reading_ = 0;  // branches whose start is being read from a recording
  std::size_t shown_ = 0;
  bool follow_ = true;
  std::atomic<bool> notified_ = false;
  std::unique_ptr<SimulationWorker> worker_;  // last: it is stopped before the rest goes
};

}  // namespace netpocket
