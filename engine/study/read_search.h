#pragma once
// Reads [optimise] and [rare] of a study from TOML (scenarios/studies/README.md). All else must have been read. Thread
// contract: any thread may call it.

#include "engine/study/study.h"
#include "engine/study/toml_values.h"

namespace netpocket {

// `scenario`: base with the settings of all points, on which the keys are checked.
void read_search(const toml::table& file, const Scenario& scenario, Study& study, const ReportProblem& report);

}  // namespace netpocket
