#pragma once
// The complete state of a run at one moment. A run that continues from it gives the same bits.

#include <string>
#include <vector>

namespace netpocket {

struct Checkpoint {
  double time = 0;            // s
  std::vector<double> state;  // Simulation::checkpoint()
  // TOML of the scenario whose strategy took over at this state (Simulation::change_strategy); empty: no change.
  std::string strategy;

  bool changes_strategy() const { return !strategy.empty(); }
};

}  // namespace netpocket
