#pragma once
// Writes scenarios as TOML.

#include <string>

#include "engine/scenario/scenario.h"

namespace netpocket {

// The complete scenario: every key, with unit, help and source as a comment. Reading it back gives bitwise the same
// values.
std::string write_scenario_text(const Scenario& scenario);

}  // namespace netpocket
