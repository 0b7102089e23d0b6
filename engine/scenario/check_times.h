#pragma once
// Checks what a scenario waits for against the end of its run.

#include "engine/base/diagnostics.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

// When the mouth is closed (s): at the earliest, if an event starts the closing.
double closing_end(const ClosingParameters& closing);

// Adds what never comes because the run ends first: a closing that waits for an event, a towing that waits for the
// closed mouth, phases of controllers, thrust and torque of the target. Every parameter must be within its limits.
// Whether an event comes in time otherwise is known only when the scenario has been run.
void check_times(const Scenario& scenario, Diagnostics& problems);

}  // namespace netpocket
