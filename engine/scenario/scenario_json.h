#pragma once
// Scenarios as JSON, for programs that read no TOML.

#include <nlohmann/json_fwd.hpp>

#include "engine/scenario/scenario.h"

namespace netpocket {

// The complete scenario: every key with its value, nested as the tables and lists of a scenario's file, in their order.
// SI units but for those of the keys (scenarios/REFERENCE.md). Numbers read back to the same doubles.
nlohmann::ordered_json scenario_json(const Scenario& scenario);

}  // namespace netpocket
