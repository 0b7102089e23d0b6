#pragma once
// Outcome of a run and the resources it used.

#include <cstdint>
#include <string>

namespace netpocket {

// `limited`: the run has made as many steps as it may.
enum class RunReason { running, finished, stopped, diverged, storage_failed, limited };

struct RunStatus {
  RunReason reason = RunReason::running;
  double time = 0;      // s, simulated time reached
  std::string message;  // one sentence; for a diverged run: which element or body, which step, advice
};

struct RunStatistics {
  double simulated_seconds = 0;
  double wall_seconds = 0;
  double cpu_seconds = 0;
  std::int64_t steps = 0;
  std::int32_t elements = 0;
  std::int32_t coordinates = 0;
  double time_step = 0;    // s, smallest step used
  std::string step_limit;  // what limits the step, e.g. "axial wave in panel 3 row 2"
  std::string evaluation;  // "mean_strain" or "full"
};

const char* to_string(RunReason reason);

}  // namespace netpocket
