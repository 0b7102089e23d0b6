#pragma once
// Checks what is particular to a scenario of the netted pocket.

#include "engine/base/diagnostics.h"
#include "engine/bodies/shape.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

// Adds the problems of rods, meshes, closing and overlaps. Every parameter must be within its limits. `target`: its
// shape; null if it is not valid, which must then be among the problems.
void check_pocket(const Scenario& scenario, const Shape* target, Diagnostics& problems);

}  // namespace netpocket
