#pragma once
// What the user interface says to the simulation's thread and what comes back. All are values.

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "engine/base/diagnostics.h"
#include "engine/capture/checkpoint_log.h"
#include "engine/scenario/scenario.h"
#include "engine/state/run_status.h"
#include "engine/state/snapshot.h"
#include "engine/state/structure.h"

namespace netpocket {

// Numbers a run of the session; reports name the run they belong to.
using RunId = std::int32_t;

// To the worker.

// A new run from t = 0, paused after its first frame. The scenario must pass check_scenario.
struct BeginRun {
  RunId run;
  Scenario scenario;
};
// A new run that continues an earlier one from `time` (s, of one of its frames); paused there.
struct BeginBranch {
  RunId run;
  RunId parent;
  double time;
  Scenario scenario;  // whose strategy acts from there on
  // Of a parent that was opened from a file; the worker has those of its own runs.
  std::optional<CheckpointLog> log = {};
};
// Runs on, at most to `until` (s) or to the first contact after now.
struct Resume {
  double until = std::numeric_limits<double>::infinity();
  bool until_contact = false;
};
struct Pause {};
// One integration step, then paused.
struct SingleStep {};
// Simulated seconds for one second of wall time; 0: as fast as possible.
struct SetPace {
  double rate = 0;
};
// Threads inside a simulation, of those begun from now on.
struct SetThreads {
  int threads = 1;
};
// The strategy is that of this scenario from now on. The disturbances of the run remain.
struct ChangeStrategy {
  Scenario scenario;
};
// Disturbs the run from its present time on, whatever the start that is given.
struct Disturb {
  DisturbanceParameters disturbance;
};
using WorkerCommand =
    std::variant<BeginRun, BeginBranch, Resume, Pause, SingleStep, SetPace, SetThreads, ChangeStrategy, Disturb>;

// From the worker.

struct RunBegun {
  RunId run;
  std::shared_ptr<const Structure> structure;
  Scenario scenario;
};
struct FrameReady {
  RunId run;
  std::shared_ptr<const Snapshot> snapshot;
  RunStatistics statistics;
  double speed = 0;  // simulated seconds for one of wall time, lately
};
enum class WorkerState { idle, preparing, running, paused, ended };
struct StateChanged {
  RunId run;
  WorkerState state;
  RunStatus status;
  RunStatistics statistics;
};
struct StrategyChanged {
  RunId run;
  double time;              // s, from which it acts
  Scenario scenario;        // in force now
  Diagnostics diagnostics;  // why it was refused: then nothing has changed
  bool disturbed = false;   // by Disturb
};
// From where the run can be continued later: for its recording.
struct CheckpointTaken {
  RunId run;
  std::shared_ptr<const Checkpoint> checkpoint;
};
// Something unexpected ended the run.
struct WorkerFailed {
  RunId run;
  std::string message;  // one sentence
};
using WorkerReport = std::variant<RunBegun, FrameReady, StateChanged, StrategyChanged, CheckpointTaken, WorkerFailed>;

}  // namespace netpocket
