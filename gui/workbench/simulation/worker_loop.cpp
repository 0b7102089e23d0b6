#include "gui/workbench/simulation/worker_loop.h"

#include <algorithm>
#include <cmath>

#include "engine/scenario/parameters.h"

namespace netpocket {
namespace {

// s: steps end at frames but for rounding.
constexpr double kRounding = 5e-7;

// Whether a run cannot go on from where it stands.
bool has_ended(const RunStatus& status) {
  return status.reason == RunReason::diverged || status.reason == RunReason::limited;
}

}  // namespace

void WorkerLoop::run() {
  while (!stop_.stop_requested()) {
    // A paused worker waits for commands; a running one only looks whether there are any, or until a frame is due.
    std::optional<RunPace::Clock::time_point> deadline;
    if (running_) deadline = pace_.due().value_or(RunPace::Clock::now());
    obey_all(worker_.take_commands(stop_, deadline));
    if (running_ && !stop_.stop_requested()) guard([this] { advance(); });
  }
}

void WorkerLoop::guard(const std::function<void()>& action) {
  const auto fail = [this](const std::string& message) {
    running_ = false;
    simulation_.reset();
    worker_.report(WorkerFailed{run_, message});
  };
  try {
    action();
  } catch (const std::bad_alloc&) {
    fail("out of memory");
  } catch (const std::exception& error) {
    fail(error.what());
  }
}

// A run that the next one follows at once is not made: only what its branches need is kept.
void WorkerLoop::obey_all(const std::deque<WorkerCommand>& commands) {
  const auto begins = [](const WorkerCommand& c) {
    return std::holds_alternative<BeginRun>(c) || std::holds_alternative<BeginBranch>(c);
  };
  const auto last = std::find_if(commands.rbegin(), commands.rend(), begins).base();
  for (auto command = commands.begin(); command != commands.end(); ++command) {
    const bool superseded = command + 1 < last;
    const bool setting = std::holds_alternative<SetPace>(*command) || std::holds_alternative<SetThreads>(*command);
    if (!superseded || setting) {
      guard([&] { obey(*command); });
    } else if (const auto* begin = std::get_if<BeginRun>(&*command)) {
      note_start(*begin);
    } else if (const auto* branch = std::get_if<BeginBranch>(&*command)) {
      guard([&] { note_start(*branch); });
    }
  }
}

void WorkerLoop::note_start(const BeginRun& command) {
  logs_[command.run] = CheckpointLog(command.scenario, SimulationOptions{worker_.threads_});
}

const CheckpointLog& WorkerLoop::note_start(const BeginBranch& command) {
  if (command.log) logs_[command.parent] = *command.log;
  const auto parent = logs_.find(command.parent);
  if (parent == logs_.end()) throw std::runtime_error("a run that was opened from a file cannot be continued");
  return logs_[command.run] = parent->second.until(command.time);
}

void WorkerLoop::obey(const WorkerCommand& command) {
  std::visit([this](const auto& c) { on(c); }, command);
}

void WorkerLoop::on(const BeginRun& command) {
  run_ = command.run;
  running_ = false;
  report_state(WorkerState::preparing, {});
  note_start(command);
  install(command.run, Simulation(logs_[command.run].scenario(), SimulationOptions{worker_.threads_}));
}

void WorkerLoop::on(const BeginBranch& command) {
  run_ = command.run;
  running_ = false;
  report_state(WorkerState::preparing, {});
  install(command.run, note_start(command).simulation_at(command.time, stop_));
  on(ChangeStrategy{command.scenario});
}

void WorkerLoop::install(RunId run, Simulation simulation) {
  simulation_.emplace(std::move(simulation));
  worker_.report(RunBegun{run, std::make_shared<const Structure>(simulation_->structure()), simulation_->scenario()});
  frame_time_ = -1;
  next_checkpoint_ = 0;
  report_frame();
  report_state(WorkerState::paused, {});
}

void WorkerLoop::on(const Resume& command) {
  if (!simulation_) return;
  goal_ = command;
  running_ = true;
  pace_.restart(simulation_->time(), RunPace::Clock::now());
  report_state(WorkerState::running, {});
}

void WorkerLoop::on(const Pause&) {
  if (!simulation_ || !running_) return;
  running_ = false;
  report_frame();
  report_state(WorkerState::paused, {});
}

void WorkerLoop::on(const SingleStep&) {
  if (!simulation_) return;
  running_ = false;
  const double before = simulation_->time();
  RunStatus status;
  // A simulation steps while more than half a step is missing; how long its next step is, it decides itself. One that
  // diverges is put back to where it was, and would be for ever.
  const auto goes_on = [&] { return status.reason == RunReason::running || status.reason == RunReason::finished; };
  double ahead = 0.6 * simulation_->statistics().time_step;
  for (; simulation_->time() == before && goes_on(); ahead *= 1.5) {
    status = simulation_->advance(before + ahead, stop_);
  }
  report_frame();
  report_state(has_ended(status) ? WorkerState::ended : WorkerState::paused, status);
}

void WorkerLoop::on(const SetPace& command) { pace_.set_rate(command.rate); }

void WorkerLoop::on(const SetThreads& command) { worker_.threads_ = command.threads; }

void WorkerLoop::on(const ChangeStrategy& command) {
  if (!simulation_) return;
  Scenario scenario = command.scenario;
  scenario.disturbances = simulation_->scenario().disturbances;
  const Diagnostics refused = change_to(scenario);
  worker_.report(StrategyChanged{run_, simulation_->time(), simulation_->scenario(), refused});
}

void WorkerLoop::on(const Disturb& command) {
  if (!simulation_) return;
  Diagnostics refused;
  Scenario scenario = simulation_->scenario();
  if (scenario.disturbances.size() < kMostItems) {
    scenario.disturbances.push_back(command.disturbance);
    scenario.disturbances.back().start = simulation_->time();
    refused = change_to(scenario);
  } else {
    Diagnostic reason;
    reason.message = "it can be disturbed " + std::to_string(kMostItems) + " times";
    refused.add(reason);
  }
  worker_.report(StrategyChanged{run_, simulation_->time(), simulation_->scenario(), refused, true});
}

// What is not applied.
Diagnostics WorkerLoop::change_to(const Scenario& scenario) {
  report_checkpoint(&scenario);
  Diagnostics refused;
  for (const std::string& key : simulation_->change_strategy(scenario)) {
    refused.add({.key = key, .message = "acts from a restart only"});
  }
  return refused;
}

double WorkerLoop::next_frame_time() const {
  constexpr double kPart = 1e-6;  // of an interval
  const OutputParameters& output = simulation_->scenario().output;
  const double interval = std::floor(simulation_->time() * output.frame_rate + kPart) + 1;
  return std::min(interval / output.frame_rate, output.end_time);
}

void WorkerLoop::advance() {
  const double end = std::min(goal_.until, simulation_->scenario().output.end_time);
  if (simulation_->time() < end - kRounding) {
    const RunStatus status = simulation_->advance(std::min(next_frame_time(), end), worker_.interruption());
    if (status.reason == RunReason::stopped) return;
    report_frame();
    if (has_ended(status)) {
      running_ = false;
      report_state(WorkerState::ended, status);
      return;
    }
  }
  if (!running_ || simulation_->time() < end - kRounding) return;
  running_ = false;
  const bool finished = simulation_->time() >= simulation_->scenario().output.end_time - kRounding;
  if (finished) {
    report_state(WorkerState::ended, finished_run(*simulation_));
  } else {
    report_state(WorkerState::paused, {RunReason::finished, simulation_->time(), "reached the time asked for"});
  }
}

void WorkerLoop::report_frame() {
  if (simulation_->time() <= frame_time_) return;
  auto snapshot = std::make_shared<const Snapshot>(simulation_->snapshot());
  // What a diverged run has come to cannot be drawn.
  if (!snapshot->positions.allFinite()) return;
  frame_time_ = simulation_->time();
  logs_[run_].note_state(*simulation_);
  if (frame_time_ > next_checkpoint_ - kRounding) report_checkpoint();
  pace_.note(frame_time_, RunPace::Clock::now());
  after_frame(*snapshot);
  worker_.report(FrameReady{run_, std::move(snapshot), simulation_->statistics(), pace_.speed()});
}

// With a strategy: the one that takes over now.
void WorkerLoop::report_checkpoint(const Scenario* strategy) {
  auto checkpoint = std::make_shared<const Checkpoint>(take_checkpoint(*simulation_, strategy));
  if (strategy != nullptr) logs_[run_].note_change(checkpoint);
  next_checkpoint_ = simulation_->time() + kCheckpointInterval;
  worker_.report(CheckpointTaken{run_, std::move(checkpoint)});
}

void WorkerLoop::after_frame(const Snapshot& snapshot) {
  const bool touches = snapshot.channel(Channel::contact_count) > 0;
  if (running_ && goal_.until_contact && touches && !touched_) goal_.until = snapshot.time;
  touched_ = touches;
}

void WorkerLoop::report_state(WorkerState state, const RunStatus& status) {
  worker_.report(StateChanged{run_, state, status, simulation_ ? simulation_->statistics() : RunStatistics{}});
}

}  // namespace netpocket
