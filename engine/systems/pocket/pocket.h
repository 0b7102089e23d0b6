#pragma once
// Builds the model of a netted pocket from a scenario: rods, knotted net, closing ropes, spacecraft and target.
//
// The pocket is one sector repeated around the Y axis. Sector s holds rod s, the panel between rods s and s+1, and the
// closing rope between their tips. Indices count the sector fastest (index = local * rods + sector), so that eight
// sectors are computed at once and are rounded alike (engine/THEORY.md section 9).
//
// Net of a panel: below the kink row a triangular grid with lines parallel to the row, to rod s and to rod s+1; above
// it a square grid. Each line is a thread with its own gradients. Lines end at the rods and at the kink row, where the
// panel bends. All threads start without stress. Rods have one gradient per node and two at the kink. A hinge joins
// these two and keeps the radial plane. Closing ropes run from tip to tip.

#include "engine/model/model.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

// A material of rods: below or above the kinks, of all rods or of one that is not like the others.
struct RodMaterial {
  std::int32_t material = 0;  // index
  double wall = 0;            // m
  double pressure = 1;        // times rods.pressure of the scenario
};

struct Pocket {
  Model model;
  Structure structure;          // of `model`
  std::int32_t spacecraft = 0;  // index of the body; likewise `target`
  std::int32_t target = 1;
  std::int32_t hub = -1;             // body on which the rods stand and that the spacecraft lets go; -1: the spacecraft
  std::vector<std::int32_t> tether;  // elements, from the spacecraft to the hub
  std::vector<RodMaterial> rod_materials;  // first those of all rods, below and above the kinks

  std::int32_t base() const { return hub >= 0 ? hub : spacecraft; }  // on which the rods stand
};

// The scenario must pass check_scenario. Throws std::runtime_error with one sentence when the target's mesh file has
// become unreadable since that check.
Pocket build_pocket(const Scenario& scenario);

}  // namespace netpocket
