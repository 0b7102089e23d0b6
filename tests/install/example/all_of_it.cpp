// Runs a moment of the default pocket with the installed engine: prints its number of elements.

#include <cstdio>

#include "engine/capture/simulation.h"

int main() {
  netpocket::Simulation simulation{netpocket::Scenario{}};
  const netpocket::RunStatus status = simulation.advance(0.01);
  std::printf("%zu elements, %s\n", simulation.structure().elements.size(), netpocket::to_string(status.reason));
}
