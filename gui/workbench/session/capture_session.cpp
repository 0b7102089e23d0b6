#include "gui/workbench/session/capture_session.h"

#include <QDir>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "gui/workbench/panels/engine_words.h"

namespace netpocket {

CaptureSession::CaptureSession(const SessionOptions& options)
    : runs_(options.origin, options.cache_bytes, options.folder.isEmpty() ? QDir::tempPath() : options.folder) {
  connect(&runs_, &RunLibrary::frame_loaded, this, &CaptureSession::frame_loaded);
  connect(&runs_, &RunLibrary::failed, this, &CaptureSession::failed);
  const auto notify = [this] {
    if (!notified_.exchange(true)) QMetaObject::invokeMethod(this, &CaptureSession::take_reports, Qt::QueuedConnection);
  };
  worker_ = std::make_unique<SimulationWorker>(notify, options.origin.threads);
}

CaptureSession::~CaptureSession() { worker_.reset(); }

void CaptureSession::take_reports() {
  notified_ = false;
  // A few at a time, so that the window stays quick; the rest waits in the queue and holds the simulation back.
  constexpr int kAtOnce = 8;
  constexpr int kRetryInterval = 10;  // ms
  for (int i = 0; i < kAtOnce; ++i) {
    if (runs_.is_busy()) break;
    const auto report = worker_->take_report();
    if (!report) return;
    finish_left_runs(std::visit([](const auto& r) { return r.run; }, *report));
    std::visit([this](const auto& r) { take(r); }, *report);
  }
  if (!notified_.exchange(true))
    QTimer::singleShot(runs_.is_busy() ? kRetryInterval : 0, this, [this] { take_reports(); });
}

void CaptureSession::take(const RunBegun& report) { runs_.begin(report.run, report.structure, report.scenario); }

void CaptureSession::take(const FrameReady& report) {
  runs_.append(report.run, report.snapshot, report.statistics, report.speed);
  const Run* run = current();
  if (run == nullptr || report.run != current_ || run->frame_count() == 0) return;
  if (follow_ || run->frame_count() == 1) show_frame(run->frame_count() - 1);
}

void CaptureSession::take(const StateChanged& report) {
  constexpr RunState kStates[] = {RunState::paused, RunState::preparing, RunState::running, RunState::paused,
                                  RunState::ended};
  runs_.set_state(report.run, kStates[static_cast<int>(report.state)], report.status, report.statistics);
  if (report.status.reason == RunReason::diverged)
    emit run_diverged(tr("The run has diverged and stands still: %1.").arg(engine_words(report.status.message)));
}

void CaptureSession::take(const StrategyChanged& report) {
  runs_.set_scenario(report.run, report.scenario);
  if (report.disturbed && !report.diagnostics.ok()) {
    emit failed(tr("The run was not disturbed: %1.").arg(diagnostics_words(report.diagnostics)));
  }
  if (report.disturbed) return;
  emit strategy_answered(report.run, report.diagnostics, report.time);
}

void CaptureSession::take(const CheckpointTaken& report) { runs_.append(report.run, report.checkpoint); }

void CaptureSession::take(const WorkerFailed& report) {
  if (report.run == live_) {
    leave_live_run();
    finish_left_runs(kNoRun);
  }
  emit failed(tr("The simulation ended: %1.").arg(engine_words(report.message)));
}

// Its last frames may still be under way.
void CaptureSession::leave_live_run() {
  if (live_ != kNoRun) left_.push_back(live_);
  live_ = kNoRun;
}

// Reports come in the order of the commands: once there is one of a later run, the earlier ones are complete.
void CaptureSession::finish_left_runs(RunId reporting) {
  const auto end = std::ranges::find(left_, reporting);
  std::vector<RunId> complete(left_.begin(), end);
  left_.erase(left_.begin(), end);
  for (const RunId id : complete) {
    runs_.finish(id);
    // Another run was wanted before this one came to its first frame.
    if (const Run* run = runs_.find(id); run != nullptr && run->frame_count() == 0) remove_run(id);
  }
}

void CaptureSession::post(WorkerCommand command) {
  if (held_) {
    held_->push_back(std::move(command));
  } else {
    worker_->post(std::move(command));
  }
}

void CaptureSession::release_held() {
  auto held = std::exchange(held_, std::nullopt);
  for (WorkerCommand& command : *held) worker_->post(std::move(command));
}

void CaptureSession::start(const Scenario& scenario, bool run) {
  leave_live_run();
  live_ = runs_.add(runs_.unused_name(QString::fromStdString(scenario.name)), scenario);
  post(BeginRun{live_, scenario});
  follow_ = true;
  show_run(live_);
  if (run) resume();
}

void CaptureSession::resume(const Resume& goal) {
  if (live_ == kNoRun) return;
  post(goal);
}

void CaptureSession::pause() { post(Pause{}); }

void CaptureSession::single_step() {
  follow_ = true;
  if (current_ != live_) show_run(live_);
  post(SingleStep{});
}

void CaptureSession::set_pace(double rate) { post(SetPace{rate}); }

void CaptureSession::set_threads(int threads) {
  runs_.set_threads(threads);
  post(SetThreads{threads});
}

void CaptureSession::change_strategy(const Scenario& scenario) {
  if (live_ != kNoRun) post(ChangeStrategy{scenario});
}

void CaptureSession::disturb(const DisturbanceParameters& disturbance) {
  if (live_ != kNoRun) post(Disturb{disturbance});
}

bool CaptureSession::branch(const Scenario& scenario) {
  const Run* parent = current();
  if (parent == nullptr || parent->frame_count() == 0 || !parent->continuable) return false;
  const double time = parent->series.times()[shown_];
  const RunId parent_id = current_;
  leave_live_run();
  live_ = runs_.add_branch(parent_id, time);
  if (parent->simulated_here) {
    post(BeginBranch{live_, parent_id, time, scenario});
  } else {
    begin_from_file(parent_id, time, scenario);
  }
  follow_ = true;
  show_run(live_);
  return true;
}

// What is asked for in the meantime is meant for the branch and waits until the worker has it.
void CaptureSession::begin_from_file(RunId parent, double time, const Scenario& scenario) {
  if (!held_) held_.emplace();
  ++reading_;
  const std::size_t place = held_->size();
  held_->emplace_back(Pause{});
  runs_.read_checkpoints(parent, time, [=, this, branch = live_](std::optional<CheckpointLog> log) {
    if (log) {
      (*held_)[place] = BeginBranch{branch, parent, time, scenario, std::move(log)};
    } else if (branch == live_) {
      leave_live_run();
    }
    if (--reading_ == 0) release_held();
  });
}

void CaptureSession::remove_run(RunId id) {
  if (id == live_) {
    post(Pause{});
    leave_live_run();
  }
  runs_.remove(id);
  if (id != current_) return;
  const auto ids = runs_.ids();
  show_run(ids.empty() ? kNoRun : ids.back());
}

void CaptureSession::show_run(RunId id) {
  const double time = current() && shown_ < current()->frame_count() ? current()->series.times()[shown_] : 0;
  current_ = id;
  shown_ = 0;
  emit current_changed();
  const Run* run = current();
  if (run == nullptr || run->frame_count() == 0) return;
  show_frame(id == live_ && follow_ ? run->frame_count() - 1 : run->frame_at(time));
}

void CaptureSession::show_frame(std::size_t index) {
  const Run* run = current();
  if (run == nullptr || run->frame_count() == 0) return;
  shown_ = std::min(index, run->frame_count() - 1);
  emit frame_wanted();
  if (const auto frame = runs_.frame(current_, shown_)) emit frame_shown(frame);
}

void CaptureSession::show_time(double time) {
  if (const Run* run = current()) show_frame(run->frame_at(time));
}

void CaptureSession::set_follow(bool follow) {
  follow_ = follow;
  if (const Run* run = current(); follow && run != nullptr && run->frame_count() > 0)
    show_frame(run->frame_count() - 1);
}

void CaptureSession::frame_loaded(RunId run, std::size_t index) {
  if (run != current_ || index != shown_) return;
  if (const auto frame = runs_.frame(run, index)) emit frame_shown(frame);
}

}  // namespace netpocket
