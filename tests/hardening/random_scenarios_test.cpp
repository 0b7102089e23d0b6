// Whatever valid scenario is given: the run ends with its energy accounted for or says truly why not, records nothing
// that is not a number, and leaves no cord inside the target.
//
// What fails is kept as out/hardening/randomN.toml, for `netpocket run`; NETPOCKET_SCENARIOS=20-40 makes and keeps
// those.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "engine/ancf/shape_functions.h"
#include "engine/bodies/shape.h"
#include "engine/capture/run.h"
#include "engine/capture/simulation.h"
#include "engine/recording/recording.h"
#include "engine/scenario/write_scenario.h"
#include "tests/hardening/child_pool.h"
#include "tests/hardening/hardening_table.h"
#include "tests/hardening/random_scenario.h"

namespace netpocket::test {
namespace {

// Of the energy that changed hands. The audit's own error is some 1e-4 in ordinary captures.
constexpr double kEnergyBound = 0.02;
// Of all kinetic energy: what its rounding may feign where nothing changes hands.
constexpr double kRounding = 1e-6;
// How deep a contact point of a cord may be in the target: contact is compliant.
constexpr double kDepthBound = 0.05;  // m
// Longer runs are left out.
constexpr double kMostSteps = 300000;
// The few trials of ctest begin at this number: these take seconds, others minutes. Full trials begin at 1.
constexpr int kFirstOfFew = 5, kFew = 4;
// Of processor time, s: more than the longest of them takes under the sanitizers.
constexpr unsigned kMostSeconds = 3600;

double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

// Largest error of the audit over the largest energy that changed hands: the flight of a target of 1e7 kg is no measure
// of what the net does.
double energy_error(const Recording& run) {
  std::vector<double> kinetic_change = run.channel(Channel::energy_kinetic);
  double scale = std::max(1e-9, kRounding * largest(kinetic_change));
  const double start = kinetic_change.front();
  for (double& energy : kinetic_change) energy -= start;
  scale = std::max(scale, largest(kinetic_change));
  for (const Channel c : {Channel::energy_strain, Channel::energy_input, Channel::energy_dissipated}) {
    scale = std::max(scale, largest(run.channel(c)));
  }
  return largest(run.channel(Channel::energy_error)) / scale;
}

// How deep the deepest of many points of a cord's axis is in the target at the end, m; 0 outside.
double depth_in_target(const Recording& run) {
  constexpr int points = 33;
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

// How a run went. Travels from its process to this one as a line of text.
struct Outcome {
  int drawn = 0;
  RunReason reason = RunReason::running;
  bool left_out = false;
  double energy = 0, depth = 0;  // of runs that finished
  std::string message;           // of runs that did not

  std::string line() const {
    return fmt::format("{} {} {:d} {} {} {}", drawn, static_cast<int>(reason), left_out, energy, depth, message);
  }
  static Outcome parse(const std::string& line) {
    Outcome result;
    int reason = 0;
    std::istringstream(line) >> result.drawn >> reason >> result.left_out >> result.energy >> result.depth;
    result.reason = static_cast<RunReason>(reason);
    return result;
  }
};

void make(const Scenario& scenario, const std::string& path, Outcome& result) {
  result.left_out = scenario.output.end_time / Simulation(scenario).statistics().time_step > kMostSteps;
  if (result.left_out) return;
  // The recorder refuses what is not finite; then the run ends as storage_failed.
  const RunStatus status = run_to_recording(scenario, path, {.overwrite = true}).status;
  result.reason = status.reason;
  result.message = status.message;
  if (status.reason == RunReason::diverged && Recording(path).times().back() != status.time) {
    result.message = "its last frame is not of the state before: " + status.message;
    result.reason = RunReason::running;
  }
  if (status.reason != RunReason::finished) return;
  const Recording run(path);
  result.energy = energy_error(run);
  result.depth = depth_in_target(run);
}

Outcome make(unsigned seed, const std::string& path) {
  Outcome result;
  make(random_scenario(seed, result.drawn), path, result);
  return result;
}

// What is wrong with a run; empty when nothing is.
std::string fault(const Outcome& run, const std::string& message) {
  if (run.reason == RunReason::diverged) {
    return message.find(" in step ") == std::string::npos ? "diverged without a reason: " + message : "";
  }
  if (run.reason != RunReason::finished) return fmt::format("ended as {}: {}", to_string(run.reason), message);
  if (!(run.energy <= kEnergyBound)) return fmt::format("energy error {:.3g}", run.energy);
  if (!(run.depth <= kDepthBound)) return fmt::format("a cord is {:.3g} m inside the target", run.depth);
  return "";
}

class Trials {
 public:
  // `recorded`: in the table of trials.
  Trials(int wanted, bool recorded) : wanted_(wanted), recorded_(recorded) {}

  bool enough() const { return made_ >= wanted_; }
  int missing() const { return wanted_ - made_; }

  void add(int seed, const ChildResult& result) {
    const Outcome run = Outcome::parse(result.text);
    drawn_ += run.drawn;
    if (result.ended_well && run.left_out) {
      ++left_out_;
      return;
    }
    ++made_;
    if (run.reason == RunReason::finished) {
      ++finished_;
      worst_energy_ = std::max(worst_energy_, run.energy);
      worst_depth_ = std::max(worst_depth_, run.depth);
    }
    if (run.reason == RunReason::diverged) ++diverged_;
    const std::string problem = result.ended_well ? fault(run, result.text) : "its process ended: " + result.text;
    std::printf("scenario %d: %s%s\n", seed, result.text.c_str(), problem.empty() ? "" : " FAILED");
    std::fflush(stdout);
    const std::string kept = keep(seed, !problem.empty() || !recorded_);
    if (!problem.empty()) {
      ++failed_;
      ADD_FAILURE() << "scenario " << seed << " (" << kept << "): " << problem;
    }
    if (recorded_ && (made_ % 10 == 0 || enough())) {
      EXPECT_TRUE(record());
    }
  }

 private:
  // Writes the scenario to where the program can be tried with it; returns its path.
  static std::string keep(int seed, bool wanted) {
    const std::filesystem::path folder = NETPOCKET_SOURCE_DIR "/out/hardening";
    const std::string path = folder / fmt::format("random{}.toml", seed);
    if (!wanted) return path;
    int drawn = 0;
    std::filesystem::create_directories(folder);
    std::ofstream(path) << write_scenario_text(random_scenario(static_cast<unsigned>(seed), drawn));
    return path;
  }

  bool record() const {
    return record_hardening(
        {"random valid scenarios, 2 simulated seconds each",
         fmt::format("{} scenarios ({} drawn, {} left out as longer than {} steps)", made_, drawn_, left_out_,
                     kMostSteps),
         fmt::format("{} finished, {} ended with the reason, {} outside the bounds; energy error at most {:.2g}, cord "
                     "in target at most {:.2g} m; nothing recorded that is not finite",
                     finished_, diverged_, failed_, worst_energy_, worst_depth_)});
  }

  int wanted_, made_ = 0, drawn_ = 0, left_out_ = 0, finished_ = 0, diverged_ = 0, failed_ = 0;
  bool recorded_;
  double worst_energy_ = 0, worst_depth_ = 0;
};

TEST(RandomScenariosHardening, EndWellOrSayWhy) {
  std::string folder = testing::TempDir() + "/random-XXXXXX";
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  // Without a choice, numbers go on until enough runs were not left out.
  const char* chosen = std::getenv("NETPOCKET_SCENARIOS");
  int next = is_full_hardening() ? 1 : kFirstOfFew, last = 0;
  if (chosen != nullptr && std::sscanf(chosen, "%d-%d", &next, &last) == 1) last = next;
  Trials trials(chosen != nullptr ? last - next + 1 : trial_count(kFew, 500), chosen == nullptr);
  const auto trial = [&](int seed) {
    const std::string path = fmt::format("{}/{}.h5", folder, seed);
    const Outcome outcome = make(static_cast<unsigned>(seed), path);
    std::filesystem::remove(path);
    return outcome.line();
  };
  const auto take = [&](int seed, const ChildResult& result) { trials.add(seed, result); };
  if (chosen != nullptr) {
    run_in_children(next, last, kMostSeconds, trial, take);
  }
  while (chosen == nullptr && !trials.enough()) {
    last = next + trials.missing() - 1;
    run_in_children(next, last, kMostSeconds, trial, take);
    next = last + 1;
  }
  std::filesystem::remove_all(folder);
}

// A step that is too long for the elements: the run must end with its last sound state and say which step failed.
TEST(RandomScenariosHardening, DivergedRunsEndWhereTheyFailed) {
  const std::string path = testing::TempDir() + "/too_long_step.h5";
  for (const double ratio : {1.5, 3.0, 10.0}) {
    Scenario scenario;
    scenario.pocket.mesh_columns = scenario.pocket.mesh_rows = 2;
    scenario.solver.time_step = ratio * Simulation(scenario).statistics().time_step;
    scenario.output.end_time = 2;
    Outcome outcome;
    make(scenario, path, outcome);
    ASSERT_EQ(outcome.reason, RunReason::diverged) << outcome.message;
    EXPECT_EQ(fault(outcome, outcome.message), "") << outcome.message;
  }
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace netpocket::test
