// V6: results against step and mesh; the two evaluations of the elements against each other.

#include <fmt/format.h>

#include <cstdlib>

#include "engine/capture/simulation.h"
#include "engine/dynamics/assembly/stable_step.h"
#include "engine/scenario/check_scenario.h"
#include "engine/systems/pocket/materials.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

struct Outcome {
  double first_contact = 0;  // s
  double impulse = 0;        // N s, of |F_y| on the target
  double peak = 0;           // N, of |F_y| averaged over a frame
  double separation = 0;     // m, target from spacecraft along y at the end
  double energy_error = 0;   // of the energy put in
};

Outcome run(const Scenario& scenario, double end) {
  EXPECT_TRUE(check_scenario(scenario).ok());
  Simulation simulation(scenario);
  Outcome outcome;
  const double frame = 1 / scenario.output.frame_rate;
  for (int i = 1; i * frame < end + 0.5 * frame; ++i) {
    EXPECT_EQ(simulation.advance(i * frame).reason, RunReason::finished);
    const Snapshot snapshot = simulation.snapshot();
    const double force = std::abs(snapshot.channel(Channel::contact_fy));
    outcome.impulse += force * frame;
    outcome.peak = std::max(outcome.peak, force);
    if (outcome.first_contact == 0 && force > 0) outcome.first_contact = snapshot.time;
    outcome.separation = snapshot.channel(Channel::target_y) - snapshot.channel(Channel::spacecraft_y);
    outcome.energy_error =
        std::abs(snapshot.channel(Channel::energy_error)) / std::max(1.0, snapshot.channel(Channel::energy_input));
  }
  return outcome;
}

// The pocket of the defaults (scenarios/low_kink.toml), closed in 5 s: a gentle one, whose contacts do not chatter as
// those of the paper's cases do (paper_cases_test.cpp).
Scenario gentle_pocket(int mesh, double safety) {
  Scenario scenario;
  scenario.closing.duration = 5;
  scenario.pocket.mesh_columns = scenario.pocket.mesh_rows = mesh;
  scenario.solver.safety = safety;
  scenario.output.frame_rate = 200;
  return scenario;
}

class VerificationConvergence : public test::VerificationTest {};

TEST_F(VerificationConvergence, HalfTheStep) {
  const double safety = Scenario().solver.safety;
  const Outcome whole = run(gentle_pocket(6, safety), 5), half = run(gentle_pocket(6, 0.5 * safety), 5);
  const std::string source = "low_kink pocket until closed in 5 s; the same at half the step";
  expect_below("first contact, difference to half the step, s", std::abs(whole.first_contact - half.first_contact),
               0.0101, source + ": two frames of 0.005 s");
  expect_below("impulse on the target, relative difference to half the step",
               std::abs(whole.impulse / half.impulse - 1), 0.03, source);
  expect_below("separation at 5 s, difference to half the step, m", std::abs(whole.separation - half.separation), 0.01,
               source);
}

TEST(StepChoice, SaysWhatLimits) {
  Scenario scenario = gentle_pocket(2, 0.9);
  scenario.closing.duration = 4;  // gently: ropes that swing bend, which takes from the step
  scenario.closing.closed_length = 1.2;
  scenario.closing.elements = 6;
  scenario.target.radius = 0.5;
  Simulation simulation(scenario);
  const RunStatistics start = simulation.statistics();
  EXPECT_EQ(start.step_limit.find("closing ropes"), std::string::npos) << start.step_limit;
  ASSERT_EQ(simulation.advance(4).reason, RunReason::finished);
  const RunStatistics closed = simulation.statistics();
  EXPECT_NE(closed.step_limit.find("closing ropes"), std::string::npos) << closed.step_limit;
  EXPECT_LT(closed.time_step, 0.9 * start.time_step);
  const double bound =
      0.9 * stable_step_of_lumped_element(cord_material(scenario.rope).section, 1.2 / scenario.closing.elements, true);
  EXPECT_LE(closed.time_step, bound);
  EXPECT_GT(closed.time_step, 0.95 * bound);

  scenario.solver.time_step = 2e-5;
  EXPECT_EQ(Simulation(scenario).statistics().step_limit, "solver.time_step");
}

TEST_F(VerificationConvergence, FinerMesh) {
  const Outcome coarse = run(gentle_pocket(6, 0.8), 5), fine = run(gentle_pocket(8, 0.8), 5);
  const std::string source =
      "low_kink pocket until closed in 5 s; 6 x 6 meshes against 8 x 8, whose net has another mass";
  expect_below("first contact, difference to a finer mesh, s", std::abs(coarse.first_contact - fine.first_contact), 0.3,
               source);
  expect_below("separation at 5 s, difference to a finer mesh, m", std::abs(coarse.separation - fine.separation), 0.1,
               source);
}

