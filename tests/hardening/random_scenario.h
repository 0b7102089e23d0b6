#pragma once
// Scenarios that nobody would think of, and yet valid ones.

#include "engine/scenario/scenario.h"

namespace netpocket::test {

// The scenario number `seed`: it passes check_scenario, has a coarse mesh and is 2 s long; any target, speeds up to
// 20 m/s, spin up to 10 rad/s, densities from 1e-6 to 1e6 kg/m^3, restitution and friction over all they may be.
// `drawn` counts the draws, those that were refused too.
Scenario random_scenario(unsigned seed, int& drawn);

}  // namespace netpocket::test
