#pragma once
// The drum that winds a tether, as the table [tether] of a pocket or of a thrown net describes it. SI units.

#include <vector>

#include "engine/base/diagnostics.h"
#include "engine/scenario/parameters.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

enum class TetherDrive { brake, rate, tension, drag };
// What the drum's drive and its brake wait for: a time, the first touch of the target, the end of the closing.
enum class DrumEvent { time, contact, closed };

struct TetherDrum {
  bool attached;  // whether there is one
  TetherDrive drive;
  double rate;            // m/s, paying out
  double tension;         // N
  double slip_tension;    // N
  DrumEvent drive_event;  // from which on it drives; braked before
  double drive_delay;     // s, from the event; for DrumEvent::time from the start of the run
  DrumEvent brake_event;  // from which on it is braked for good
  double brake_at;        // s, for DrumEvent::time
  double brake_delay;     // s, from other events
  double radius;          // m
  double inertia;         // kg m^2
  double motor_torque;    // N m
  double fastest;         // m/s
  double length;          // m, of tether outside at the start
  double reserve;         // m, on the drum at the start
  double least_length;    // m
};

// Of a scenario of a system whose table [tether] has these parameters.
TetherDrum tether_drum(const Scenario& scenario);

std::vector<Parameter> tether_drum_parameters();
// Whether a change of one of them can act on a run in progress.
bool drum_acts_at_once(std::string_view key);
// Adds what is wrong with them. `closes`: whether there is a closing that ends.
void check_tether_drum(const Scenario& scenario, bool closes, Diagnostics& problems);

}  // namespace netpocket
