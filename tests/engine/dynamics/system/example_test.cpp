// A cable in forty lines: how to describe and step any system of cables from C++, with no pocket.
//
// A light cord of 2 m hangs from a fixed hook and carries a weight of 1 kg that is let go 0.1 rad from the vertical.

#include "engine/dynamics/system/cable_system.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

class VerificationExample : public test::VerificationTest {};

TEST_F(VerificationExample, PendulumInFortyLines) {
  // Describe: a material, two points, a cable of eight elements between them.
  Model model;
  const auto cord = model.add_material({.section = {.EA = 1e4, .EI = 1e-3, .mass_per_length = 1e-3}});
  const auto hook = model.add_node({0, 0, 0});
  const auto weight = model.add_node({2 * std::sin(0.1), -2 * std::cos(0.1), 0});
  model.add_straight_cable(hook, weight, 8, cord);
  model.fix_node(hook);
  model.nodes[weight].point_mass = 1;
  model.gravity = {0, -9.81, 0};

  // Step: until the weight has passed below the hook, a quarter of a period after the start.
  CableSystem system(model);
  const double dt = 0.5 * system.stable_step().step;
  Eigen::Vector3d before = system.position(weight);
  while (before.x() > 0 && system.time() < 10) {
    before = system.position(weight);
    system.step(dt);
    if (system.position(weight).x() <= 0) break;
  }
  ASSERT_FALSE(system.fault()) << *system.fault();

  // Look: four quarters are a period; positions, gradients, energies and forces can be read at any time.
  const double passed = system.time() - dt * system.position(weight).x() / (system.position(weight).x() - before.x());
  const double swing = 1 + 0.1 * 0.1 / 16;  // amplitude's effect on the period
  expect_relative("period of a pendulum of 2 m, s", 4 * passed, 2 * M_PI * std::sqrt(2 / 9.81) * swing, 2e-3,
                  "2 pi sqrt(L/g) (1 + a^2/16); the cord's own mass (0.2 %) shortens it by a 1/12 of that share, its "
                  "stretch of 0.1 % lengthens it by half of that");
  expect_below("energy error of the pendulum / energy released", std::abs(system.audit().error) / (9.81 * 0.01), 1e-3,
               "no damping: leapfrog's error oscillates and does not grow");
}

}  // namespace
}  // namespace netpocket
