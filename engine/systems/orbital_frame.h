#pragma once
// Puts a capture system into the orbit of its scenario.

#include "engine/systems/capture_system.h"

namespace netpocket {

// Gives the model of `system` the scenario's orbit, if it has one, and the channels that only such a run has. With
// orbit.axes = "local", what rests in the scenario rests in the local axes, which turn: their motion is added to all
// velocities at the start.
void put_into_orbit(const Scenario& scenario, CaptureSystem& system);

}  // namespace netpocket
