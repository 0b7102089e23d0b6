#pragma once
// Proves that the state of a simulation is complete: what is saved, restored and stepped again is compared with what
// was stepped without, number by number and bit by bit. State that is missing shows as the first number that differs.

#include "engine/capture/simulation.h"

namespace netpocket::test {

// Advances `simulation` to `until` (s) three times: as it is; restored from the state it had, so that what it keeps
// besides the state is that of a later time; and in a new simulation of its present scenario restored from that state,
// which keeps nothing besides. A difference is a failure of the running test.
void advance_validated(Simulation& simulation, double until);

// The same in stretches of `stretch` (s).
void advance_validated(Simulation& simulation, double until, double stretch);

void expect_same_bits(const Snapshot& a, const Snapshot& b, const std::string& what);

}  // namespace netpocket::test
