#pragma once
// Checks what a scenario says about closed-loop control, events and winches.

#include "engine/base/diagnostics.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

// Adds the problems. Every parameter must be within its limits.
void check_control(const Scenario& scenario, Diagnostics& problems);

// Whether something in the scenario reads a sensor of this kind.
bool is_read(SensorKind kind, const Scenario& scenario);
bool is_of_attitude(ControllerKind kind);
bool is_of_position(ControllerKind kind);

}  // namespace netpocket
