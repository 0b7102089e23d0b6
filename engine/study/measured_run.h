#pragma once
// A run of a study and what is measured of it.

#include <functional>
#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/analysis/metrics/metrics.h"
#include "engine/capture/run.h"
#include "engine/study/study_record.h"

namespace netpocket {

// Runs a scenario, in memory if `file` is empty, else into a recording. `progress` gets the simulated time (s) after
// each frame. The result is the run's part of a record: {"variant", those of summary_json, "used", "metrics"}. It is
// empty when the run was stopped. `used`: keys of which the values are read back from the simulation. Throws FileError
// when the recording cannot be written. Thread contract: any thread may call it.
StudyRecord measured_run(const Scenario& scenario, const std::string& variant, const std::vector<std::string>& used,
                         const std::string& file, const RunOptions& options,
                         const std::function<void(double)>& progress, const std::stop_token& stop);

}  // namespace netpocket
