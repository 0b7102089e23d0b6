#pragma once
// Whether a scenario makes sense as a whole.

#include "engine/base/diagnostics.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

// Meshes with more elements are refused.
inline constexpr double kLargestElementCount = 2e6;
// Runs that would record more frames are refused.
inline constexpr double kLargestFrameCount = 1e6;

// What is wrong: first each parameter against its limits and, if these hold, the parameters against each other: rods,
// closing, inertia, sizes of mesh and recording, and whether target and spacecraft start clear of the pocket and of
// each other. A scenario that passes can be simulated. Any thread may call it.
Diagnostics check_scenario(const Scenario& scenario);

}  // namespace netpocket
