#pragma once
// Runs a scenario from its start into a recording: what the command line and the workbench share.

#include <functional>
#include <stop_token>
#include <string>

#include "engine/recording/recorder.h"
#include "engine/recording/run_status.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

struct RunOptions {
  int threads = 1;
  bool overwrite = false;    // of an existing recording
  std::string version = {};  // of the program, for the recording
  std::string commit = {};
  std::string command = {};  // command line or "workbench"
};

// What the recording of a run says about where it comes from.
RunOrigin run_origin(const Scenario& scenario, const RunOptions& options);

struct RunProgress {
  double time = 0;          // s, simulated
  double end_time = 0;      // s, at which the run will end
  double wall_seconds = 0;  // since the run began
};

struct RunResult {
  RunStatus status;
  RunStatistics statistics;
};

// Called after each recorded frame, on the thread that runs.
using RunCallback = std::function<void(const RunProgress&)>;

// Simulates until output.end_time, until stopped, diverged or until the recording cannot be written any more, and
// records the state at t = 0, every 1/output.frame_rate after it and at the end. However it ends, what was recorded is
// kept and holds the reason. The scenario must pass check_scenario. Throws RecordingError when no recording can be
// begun: then `path` is as it was.
RunResult run_to_recording(const Scenario& scenario, const std::string& path, const RunOptions& options,
                           const RunCallback& after_frame = {}, const std::stop_token& stop = {});

}  // namespace netpocket
