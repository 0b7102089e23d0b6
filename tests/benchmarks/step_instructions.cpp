// A short run of the default pocket, for counting its instructions: check_instructions.cmake counts what happens inside
// Simulation::advance. Prints the number of elements times steps.

#include <cstdio>

#include "engine/capture/simulation.h"

int main() {
  netpocket::Scenario scenario;
  netpocket::Simulation simulation(scenario);
  simulation.advance(0.02);
  const netpocket::RunStatistics statistics = simulation.statistics();
  std::printf("%lld\n", static_cast<long long>(statistics.steps) * statistics.elements);
}
