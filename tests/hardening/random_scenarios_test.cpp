// Whatever valid scenario is given: the run ends with its energy accounted for or says truly why not, records nothing
// that is not a number, and leaves no cord inside the target.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "engine/ancf/shape_functions.h"
#include "engine/bodies/shape.h"
#include "engine/dynamics/run.h"
#include "engine/recording/recording.h"
#include "engine/scenario/write_scenario.h"
#include "tests/hardening/hardening_table.h"
#include "tests/hardening/random_scenario.h"

namespace netpocket::test {
namespace {

// Of all energy there is or was put in. The audit's own error is some 1e-4 in ordinary captures.
constexpr double kEnergyBound = 0.02;
// How deep a contact point of a cord may be in the target: contact is compliant.
constexpr double kDepthBound = 0.05;  // m
// Longer runs are left out.
constexpr double kMostSteps = 300000;

struct Tally {
  int made = 0, drawn = 0, left_out = 0, finished = 0, diverged = 0, failed = 0;
  double worst_energy = 0, worst_depth = 0;
};

double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

// Largest error of the audit over the largest energy there was.
double energy_error(const Recording& run) {
  double scale = 1e-9;
  for (const Channel c :
       {Channel::energy_kinetic, Channel::energy_strain, Channel::energy_input, Channel::energy_dissipated}) {
    scale = std::max(scale, largest(run.channel(c)));
  }
  return largest(run.channel(Channel::energy_error)) / scale;
}

// How deep the deepest contact point of a cord is in the target at the end, m; 0 outside. Between these points the
// target's corners may stand through a cord, as they may through the meshes of the net.
double depth_in_target(const Recording& run, int points) {
  const Snapshot end = run.frame(run.frame_count() - 1);
  double depth = 0;
  for (std::size_t b = 0; b < run.structure().bodies.size(); ++b) {
    if (run.structure().bodies[b].role != BodyRole::target) continue;
    const BodyState& body = end.bodies[b];
    for (const StructureElement& e : run.structure().elements) {
      const double length = e.rope >= 0 ? end.rope_element_length[e.rope] : e.length;
      for (int i = 0; i < points; ++i) {
        const NodalWeights s = shape((2.0 * i + 1 - points) / points, length);
        const Eigen::Vector3d point = s[0] * end.positions.col(e.node[0]) + s[1] * end.gradients.col(e.gradient[0]) +
                                      s[2] * end.positions.col(e.node[1]) + s[3] * end.gradients.col(e.gradient[1]);
        const Eigen::Vector3d local = body.attitude.conjugate() * (point - body.position);
        depth = std::max(depth, -nearest_surface_point(run.structure().bodies[b].shape, local).distance);
      }
    }
  }
  return depth;
}

// What is wrong with a run; empty when nothing is.
std::string fault(const Recording& run, const Scenario& scenario, Tally& tally) {
  const RunStatus& status = run.status();
  if (status.reason == RunReason::diverged) {
    ++tally.diverged;
    return status.message.find(" in step ") == std::string::npos ? "diverged without a reason" : "";
  }
  if (status.reason != RunReason::finished) return "ended as " + std::string(to_string(status.reason));
  ++tally.finished;
  const double energy = energy_error(run), depth = depth_in_target(run, scenario.contact.samples_per_element);
  tally.worst_energy = std::max(tally.worst_energy, energy);
  tally.worst_depth = std::max(tally.worst_depth, depth);
  if (!(energy <= kEnergyBound)) return fmt::format("energy error {:.3g}", energy);
  if (!(depth <= kDepthBound)) return fmt::format("a cord is {:.3g} m inside the target", depth);
  return "";
}

bool record_tally(const Tally& tally) {
  return record_hardening(
      {"random valid scenarios, 2 simulated seconds each",
       fmt::format("{} scenarios ({} drawn, {} left out as longer than {} steps)", tally.made, tally.drawn,
                   tally.left_out, kMostSteps),
       fmt::format(
           "{} finished, {} diverged with the reason, {} outside the bounds; energy error at most {:.2g}, cord in "
           "target at most {:.2g} m; nothing recorded that is not finite",
           tally.finished, tally.diverged, tally.failed, tally.worst_energy, tally.worst_depth)});
}

TEST(RandomScenariosHardening, EndWellOrSayWhy) {
  std::string folder = testing::TempDir() + "/random-XXXXXX";
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  const std::string path = folder + "/run.h5";
  std::mt19937 random(7);
  const int trials = trial_count(2, 500);
  Tally tally;
  while (tally.made < trials) {
    const Scenario scenario = random_scenario(random, tally.drawn);
    if (scenario.output.end_time / Simulation(scenario).statistics().time_step > kMostSteps) {
      ++tally.left_out;
      continue;
    }
    run_to_recording(scenario, path, {.overwrite = true});
    ++tally.made;
    // The recorder refuses what is not finite; then the run ends as storage_failed.
    const std::string problem = fault(Recording(path), scenario, tally);
    if (!problem.empty()) {
      ++tally.failed;
      const std::string kept = fmt::format("{}/random{}.toml", testing::TempDir(), tally.made);
      std::ofstream(kept) << write_scenario_text(scenario);
      ADD_FAILURE() << "scenario " << tally.made << " (" << kept << "): " << problem;
    }
    if (tally.made % 10 == 0 || tally.made == trials) {
      EXPECT_TRUE(record_tally(tally));
    }
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace netpocket::test
