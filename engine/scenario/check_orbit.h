#pragma once
// Checks the orbit of a scenario, and makes it.

#include <optional>

#include "engine/base/diagnostics.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

// Adds what is wrong with the orbit of a scenario beyond the limits of its parameters.
void check_orbit(const Scenario& scenario, Diagnostics& problems);

// The orbit of the world's origin; nothing if the scenario has none. The scenario must pass check_orbit.
std::optional<Orbit> orbit_of(const Scenario& scenario);

}  // namespace netpocket
