#pragma once
// What a SimulationWorker's thread does: obeys commands and steps the simulation between them.

#include <deque>
#include <map>

#include "engine/capture/simulation.h"
#include "gui/workbench/simulation/run_pace.h"
#include "gui/workbench/simulation/simulation_worker.h"

namespace netpocket {

class WorkerLoop {
 public:
  WorkerLoop(SimulationWorker& worker, std::stop_token stop) : worker_(worker), stop_(std::move(stop)) {}

  // Until the worker is stopped.
  void run();

 private:
  void obey_all(const std::deque<WorkerCommand>& commands);
  void obey(const WorkerCommand& command);
  // What branches of a run need to know of it, whether it is simulated or not.
  void note_start(const BeginRun& command);
  const CheckpointLog& note_start(const BeginBranch& command);
  void on(const BeginRun& command);
  void on(const BeginBranch& command);
  void on(const Resume& command);
  void on(const Pause& command);
  void on(const SingleStep& command);
  void on(const SetPace& command);
  void on(const SetThreads& command);
  void on(const ChangeStrategy& command);
  void on(const Disturb& command);

  Diagnostics change_to(const Scenario& scenario);

  void install(RunId run, Simulation simulation);
  void advance();
  void after_frame(const Snapshot& snapshot);
  double next_frame_time() const;
  void report_frame();
  void report_checkpoint(const Scenario* strategy = nullptr);
  void report_state(WorkerState state, const RunStatus& status);
  void guard(const std::function<void()>& action);

  SimulationWorker& worker_;
  std::stop_token stop_;
  RunId run_ = -1;
  std::optional<Simulation> simulation_;
  std::map<RunId, CheckpointLog> logs_;  // of all runs, for branches
  bool running_ = false;
  Resume goal_;
  bool touched_ = false;        // whether the last frame had contact
  double frame_time_ = -1;      // s, of the last frame reported
  double next_checkpoint_ = 0;  // s, for the recording
  RunPace pace_;
};

}  // namespace netpocket
