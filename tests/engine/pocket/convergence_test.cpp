// V6: results against step and mesh; the two evaluations of the elements against each other.

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>

#include "engine/dynamics/simulation.h"
#include "engine/scenario/check_scenario.h"
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

Scenario case3(int mesh, double safety) {
  Scenario scenario;
  scenario.closing.duration = 5;
  scenario.pocket.mesh_columns = scenario.pocket.mesh_rows = mesh;
  scenario.solver.safety = safety;
  return scenario;
}

class VerificationConvergence : public test::VerificationTest {};

TEST_F(VerificationConvergence, HalfTheStep) {
  const Outcome whole = run(case3(4, 0.8), 5), half = run(case3(4, 0.4), 5);
  const std::string source = "case 3, 4 x 4 meshes, until closed; the same at half the step";
  expect_below("first contact, difference to half the step, s", std::abs(whole.first_contact - half.first_contact),
               0.02, source + ": a frame is 0.02 s");
  expect_below("impulse on the target, relative difference to half the step",
               std::abs(whole.impulse / half.impulse - 1), 0.03, source);
  expect_below("separation at 5 s, difference to half the step, m", std::abs(whole.separation - half.separation), 0.005,
               source);
}

TEST_F(VerificationConvergence, FinerMesh) {
  const Outcome coarse = run(case3(4, 0.8), 5), fine = run(case3(6, 0.8), 5);
  const std::string source = "case 3 until closed; 4 x 4 meshes against 6 x 6, whose net has another mass";
  expect_below("first contact, difference to a finer mesh, s", std::abs(coarse.first_contact - fine.first_contact), 0.3,
               source);
  expect_below("separation at 5 s, difference to a finer mesh, m", std::abs(coarse.separation - fine.separation), 0.1,
               source);
}

// How far the two evaluations are apart after a violent start, of the largest displacement.
double difference_of_evaluations(int elements_per_side) {
  Scenario scenario = case3(2, 0.8);
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

// The whole study of case 1: run with NETPOCKET_STUDY=<file>, takes minutes.
TEST(ConvergenceStudy, Case1) {
  const char* path = std::getenv("NETPOCKET_STUDY");
  if (path == nullptr) GTEST_SKIP() << "set NETPOCKET_STUDY to the file to write";
  std::ofstream table(path);
  table << "| meshes | safety | first contact, s | impulse of abs F_y, N s | peak abs F_y, N | separation at 20 s, m | "
           "energy error, % |\n| --- | --- | --- | --- | --- | --- | --- |\n";
  for (const auto& [mesh, safety] : {std::pair{6, 0.8}, {6, 0.4}, {6, 0.2}, {4, 0.8}, {8, 0.8}}) {
    Scenario scenario = case3(mesh, safety);
    scenario.closing.duration = 10;
    const Outcome o = run(scenario, 20);
    table << fmt::format("| {0} x {0} | {1} | {2:.2f} | {3:.2f} | {4:.1f} | {5:.4f} | {6:.3f} |\n", mesh, safety,
                         o.first_contact, o.impulse, o.peak, o.separation, 100 * o.energy_error)
          << std::flush;
  }
}

}  // namespace
}  // namespace netpocket
