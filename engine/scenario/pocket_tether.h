#pragma once
// The table [tether] of a pocket: whether its rods stand on a hub that the spacecraft lets go, so that the pocket is
// towed on a line and not on its rods. SI units.

#include <vector>

#include "engine/base/diagnostics.h"
#include "engine/scenario/parameters.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

enum class ReleaseEvent { time, closed };
enum class TetherDrive { brake, rate, tension };

struct PocketTether {
  bool attached;
  ReleaseEvent released_at;
  double release_time;   // s, for released_at = time
  double release_delay;  // s, after the end of the closing, for released_at = closed
  double length;         // m
  int elements;
  CordParameters cord;
  // Of its winch.
  bool has_winch;
  TetherDrive drive;
  double rate;           // m/s, paying out
  double tension;        // N
  double slip_tension;   // N
  double brake_at;       // s
  double drum_radius;    // m
  double drum_inertia;   // kg m^2
  double motor_torque;   // N m
  double fastest;        // m/s
  double reserve;        // m, on the drum at the start
  double least_length;   // m
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
