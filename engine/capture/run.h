#pragma once
// Runs a scenario into a recording, from its start or from where an earlier run of it was cut off.

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
  bool recorded =
      true;  // false: a resumed run ended before it came further than what was recorded, which stays as it was
};

// Called after each recorded frame, on the thread that runs.
using RunCallback = std::function<void(const RunProgress&)>;

// Simulates until output.end_time, until stopped, diverged or until the recording cannot be written any more, and
// records the state at t = 0, every 1/output.frame_rate after it and at the end. However it ends, what was recorded is
// kept and holds the reason. The scenario must pass check_scenario. Throws FileError when no recording can be begun:
// then `path` is as it was.
RunResult run_to_recording(const Scenario& scenario, const std::string& path, const RunOptions& options,
                           const RunCallback& after_frame = {}, const std::stop_token& stop = {});

// Why this program cannot continue a recorded run: another version wrote it, or it diverged. Empty when it can.
std::string why_not_resumable(const Recording& recording, const RunOptions& options);

// Continues a recorded run from its last checkpoint, to `end_time` (s) or, with 0, to that of its scenario. The result
// is the recording of the whole run, equal to that of an uninterrupted one but for the times that the computation took.
// `path` may be that of the recording itself: the old file is replaced when the new one holds as many frames, and stays
// when the run ends before. Otherwise as run_to_recording; also throws ResumeError.
RunResult resume_recording(const std::string& source, const std::string& path, const RunOptions& options,
                           double end_time = 0, const RunCallback& after_frame = {}, const std::stop_token& stop = {});

}  // namespace netpocket
