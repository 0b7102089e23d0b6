// V6: with a centred sphere a run keeps its symmetry under 90 degrees to the last bit.

#include "engine/dynamics/simulation.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

class VerificationSymmetry : public test::VerificationTest {};

// Largest difference between what two sectors further on is and what it should be.
double asymmetry(const Eigen::Matrix3Xd& values) {
  double largest = 0;
  for (Eigen::Index i = 0; i < values.cols(); ++i) {
    const Eigen::Vector3d here = values.col(i), there = values.col(i / 8 * 8 + (i + 2) % 8);
    largest = std::max(largest, (there - Eigen::Vector3d(-here.z(), here.y(), here.x())).cwiseAbs().maxCoeff());
  }
  return largest;
}

TEST_F(VerificationSymmetry, HoldsToTheLastBitUntilTheTow) {
  const Scenario scenario;  // case 1
  Simulation simulation(scenario);
  double largest = 0, lateral = 0, force = 0;
  for (int second = 1; second <= 10; ++second) {
    const RunStatus status = simulation.advance(second);
    ASSERT_EQ(status.reason, RunReason::finished) << status.message;
    const Snapshot snapshot = simulation.snapshot();
    largest = std::max(
        {largest, asymmetry(snapshot.positions), asymmetry(snapshot.gradients), asymmetry(snapshot.velocities)});
    lateral = std::max({lateral, std::abs(snapshot.channel(Channel::contact_fx)),
                        std::abs(snapshot.channel(Channel::contact_fz)), std::abs(snapshot.channel(Channel::target_x)),
                        std::abs(snapshot.channel(Channel::target_z))});
    force = std::max(force, std::abs(snapshot.channel(Channel::contact_fy)));
  }
  ASSERT_GT(force, 0) << "no contact in 10 s";
  expect_below("asymmetry of positions, gradients and velocities until 10 s, case 1", largest, 0,
               "sums are ordered so that a quarter turn only swaps the two terms of a sum (THEORY.md): exact");
  expect_below("lateral force on and displacement of the target until 10 s, case 1", lateral, 0, "exact");
}

}  // namespace
}  // namespace netpocket
