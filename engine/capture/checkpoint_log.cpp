#include "engine/capture/checkpoint_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "engine/capture/recorded_scenario.h"
#include "engine/recording/recording.h"
#include "engine/scenario/check_scenario.h"
#include "engine/scenario/read_scenario.h"
#include "engine/scenario/target_shape.h"
#include "engine/scenario/write_scenario.h"

namespace netpocket {
namespace {

// Bytes of states from which on every second one is dropped and the interval doubled.
constexpr std::size_t kLargestMemory = 128 << 20;
constexpr double kSameTime = 1e-9;  // s

Scenario valid(const ScenarioResult& result) {
  Diagnostics problems = result.diagnostics;
  if (problems.ok()) problems = check_scenario(result.scenario, RunEnd::open);
  if (!problems.ok()) throw ResumeError(fmt::format("its scenario is not valid here: {}", problems.list()[0].text()));
  return result.scenario;
}

// Scenario of a strategy. Files are those of the run's scenario.
Scenario stored_strategy(const std::string& text, const FileScope& files) {
  ScenarioResult result = read_scenario_text(text, "scenario of the run");
  result.scenario.files = files;
  return valid(result);
}

void restore(Simulation& simulation, const Checkpoint& checkpoint) {
  try {
    simulation.restore(checkpoint.state);
  } catch (const std::invalid_argument& error) {
    throw ResumeError(error.what());
  }
}

}  // namespace

Checkpoint take_checkpoint(const Simulation& simulation, const Scenario* strategy) {
  return {simulation.time(), simulation.checkpoint(), strategy ? write_scenario_text(*strategy) : ""};
}

CheckpointLog::CheckpointLog(const Scenario& scenario, const SimulationOptions& options)
    : scenario_(scenario), options_(options) {
  const auto shape = target_shape(scenario);
  if (const auto* valid_shape = std::get_if<Shape>(&shape)) keep_mesh(scenario_, *valid_shape);
}

CheckpointLog::CheckpointLog(const Recording& recording, double time, const SimulationOptions& options)
    : scenario_(valid(recorded_scenario(recording))), options_(options) {
  const auto& times = recording.checkpoint_times();
  const auto count = static_cast<std::size_t>(std::ranges::upper_bound(times, time + kSameTime) - times.begin());
  for (std::size_t i = 0; i < count; ++i) {
    if (i + 1 < count && !recording.changes_strategy(i)) continue;
    checkpoints_.push_back(std::make_shared<const Checkpoint>(recording.checkpoint(i)));
  }
}

void CheckpointLog::note_state(const Simulation& simulation) {
  if (!checkpoints_.empty() && simulation.time() < checkpoints_.back()->time + interval_ - kSameTime) return;
  checkpoints_.push_back(std::make_shared<const Checkpoint>(take_checkpoint(simulation)));
  thin_out();
}

void CheckpointLog::note_change(std::shared_ptr<const Checkpoint> checkpoint) {
  checkpoints_.push_back(std::move(checkpoint));
}

bool CheckpointLog::changes_strategy() const {
  return std::ranges::any_of(checkpoints_, [](const auto& c) { return c->changes_strategy(); });
}

void CheckpointLog::thin_out() {
  const std::size_t bytes = checkpoints_.size() * checkpoints_.front()->state.size() * sizeof(double);
  if (bytes < kLargestMemory || checkpoints_.size() < 4) return;
  std::size_t index = 0;
  std::erase_if(checkpoints_,
                [&index](const auto& checkpoint) { return index++ % 2 == 1 && !checkpoint->changes_strategy(); });
  interval_ *= 2;
}

CheckpointLog CheckpointLog::until(double time) const {
  CheckpointLog log = *this;
  std::erase_if(log.checkpoints_, [time](const auto& checkpoint) { return checkpoint->time > time + kSameTime; });
  return log;
}

Simulation CheckpointLog::simulation_at(double time, const std::stop_token& stop) const {
  Simulation simulation(scenario_, options_);
  const Checkpoint* last = nullptr;
  for (const auto& checkpoint : checkpoints_) {
    if (checkpoint->time > time + kSameTime) break;
    last = checkpoint.get();
    // Each change is repeated from the state in which it was made, because its effect depends on that state.
    if (!last->changes_strategy()) continue;
    restore(simulation, *last);
    Scenario strategy = stored_strategy(last->strategy, scenario_.files);
    if (end_time_ > 0) strategy.output.end_time = end_time_;
    simulation.change_strategy(strategy);
  }
  if (last != nullptr && !last->changes_strategy()) restore(simulation, *last);
  simulation.advance(time, stop);
  return simulation;
}

}  // namespace netpocket
