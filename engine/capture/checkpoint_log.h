#pragma once
// From where a run can be continued: its complete states at intervals and every change of strategy. The workbench keeps
// one for each run of the session, and a recording holds one. Copies are cheap.
// Thread contract: one thread at a time; the checkpoints themselves are shared and never change.

#include <memory>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/capture/simulation.h"
#include "engine/state/checkpoint.h"

namespace netpocket {

class Recording;

// A run that cannot be continued; one sentence says why.
class ResumeError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Simulated time between the checkpoints of a recording.
inline constexpr double kCheckpointInterval = 1.0;  // s

// The state now. With a scenario: whose strategy takes over now, by Simulation::change_strategy after this call.
Checkpoint take_checkpoint(const Simulation& simulation, const Scenario* strategy = nullptr);

class CheckpointLog {
 public:
  CheckpointLog() = default;
  // Of a run that begins now: with the target's mesh as it is now.
  CheckpointLog(const Scenario& scenario, const SimulationOptions& options);
  // What of a recorded run leads to `time`: its changes of strategy and the last state before. Throws RecordingError
  // when the file is damaged and ResumeError when its scenario is not valid here.
  CheckpointLog(const Recording& recording, double time, const SimulationOptions& options);

  // Keeps the state now, if the last one kept is long enough ago.
  void note_state(const Simulation& simulation);
  // Keeps the state in which a strategy takes over.
  void note_change(std::shared_ptr<const Checkpoint> checkpoint);

  // The scenario that the run began with, its mesh included.
  const Scenario& scenario() const { return scenario_; }
  bool changes_strategy() const;
  // Continues to another end time (s) than the run's scenarios say.
  void set_end_time(double time) { end_time_ = scenario_.output.end_time = time; }

  // What of the log lies before a time (s): that of a branch.
  CheckpointLog until(double time) const;

  // A simulation that has come to `time` (s, within the run): restored from the last state kept before it and stepped
  // from there, so that it continues to the last bit as the run did. Ends early, before `time`, when stopped. Throws
  // ResumeError when a state does not belong to the scenario.
  Simulation simulation_at(double time, const std::stop_token& stop = {}) const;

 private:
  void thin_out();

  Scenario scenario_;
  SimulationOptions options_;
  std::vector<std::shared_ptr<const Checkpoint>> checkpoints_;  // in the order in which they were taken
  double interval_ = 0.2;                                       // s, between states kept
  double end_time_ = 0;                                         // s; 0: as the scenarios say
};

}  // namespace netpocket
