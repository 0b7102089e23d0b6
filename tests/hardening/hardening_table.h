#pragma once
// Trials of robustness: how many to make, and their results in the table tests/HARDENING.md.
//
// In the test suite each makes a few. With the environment variable NETPOCKET_HARDENING=1 (`./dev harden`) it makes the
// full number, and writes into the table what it reached. Trials may run side by side.

#include <string>

namespace netpocket::test {

bool is_full_hardening();

// The number of trials to make now.
inline int trial_count(int few, int full) { return is_full_hardening() ? full : few; }

struct HardeningRow {
  std::string trial;    // what was done, e.g. "recordings with flipped bytes"
  std::string count;    // how often: a number with its noun
  std::string outcome;  // what came of it, counted
};

// In a full run: replaces the row of the same trial in the table and notes the program's commit. Returns false when the
// table cannot be written.
bool record_hardening(const HardeningRow& row);

}  // namespace netpocket::test
