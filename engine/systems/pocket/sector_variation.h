#pragma once
// Gives single rods and panels materials of their own, as [scatter] of the scenario says.

#include "engine/scenario/scenario.h"
#include "engine/systems/pocket/pocket.h"

namespace netpocket {

// The elements of each sector follow each other as in pocket.h. Without [scatter] nothing changes.
void vary_sectors(const Scenario& scenario, Pocket& pocket);

}  // namespace netpocket
