#pragma once
// Runs a scenario into a recording, from its start or from where an earlier run was interrupted.

#include <functional>
#include <stop_token>
#include <string>

#include "engine/capture/checkpoint_log.h"
#include "engine/recording/recorder.h"
#include "engine/scenario/scenario.h"
#include "engine/state/run_status.h"

namespace netpocket {

struct RunOptions {
  int threads = 1;
  bool overwrite = false;    // whether an existing recording is replaced
  std::string version = {};  // program version, stored in the recording
  std::string commit = {};
  std::string command = {};  // command line or "workbench"
};

// Origin of a run as its recording stores it.
RunOrigin run_origin(const Scenario& scenario, const RunOptions& options);

struct RunProgress {
  double time = 0;          // s, simulated
  double end_time = 0;      // s, end time of the run
  double wall_seconds = 0;  // s, since the run began
};

struct RunResult {
  RunStatus status;
  RunStatistics statistics;
  SymmetryStatus symmetry;
  bool recorded = true;  // false: a resumed run did not get beyond the old recording, which is unchanged
};

// Called after each recorded frame, on the thread of the run.
using RunCallback = std::function<void(const RunProgress&)>;

// Simulates until output.end_time (s), or until the run is stopped, diverges or can no longer write the recording.
// Records the state at t = 0, every 1/output.frame_rate after it and at the end. The recording is kept however the run
// ends, and states the reason. The scenario must pass check_scenario. Throws FileError when the recording cannot be
// created; `path` is then unchanged.
RunResult run_to_recording(const Scenario& scenario, const std::string& path, const RunOptions& options,
                           const RunCallback& after_frame = {}, const std::stop_token& stop = {});

// Why this program cannot continue a recorded run: another version wrote it, it diverged, or it has no checkpoint.
// Empty when it can.
std::string why_not_resumable(const Recording& recording, const RunOptions& options);

// Continues a recorded run from its last checkpoint, to `end_time` (s) or, with 0, to the end time of its scenario.
// Writes a recording of the whole run to `path`. It equals that of an uninterrupted run except for computing times.
// `path` may be `source` itself: the old file is replaced when the new one holds as many frames, and kept when the run
// ends earlier. Otherwise like run_to_recording; also throws ResumeError.
RunResult resume_recording(const std::string& source, const std::string& path, const RunOptions& options,
                           double end_time = 0, const RunCallback& after_frame = {}, const std::stop_token& stop = {});

}  // namespace netpocket
