#pragma once
// Checks a scenario as a whole.

#include "engine/base/diagnostics.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

// Larger meshes are refused.
inline constexpr double kLargestElementCount = 2e6;
// Runs that would record more frames are refused.
inline constexpr double kLargestFrameCount = 1e6;

// Problems of a scenario. First checks each parameter against its limits. If these hold, checks the parameters against
// each other: inertia, the target's shape, the size of the recording, and what the kind of capture system checks; for a
// pocket rods, closing, size of the mesh, and whether target and spacecraft start clear of the pocket and of each
// other. A scenario that passes can be simulated. With a final end it also reports what never comes before that
// (check_times.h). Thread contract: any thread may call it.
enum class RunEnd { final, open };  // open: the run may go on, as a recorded one that is resumed
Diagnostics check_scenario(const Scenario& scenario, RunEnd end = RunEnd::final);

}  // namespace netpocket
