#include "engine/capture/observe_run.h"

#include "engine/capture/frame_times.h"

namespace netpocket {
namespace {

RunStatus show_frames(Simulation& simulation, const FrameObserver& observer, const std::stop_token& stop) {
  const FrameTimes frames(simulation.scenario().output);
  double shown = simulation.time();
  observer(simulation.snapshot());
  for (std::int64_t i = frames.after(simulation.time()); i <= frames.count(); ++i) {
    RunStatus status = simulation.advance(frames.at(i), stop);
    const bool has_ended = status.reason == RunReason::diverged || status.reason == RunReason::limited;
    if (status.reason == RunReason::finished || (has_ended && simulation.time() > shown)) {
      observer(simulation.snapshot());
      shown = simulation.time();
    }
    if (status.reason != RunReason::finished) return status;
  }
  return finished_run(simulation);
}

}  // namespace

RunResult observe_run(Simulation& simulation, const FrameObserver& observer, const std::stop_token& stop) {
  RunResult result;
  result.status = show_frames(simulation, observer, stop);
  result.statistics = simulation.statistics();
  result.recorded = false;
  return result;
}

}  // namespace netpocket
