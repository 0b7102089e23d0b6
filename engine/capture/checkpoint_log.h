#pragma once
// States from which a run can be continued: complete states at intervals, and every change of strategy. The workbench
// keeps a log for each of its runs. A recording contains one. Copies are cheap: they share the checkpoints.
// Thread contract: one thread at a time. The checkpoints themselves never change.

#include <memory>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/capture/simulation.h"
#include "engine/state/checkpoint.h"

namespace netpocket {

class Recording;

// Thrown when a run cannot be continued. The message is one sentence that says why.
class ResumeError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Simulated time between the checkpoints of a recording.
inline constexpr double kCheckpointInterval = 1.0;  // s

// Checkpoint of the present state. `strategy`: scenario to be applied by Simulation::change_strategy after this call;
// null: none.
Checkpoint take_checkpoint(const Simulation& simulation, const Scenario* strategy = nullptr);

class CheckpointLog {
 public:
  CheckpointLog() = default;
  // For a run that begins now. Keeps the target's mesh as it is now.
  CheckpointLog(const Scenario& scenario, const SimulationOptions& options);
  // The part of a recorded run that leads to `time` (s): its changes of strategy and the last state before `time`.
  // Throws RecordingError when the file is damaged, and ResumeError when its scenario is not valid for this program.
  CheckpointLog(const Recording& recording, double time, const SimulationOptions& options);

  // Keeps the present state if the last checkpoint is at least an interval old (0.2 s at first). To limit memory, old
  // states are thinned out and the interval doubles.
  void note_state(const Simulation& simulation);
  // Keeps the state at which a strategy was changed.
  void note_change(std::shared_ptr<const Checkpoint> checkpoint);

  // Scenario that the run began with, including its mesh.
  const Scenario& scenario() const { return scenario_; }
  bool changes_strategy() const;
  // Replaces the end time of the run's scenarios by `time` (s).
  void set_end_time(double time) { end_time_ = scenario_.output.end_time = time; }

  // The log up to a time (s), for a branch of the run.
  CheckpointLog until(double time) const;

  // A simulation advanced to `time` (s, within the run). It is restored from the last checkpoint before `time` and
  // stepped from there, so it continues bitwise as the run did. Ends before `time` when stopped. Throws ResumeError
  // when a state does not belong to the scenario.
  Simulation simulation_at(double time, const std::stop_token& stop = {}) const;

 private:
  void thin_out();

  Scenario scenario_;
  SimulationOptions options_;
  std::vector<std::shared_ptr<const Checkpoint>> checkpoints_;  // in the order in which they were taken
  double interval_ = 0.2;                                       // s, between kept states
  double end_time_ = 0;                                         // s; 0: that of the scenarios
};

}  // namespace netpocket
