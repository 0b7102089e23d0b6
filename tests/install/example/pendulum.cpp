// A light cord of 2 m hangs from a hook and carries 1 kg, let go 0.1 rad from the vertical: prints its period (s).

#include <cmath>
#include <cstdio>

#include "engine/dynamics/system/cable_system.h"

int main() {
  netpocket::Model model;
  const auto cord = model.add_material({.section = {.EA = 1e4, .EI = 1e-3, .mass_per_length = 1e-3}});
  const auto hook = model.add_node({0, 0, 0});
  const auto weight = model.add_node({2 * std::sin(0.1), -2 * std::cos(0.1), 0});
  model.add_straight_cable(hook, weight, 8, cord);
  model.fix_node(hook);
  model.nodes[weight].point_mass = 1;
  model.gravity = {0, -9.81, 0};

  netpocket::CableSystem system(model);
  const double dt = 0.5 * system.stable_step().step;
  while (system.position(weight).x() > 0 && system.time() < 10) system.step(dt);
  if (const auto fault = system.fault()) {
    std::printf("%s\n", fault->c_str());
    return 1;
  }
  std::printf("period %.2f s\n", 4 * system.time());
}
