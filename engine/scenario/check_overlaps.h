#pragma once
// Checks that the bodies of a scenario start clear of the pocket and of each other.

#include "engine/base/diagnostics.h"
#include "engine/bodies/shape.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

// Adds a diagnostic for each pair of target, spacecraft and pocket that overlaps, with the place and the depth.
// Surfaces are sampled at about 1/40 of the edges of a panel and of the spacecraft. The rods' profile must be valid.
void check_overlaps(const Scenario& scenario, const Shape& target_shape, Diagnostics& diagnostics);

}  // namespace netpocket