// How far the two evaluations are apart after a violent start, of the largest displacement.
double difference_of_evaluations(int elements_per_side) {
  Scenario scenario = gentle_pocket(2, 0.8);
  scenario.closing.duration = 0.5;
  scenario.pocket.elements_per_side = elements_per_side;
  const auto positions = [&](Evaluation evaluation) {
    scenario.solver.evaluation = evaluation;
    Simulation simulation(scenario);
    const RunStatus status = simulation.advance(0.1);
    EXPECT_EQ(status.reason, RunReason::finished) << status.message;
    return Eigen::Matrix3Xd(simulation.snapshot().positions);
  };
  const Eigen::Matrix3Xd mean = positions(Evaluation::mean_strain), full = positions(Evaluation::full);
  const Eigen::Matrix3Xd start = Simulation(scenario).snapshot().positions;
  return (full - mean).colwise().norm().maxCoeff() / (mean - start).colwise().norm().maxCoeff();
}

TEST_F(VerificationConvergence, FullAgainstMeanStrainPocket) {
  const std::string source =
      "pocket of 2 x 2 meshes closing in 0.5 s, after 0.1 s; very coarse, shrinks with the mesh "
      "(0.04 with 4 elements a side)";
  const double coarse = difference_of_evaluations(1), fine = difference_of_evaluations(2);
  expect_below("full against mean-strain, difference / displacement, 1 element a side", coarse, 1.0, source);
  expect_below("full against mean-strain, difference / displacement, 2 elements a side", fine, 0.45, source);
  EXPECT_LT(fine, 0.6 * coarse);
}

// First contact and impulse of a whole capture by both evaluations.
TEST_F(VerificationConvergence, FullAgainstMeanStrainCaptureStudy) {
  if (std::getenv("NETPOCKET_STUDY") == nullptr) GTEST_SKIP() << "set NETPOCKET_STUDY=1 (and NETPOCKET_RENEW=1)";
  for (const int per_side : {1, 2}) {
    Scenario scenario = gentle_pocket(4, 0.8);
    scenario.pocket.elements_per_side = per_side;
    const Outcome mean = run(scenario, 5);
    scenario.solver.evaluation = Evaluation::full;
    const Outcome full = run(scenario, 5);
    const std::string what = fmt::format("capture, full against mean-strain, {} element(s) a side: ", per_side);
    const std::string source =
        fmt::format("low_kink pocket until closed in 5 s, 4 x 4 meshes; mean-strain: contact at {:.2f} s, {:.1f} N s",
                    mean.first_contact, mean.impulse);
    expect_below(what + "first contact, s", std::abs(full.first_contact - mean.first_contact), 0.5, source);
    expect_below(what + "impulse, relative", std::abs(full.impulse / mean.impulse - 1), 0.5, source);
    expect_below(what + "separation at 5 s, m", std::abs(full.separation - mean.separation), 0.2, source);
  }
}

// A closing in 10 s and the tow at three steps and three meshes, against the finest of each.
TEST_F(VerificationConvergence, CaptureAndTowStudy) {
  if (std::getenv("NETPOCKET_STUDY") == nullptr) GTEST_SKIP() << "set NETPOCKET_STUDY=1 (and NETPOCKET_RENEW=1)";
  const auto outcome = [](int mesh, double safety) {
    Scenario scenario = gentle_pocket(mesh, safety);
    scenario.closing.duration = 10;
    return run(scenario, 20);
  };
  const auto compare = [&](const std::string& what, const Outcome& o, const Outcome& finest) {
    const std::string source = fmt::format(
        "low_kink pocket to 20 s, against the finest: contact at {:.2f} s, {:.1f} N s, {:.1f} N, "
        "{:.3f} m",
        finest.first_contact, finest.impulse, finest.peak, finest.separation);
    expect_below(what + ": first contact, difference, s", std::abs(o.first_contact - finest.first_contact), 0.5,
                 source);
    expect_below(what + ": impulse of abs F_y, relative difference", std::abs(o.impulse / finest.impulse - 1), 0.5,
                 source);
    expect_below(what + ": peak abs F_y, relative difference", std::abs(o.peak / finest.peak - 1), 1, source);
    expect_below(what + ": separation at 20 s, difference, m", std::abs(o.separation - finest.separation), 0.3, source);
    expect_below(what + ": energy error / energy put in", o.energy_error, 0.02, source);
  };
  const Outcome quarter = outcome(6, 0.2);
  compare("6 x 6 meshes, safety 0.8", outcome(6, 0.8), quarter);
  compare("6 x 6 meshes, safety 0.4", outcome(6, 0.4), quarter);
  const Outcome fine = outcome(8, 0.8);
  compare("4 x 4 meshes, safety 0.8", outcome(4, 0.8), fine);
  compare("6 x 6 meshes against 8 x 8, safety 0.8", outcome(6, 0.8), fine);
}

}  // namespace
}  // namespace netpocket
