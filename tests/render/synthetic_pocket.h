#pragma once
// A pocket made up for the tests of drawing: eight rods, triangular and square panels, closing ropes, spacecraft and
// target at their places in case 1. No dynamics.

#include "engine/state/snapshot.h"
#include "engine/state/structure.h"

namespace netpocket::synthetic {

Structure make_structure(const Shape& target = Sphere{4.5});

// `closed` from 0 (open) to 1 (tips 2.1 m apart); `time` only labels it.
Snapshot make_snapshot(const Structure& structure, double time, double closed);

}  // namespace netpocket::synthetic
