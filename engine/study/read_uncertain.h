#pragma once
// Reads the uncertain inputs of a study from TOML (scenarios/studies/README.md). Thread contract: any thread may call
// it.

#include "engine/study/toml_values.h"
#include "engine/study/uncertain_input.h"

namespace netpocket {

// [uncertain] and [[correlated]] of a study's file. Each key is checked on `scenario` with its median.
std::vector<UncertainInput> read_uncertain(const toml::table& file, const Scenario& scenario,
                                           const ReportProblem& report);

}  // namespace netpocket
