#pragma once
// The table [tether] of a pocket: whether its rods stand on a hub that the spacecraft lets go, so that the pocket is
// towed on a line and not on its rods. SI units.

#include <vector>

#include "engine/base/diagnostics.h"
#include "engine/scenario/parameters.h"
#include "engine/scenario/scenario.h"
#include "engine/scenario/tether_drum.h"

namespace netpocket {

enum class ReleaseEvent { time, closed };

struct PocketTether {
  bool attached;
  ReleaseEvent released_at;
  double release_time;   // s, for released_at = time
  double release_delay;  // s, after the end of the closing, for released_at = closed
  double length;         // m
  int elements;
  CordParameters cord;
  TetherDrum drum;
  double hub_mass;       // kg
  double hub_thickness;  // m
};

// Least distance (m) over which the folded tether is stowed.
inline constexpr double kLeastStowed = 0.02;

// Of a scenario of the system "pocket".
PocketTether pocket_tether(const Scenario& scenario);

const ParameterGroup& pocket_tether_group();
std::vector<Parameter> pocket_tether_parameters();
// Adds what is wrong in the table.
void check_pocket_tether(const Scenario& scenario, Diagnostics& problems);

}  // namespace netpocket
