#pragma once
// The scenario that a recording was made with.

#include "engine/scenario/read_scenario.h"

namespace netpocket {

class Recording;

// Contains the target's mesh as recorded, so that the run can continue without the mesh file.
ScenarioResult recorded_scenario(const Recording& recording);

}  // namespace netpocket
