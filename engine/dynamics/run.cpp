#include "engine/dynamics/run.h"

#include <chrono>
#include <cmath>

#include "engine/dynamics/simulation.h"
#include "engine/recording/background_recorder.h"
#include "engine/scenario/closing_law.h"
#include "engine/scenario/pocket_outline.h"
#include "engine/scenario/write_scenario.h"

namespace netpocket {
namespace {

// The times of the frames after the first: whole output intervals, and the end.
class FrameTimes {
 public:
  explicit FrameTimes(const OutputParameters& output)
      : output_(output),
        count_(static_cast<std::int64_t>(std::ceil(output.end_time * output.frame_rate - kRounding))) {}

  std::int64_t count() const { return count_; }
  double at(std::int64_t index) const {
    return index < count_ ? static_cast<double>(index) / output_.frame_rate : output_.end_time;
  }

 private:
  // Part of an interval: end_time * frame_rate may be off a whole number by this much.
  static constexpr double kRounding = 1e-6;

  OutputParameters output_;
  std::int64_t count_;
};

// Records frame by frame and returns how it ended.
RunStatus record_frames(Simulation& simulation, BackgroundRecorder& recorder, const RunCallback& after_frame,
                        const std::stop_token& stop) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const FrameTimes frames(simulation.scenario().output);
  for (std::int64_t i = 1; i <= frames.count(); ++i) {
    const RunStatus status = simulation.advance(frames.at(i), stop);
    if (status.reason != RunReason::finished) return status;
    recorder.write(simulation.snapshot());
    const double wall = std::chrono::duration<double>(Clock::now() - start).count();
    if (after_frame) after_frame({simulation.time(), simulation.scenario().output.end_time, wall});
  }
  return {RunReason::finished, simulation.time(), "reached the end time"};
}

// A storage failure must not hide how the run ended.
void finish(BackgroundRecorder& recorder, RunResult& result) {
  try {
    recorder.finish(result.status, result.statistics);
  } catch (const RecordingError& error) {
    if (result.status.reason == RunReason::storage_failed) return;
    result.status.reason = RunReason::storage_failed;
    result.status.message += (result.status.message.empty() ? "" : "; ") + std::string(error.what());
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
  origin.closing_end = ClosingSchedule(scenario.closing, open_tip_distance(scenario)).end();
  if (scenario.towing.mode != TowingMode::none) origin.towing_start = scenario.towing.start;
  return origin;
}

RunResult run_to_recording(const Scenario& scenario, const std::string& path, const RunOptions& options,
                           const RunCallback& after_frame, const std::stop_token& stop) {
  Simulation simulation(scenario, {options.threads});
  BackgroundRecorder recorder(path, run_origin(scenario, options), simulation.structure(), options.overwrite);
  recorder.write(simulation.snapshot());
  RunResult result;
  try {
    result.status = record_frames(simulation, recorder, after_frame, stop);
  } catch (const RecordingError& error) {
    result.status = {RunReason::storage_failed, simulation.time(), error.what()};
  }
  result.statistics = simulation.statistics();
  finish(recorder, result);
  return result;
}

}  // namespace netpocket
