#pragma once
// From where a run can be continued: its complete states at intervals and every change of strategy. Copies are cheap.
// Thread contract: one thread at a time.

#include <map>
#include <memory>
#include <stop_token>
#include <vector>

#include "engine/dynamics/simulation.h"

namespace netpocket {

class CheckpointLog {
 public:
  CheckpointLog() = default;
  CheckpointLog(const Scenario& scenario, const SimulationOptions& options) : scenario_(scenario), options_(options) {}

  // Keeps the state now, if the last one kept is long enough ago.
  void note_state(const Simulation& simulation);
  // To be called before Simulation::change_strategy.
  void note_change(const Simulation& simulation, const Scenario& scenario);

  // What of the log lies before a time (s): that of a branch.
  CheckpointLog until(double time) const;

  // A simulation that has come to `time` (s, within the run): restored from the last state kept before it and stepped
  // from there, so that it continues to the last bit as the run did. Ends early, before `time`, when stopped.
  Simulation simulation_at(double time, const std::stop_token& stop) const;

 private:
  using State = std::shared_ptr<const std::vector<double>>;
  struct Change {
    double time;
    State before;
    Scenario scenario;
  };

  void thin_out();

  Scenario scenario_;
  SimulationOptions options_;
  std::vector<Change> changes_;
  std::map<double, State> states_;  // by time
  double interval_ = 0.2;           // s, between states kept
};

}  // namespace netpocket
