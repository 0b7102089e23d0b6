#pragma once
// Builds the model of a netted pocket from a scenario: rods, knotted net, closing ropes, spacecraft and target.
//
// The pocket is one sector repeated around the Y axis. Sector s holds rod s, the panel between rods s and s+1, and the
// closing rope between their tips. Everything is numbered sector fastest (index = local * rods + sector), so that eight
// sectors are computed at once and their rounding is alike (model.md section 9).
//
// Net of a panel: below the kink row a triangular grid whose lines are parallel to the row, to rod s and to rod s+1;
// above it a square grid. Each line is a thread of its own with its own gradients; lines end at the rods and at the
// kink row, where the panel bends. All threads start straight and free of stress. Rods have one gradient per node and
// two at the kink, joined by a hinge that keeps the radial plane. Closing ropes run from tip to tip.

#include "engine/model/model.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

struct Pocket {
  Model model;
  Structure structure;  // of the model
  std::int32_t spacecraft = 0;
  std::int32_t target = 1;
  std::int32_t lower_rods = 0, upper_rods = 0;  // materials of the rods below and above their kinks
};

// The scenario must pass check_scenario. Throws std::runtime_error, one sentence, when the target's mesh file has
// become unreadable since then.
Pocket build_pocket(const Scenario& scenario);

}  // namespace netpocket
