#pragma once
// Runs a capture for someone who looks at its frames and keeps none.

#include <functional>
#include <stop_token>

#include "engine/capture/run.h"
#include "engine/capture/simulation.h"

namespace netpocket {

using FrameObserver = std::function<void(const Snapshot&)>;

// Simulates from the present time of `simulation`, which must be its start, until the end time of its scenario, or
// until the run is stopped or diverges. Shows the frames that a recording of the run would hold (run_to_recording), one
// after the other, on the caller's thread.
RunResult observe_run(Simulation& simulation, const FrameObserver& observer, const std::stop_token& stop = {});

}  // namespace netpocket
