#pragma once
// Runs of which only the channels are kept, in memory.

#include <memory>
#include <vector>

#include "engine/scenario/scenario.h"
#include "engine/state/channels.h"
#include "engine/state/run_status.h"

namespace netpocket::python {

struct MemoryRun {
  RunStatus status;
  RunStatistics statistics;
  std::shared_ptr<const ChannelList> channels;
  std::vector<std::vector<double>> values;  // by channel and frame
};

// Runs all scenarios to their end times, `jobs` at the same time, without the interpreter lock. Their results do not
// depend on `jobs`. Throws ScenarioFault if one cannot be simulated, before any runs, and error_already_set after
// Ctrl-C.
std::vector<MemoryRun> run_in_memory(const std::vector<Scenario>& scenarios, int jobs);

}  // namespace netpocket::python
