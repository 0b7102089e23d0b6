#pragma once
// The complete state of a run at one moment: from it the run continues to the last bit.

#include <string>
#include <vector>

namespace netpocket {

struct Checkpoint {
  double time = 0;            // s
  std::vector<double> state;  // Simulation::checkpoint()
  // TOML of the scenario whose strategy took over in this state (Simulation::change_strategy); empty: it went on.
  std::string strategy;

  bool changes_strategy() const { return !strategy.empty(); }
};

}  // namespace netpocket
