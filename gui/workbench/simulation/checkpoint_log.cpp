#include "gui/workbench/simulation/checkpoint_log.h"

#include <iterator>

namespace netpocket {
namespace {

// States kept at most, in bytes; then every second one goes and the interval doubles.
constexpr std::size_t kLargestMemory = 128 << 20;

}  // namespace

void CheckpointLog::note_state(const Simulation& simulation) {
  constexpr double kRounding = 1e-9;
  if (!states_.empty() && simulation.time() < states_.rbegin()->first + interval_ - kRounding) return;
  states_[simulation.time()] = std::make_shared<const std::vector<double>>(simulation.checkpoint());
  thin_out();
}

void CheckpointLog::note_change(const Simulation& simulation, const Scenario& scenario) {
  changes_.push_back(
      {simulation.time(), std::make_shared<const std::vector<double>>(simulation.checkpoint()), scenario});
}

void CheckpointLog::thin_out() {
  const std::size_t bytes = states_.size() * states_.begin()->second->size() * sizeof(double);
  if (bytes < kLargestMemory || states_.size() < 4) return;
  for (auto state = std::next(states_.begin()); state != states_.end();) {
    state = states_.erase(state);
    if (state != states_.end()) ++state;
  }
  interval_ *= 2;
}

CheckpointLog CheckpointLog::until(double time) const {
  CheckpointLog log = *this;
  log.states_.erase(log.states_.upper_bound(time), log.states_.end());
  std::erase_if(log.changes_, [time](const Change& change) { return change.time > time; });
  return log;
}

Simulation CheckpointLog::simulation_at(double time, const std::stop_token& stop) const {
  Simulation simulation(scenario_, options_);
  // Each change is repeated in the state in which it was made, since what it does depends on that state.
  for (const Change& change : changes_) {
    if (change.time > time) break;
    simulation.restore(*change.before);
    simulation.change_strategy(change.scenario);
  }
  const auto later = states_.upper_bound(time);
  if (later != states_.begin() && std::prev(later)->first > simulation.time()) {
    simulation.restore(*std::prev(later)->second);
  }
  simulation.advance(time, stop);
  return simulation;
}

}  // namespace netpocket
