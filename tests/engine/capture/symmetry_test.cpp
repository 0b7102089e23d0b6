// V6: with a centred sphere a run keeps its symmetry under 90 degrees to the last bit.

#include <fmt/format.h>

#include <cstdlib>

#include "engine/capture/simulation.h"
#include "engine/scenario/read_scenario.h"
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

Scenario case1() {
  ScenarioResult result = read_scenario_file(NETPOCKET_SOURCE_DIR "/scenarios/case1.toml");
  EXPECT_TRUE(result.ok()) << result.diagnostics.text();
  return result.scenario;
}

TEST_F(VerificationSymmetry, HoldsToTheLastBitUntilTheTow) {
  Simulation simulation(case1());
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

// A small pocket drawn together until its mouth's cords and rods lie on each other.
TEST_F(VerificationSymmetry, HoldsToTheLastBitWhereCordsTouch) {
  Scenario scenario;
  scenario.pocket.mesh_columns = scenario.pocket.mesh_rows = 4;
  scenario.pocket.elements_per_side = 1;
  scenario.closing.duration = 2;
  scenario.closing.closed_length = 0.3;
  scenario.closing.elements = 2;
  scenario.target.radius = 0.5;
  scenario.target.position = {0, 3, 0};
  const auto positions_at_the_end = [&](bool cords) {
    scenario.contact.cords = cords;
    Simulation simulation(scenario);
    EXPECT_EQ(simulation.advance(1.8).reason, RunReason::finished);
    return Eigen::Matrix3Xd(simulation.snapshot().positions);
  };
  const Eigen::Matrix3Xd touching = positions_at_the_end(true);
  EXPECT_FALSE(touching == positions_at_the_end(false)) << "no cord has touched another";
  expect_below("asymmetry of positions, cords in contact with each other", asymmetry(touching), 0,
               "a pair's forces do not depend on which comes first, and are summed in the same order in every sector");
}

// Growth of a stated perturbation over case 1 until the mouth is closed: every free node starts up to `size` off its
// place. A recorded study, not a check: the bounds only keep it from being empty. Run with NETPOCKET_STUDY=1.
TEST_F(VerificationSymmetry, GrowthOfAPerturbationStudy) {
  if (std::getenv("NETPOCKET_STUDY") == nullptr) GTEST_SKIP() << "set NETPOCKET_STUDY=1 (and NETPOCKET_RENEW=1)";
  for (const double size : {1e-12, 1e-9, 1e-6, 1e-3}) {
    Scenario scenario = case1();
    scenario.solver.perturbation = size;
    Simulation simulation(scenario);
    const std::string start = fmt::format("perturbed by {:.0e} m: ", size);
    const std::string source = "case 1, seed 1; recorded growth, see THEORY.md section 9";
    double lateral = 0;
    for (int frame = 1; frame <= 500; ++frame) {
      ASSERT_EQ(simulation.advance(0.02 * frame).reason, RunReason::finished);
      const Snapshot snapshot = simulation.snapshot();
      lateral =
          std::max(lateral, std::hypot(snapshot.channel(Channel::contact_fx), snapshot.channel(Channel::contact_fz)));
      if (frame % 100 != 0) continue;
      expect_below(start + fmt::format("asymmetry of positions at {} s, m", frame / 50), asymmetry(snapshot.positions),
                   10, source);
    }
    expect_below(start + "largest lateral force on the target until 10 s, N", lateral, 1e4, source);
  }
}

}  // namespace
}  // namespace netpocket
