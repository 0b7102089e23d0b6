// V3 for the whole pocket: momenta of a free capture with closing ropes, contact and friction; energy audit.

#include "engine/dynamics/simulation.h"
#include "engine/pocket/pocket.h"
#include "tests/engine/dynamics/models.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using namespace test;

// A fast capture of a drifting, tumbling box by a coarse pocket; no symmetry.
Scenario skew_capture() {
  Scenario scenario;
  scenario.pocket.mesh_columns = scenario.pocket.mesh_rows = 4;
  scenario.target.shape = TargetShape::box;
  scenario.target.size = {5, 6, 7};
  scenario.target.spin = {0.1, 0.3, 0.2};
  scenario.target.velocity = {0.2, -0.1, 0.1};
  scenario.closing.duration = 3;
  scenario.towing.mode = TowingMode::none;
  return scenario;
}

class VerificationConservation : public VerificationTest {};

TEST_F(VerificationConservation, MomentumOfACapture) {
  const Pocket pocket = build_pocket(skew_capture());
  CableSystem system(pocket.model);
  const double dt = 0.5 * system.stable_step().step;
  const Momentum start = step_and_measure_momentum(system, dt);
  while (system.time() < 3.5) system.step(dt);
  ASSERT_FALSE(system.fault()) << *system.fault();
  const Momentum end = step_and_measure_momentum(system, dt);
  const Eigen::Vector3d impulse = system.contact_impulse(pocket.target);
  ASSERT_GT(impulse.norm(), 0.5);
  expect_below("linear momentum of a skew capture, drift / sum of the parts' momenta",
               (end.linear - start.linear).norm() / end.linear_scale, 1e-4,
               "exact but for the closing ropes, whose lumped mass follows the flow of material only on average");
  expect_below("angular momentum of a skew capture, drift / sum of the parts' momenta",
               (end.angular - start.angular).norm() / end.angular_scale, 1e-4, "as above");
}

TEST_F(VerificationConservation, EnergyOfACapture) {
  const auto error = [](double safety) {
    Scenario scenario = skew_capture();
    scenario.solver.safety = safety;
    Simulation simulation(scenario);
    EXPECT_EQ(simulation.advance(3.5).reason, RunReason::finished);
    const Snapshot snapshot = simulation.snapshot();
    return std::abs(snapshot.channel(Channel::energy_error)) / snapshot.channel(Channel::energy_input);
  };
  expect_below("energy error / energy put in, skew capture, safety 0.8", error(0.8), 1e-2,
               "damping and contact work are taken at half steps: first order in the step");
  expect_below("energy error / energy put in, skew capture, safety 0.4", error(0.4), 1e-2, "as above");
}

}  // namespace
}  // namespace netpocket
