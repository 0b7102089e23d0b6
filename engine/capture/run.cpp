#include "engine/capture/run.h"

#include <fmt/format.h>

#include <chrono>

#include "engine/capture/frame_times.h"
#include "engine/capture/simulation.h"
#include "engine/recording/background_recorder.h"
#include "engine/recording/recording.h"
#include "engine/scenario/fidelity.h"
#include "engine/scenario/write_scenario.h"
#include "engine/systems/capture_system.h"

namespace netpocket {
namespace {

constexpr double kRounding = FrameTimes::kRounding;

// Records a simulation frame by frame, from its present time.
class RecordedRun {
 public:
  RecordedRun(Simulation& simulation, BackgroundRecorder& recorder, const RunCallback& after_frame)
      : simulation_(simulation), recorder_(recorder), after_frame_(after_frame), recorded_time_(simulation.time()) {}

  // For a run from its start.
  void record_start() {
    // The checkpoint comes first: the recording gets its name with the first frame and must be resumable from then on.
    record_checkpoint();
    record_state();
  }

  // Returns how the run ended.
  RunStatus record_frames(const std::stop_token& stop) {
    const FrameTimes frames(simulation_.scenario().output);
    next_checkpoint_ = simulation_.time() + kCheckpointInterval;
    for (std::int64_t i = frames.after(simulation_.time()); i <= frames.count(); ++i) {
      RunStatus status = simulation_.advance(frames.at(i), stop);
      const bool has_ended = status.reason == RunReason::diverged || status.reason == RunReason::limited;
      if (has_ended && simulation_.time() > recorded_time_) record_state();
      if (status.reason != RunReason::finished) return status;
      record_state();
      if (frames.is_whole(i) && simulation_.time() > next_checkpoint_ - kRounding) record_checkpoint();
    }
    return finished_run(simulation_);
  }

 private:
  void record_state() {
    recorder_.write(simulation_.snapshot());
    recorded_time_ = simulation_.time();
    const double wall = std::chrono::duration<double>(Clock::now() - start_).count();
    if (after_frame_) after_frame_({simulation_.time(), simulation_.scenario().output.end_time, wall});
  }

  void record_checkpoint() {
    recorder_.write(take_checkpoint(simulation_));
    next_checkpoint_ = simulation_.time() + kCheckpointInterval;
  }

  using Clock = std::chrono::steady_clock;

  Simulation& simulation_;
  BackgroundRecorder& recorder_;
  const RunCallback& after_frame_;
  Clock::time_point start_ = Clock::now();
  double next_checkpoint_ = 0;  // s
  double recorded_time_;        // s, time of the last frame
};

// A storage failure here must not hide how the run ended.
void finish(BackgroundRecorder& recorder, RunResult& result) {
  try {
    recorder.finish(result.status, result.statistics);
  } catch (const FileError& error) {
    if (result.status.reason == RunReason::storage_failed) return;
    result.status.reason = RunReason::storage_failed;
    result.status.message += (result.status.message.empty() ? "" : "; ") + std::string(error.what());
  }
}

RunResult record(Simulation& simulation, BackgroundRecorder& recorder, bool from_start, const RunCallback& after_frame,
                 const std::stop_token& stop) {
  RunResult result;
  try {
    RecordedRun run(simulation, recorder, after_frame);
    if (from_start) run.record_start();
    result.status = run.record_frames(stop);
  } catch (const FileError& error) {
    result.status = {RunReason::storage_failed, simulation.time(), error.what()};
  }
  result.statistics = simulation.statistics();
  result.symmetry = simulation.symmetry();
  finish(recorder, result);
  result.recorded = recorder.is_published();
  return result;
}

// Begins a recording with the frames and checkpoints of another one up to a time (s).
void copy_until(const Recording& source, double time, BackgroundRecorder& recorder) {
  const auto is_before = [time](double t) { return t <= time + kRounding; };
  for (std::size_t i = 0; i < source.frame_count() && is_before(source.times()[i]); ++i)
    recorder.write(source.frame(i));
  const auto& checkpoints = source.checkpoint_times();
  for (std::size_t i = 0; i < checkpoints.size() && is_before(checkpoints[i]); ++i) {
    recorder.write(source.checkpoint(i));
  }
}

}  // namespace

RunOrigin run_origin(const Scenario& scenario, const RunOptions& options) {
  RunOrigin origin;
  origin.scenario_name = scenario.name;
  origin.scenario_text = write_scenario_text(scenario);
  origin.netpocket_version = options.version;
  origin.commit = options.commit;
  origin.command = options.command;
  origin.seed = scenario.solver.seed;
  origin.threads = options.threads;
  origin.phases = capture_phases(scenario);
  origin.draft = draft_notice(scenario.solver.fidelity);
  return origin;
}

RunResult run_to_recording(const Scenario& scenario, const std::string& path, const RunOptions& options,
                           const RunCallback& after_frame, const std::stop_token& stop) {
  Simulation simulation(scenario, {options.threads});
  BackgroundRecorder recorder(path, run_origin(scenario, options), simulation.structure(), options.overwrite);
  return record(simulation, recorder, true, after_frame, stop);
}

std::string why_not_resumable(const Recording& recording, const RunOptions& options) {
  const RunOrigin& origin = recording.origin();
  if (origin.netpocket_version != options.version || origin.commit != options.commit) {
    return fmt::format("netpocket {} ({}) recorded it and this is {} ({}), whose results may differ",
                       origin.netpocket_version, origin.commit, options.version, options.commit);
  }
  if (recording.status().reason == RunReason::diverged) return "the run diverged and would do so again";
  if (recording.status().reason == RunReason::limited) return "the run has made as many steps as it may";
  if (recording.checkpoint_times().empty()) return "it holds no state to resume from";
  return "";
}

RunResult resume_recording(const std::string& source, const std::string& path, const RunOptions& options,
                           double end_time, const RunCallback& after_frame, const std::stop_token& stop) {
  const Recording recorded(source);
  if (const std::string reason = why_not_resumable(recorded, options); !reason.empty()) throw ResumeError(reason);
  const double time = recorded.checkpoint_times().back();
  CheckpointLog log(recorded, time, {options.threads});
  if (end_time > 0) log.set_end_time(end_time);
  Simulation simulation = log.simulation_at(time);
  RunOrigin origin = recorded.origin();
  origin.scenario_text = write_scenario_text(log.scenario());
  origin.command = options.command;
  origin.threads = options.threads;
  BackgroundRecorder recorder(path, origin, simulation.structure(), options.overwrite);
  recorder.hold_back(recorded.frame_count());
  copy_until(recorded, time, recorder);
  // A log with changes of strategy needs one more: its last strategy determines the end time.
  if (end_time > 0 && log.changes_strategy()) recorder.write(take_checkpoint(simulation, &simulation.scenario()));
  return record(simulation, recorder, false, after_frame, stop);
}

}  // namespace netpocket
