#pragma once
// The model that a scenario leads to, in numbers.

#include <string>

#include "engine/scenario/scenario.h"

namespace netpocket {

// Nodes, elements, masses, rope lengths, integration step and what limits it, one line each. The scenario must pass
// check_scenario.
std::string model_report(const Scenario& scenario);

}  // namespace netpocket
