#pragma once
// The scenario that a recording was made with.

#include "engine/scenario/read_scenario.h"

namespace netpocket {

class Recording;

// With the target's mesh as it was recorded, so that the run can go on without the mesh's file.
ScenarioResult recorded_scenario(const Recording& recording);

}  // namespace netpocket
