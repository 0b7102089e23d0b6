// Studies that search, with the real engine over the first moments of a coarse pocket: optima and probabilities that
// follow from formulas.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/sampling/normal.h"
#include "engine/scenario/read_scenario.h"
#include "engine/study/record_files.h"
#include "engine/study/run_study.h"
#include "engine/study/study_status.h"
#include "tests/engine/study/study_folder.h"

namespace netpocket {
namespace {

constexpr const char* kFirstMoments = R"(
[set]
pocket.elements_per_side = 1
pocket.mesh_rows = 2
pocket.mesh_columns = 2
output.end_time = 0.02
)";

Study read_search_study(const StudyFolder& folder, const std::string& head, const std::string& rest) {
  StudyResult result = folder.read(head + kFirstMoments + rest);
  EXPECT_TRUE(result.ok()) << result.diagnostics.text();
  return std::move(result.study);
}

double number_of_setting(const Candidate& candidate, std::size_t index) {
  return std::stod(candidate.settings[index].value);
}

// The angular momentum at the start is 1210 kg m^2 f w with a factor f of the inertia, drawn, and a rate w, chosen. The
// largest mean over the draws whose largest stays below 150 N m s has w = 150 / (1210 max f).
constexpr const char* kSpin = R"(
[uncertain]
target.inertia = { distribution = "uniform", min = 0.5, max = 1.5, relative = true }
[optimise]
maximise = "angular_momentum_start"
candidates = 24
check = 40
restarts = 0
[optimise.over]
"target.spin[1]" = { from = 0.02, to = 0.4 }
[[optimise.constraint]]
of = "angular_momentum_start"
statistic = "largest"
at_most = 150
)";

TEST(Optimisation, FindsTheOptimumAtAConstraint) {
  const StudyFolder folder;
  Study study = read_search_study(folder, "sampling = \"sobol\"\nsamples = 8\n", kSpin);
  study.optimisation.candidates = 60;
  const StudyOutcome outcome = run_study(study, folder.file("out"), {.jobs = 2});
  ASSERT_TRUE(outcome.optimisation);
  const Optimisation& found = *outcome.optimisation;
  EXPECT_EQ(found.candidates.size(), 61u);
  EXPECT_EQ(outcome.points, 61u * 8 + 2 * 40);
  double sum = 0, most = 0;
  RecordReader reader;
  scan_records(folder.file("out"), [&](const RecordPlace& place) {
    if (place.point > 8) return;
    const double factor = reader.read(place)["runs"][0]["used"]["target.inertia[1]"].get<double>() / 1210;
    sum += factor;
    most = std::max(most, factor);
  });
  const Candidate& best = found.candidates[found.best];
  const double rate = 150 / (1210 * most);
  EXPECT_TRUE(best.is_feasible());
  EXPECT_NEAR(number_of_setting(best, 0), rate, 0.03 * rate);
  EXPECT_NEAR(best.objective, 150 / most * sum / 8, 0.03 * 150);
  EXPECT_LE(best.constraints[0], 150);
  // Fresh draws: the mean of f is 1.
  ASSERT_EQ(found.after.size(), 2u);
  EXPECT_TRUE(found.after[0].interval.contains(1210 * number_of_setting(best, 0)));
  EXPECT_NE(found.after[0].value, best.objective);
  EXPECT_NEAR(found.after[1].value, 1.5 * 1210 * number_of_setting(best, 0), 10);
  // The base does not spin.
  EXPECT_NEAR(found.before[0].value, 0, 1e-9);
}

TEST(Optimisation, LeavesAScenarioWithTheBestValues) {
  const StudyFolder folder;
  const Study study = read_search_study(folder, "samples = 4\n", kSpin);
  const StudyOutcome outcome = run_study(study, folder.file("out"), {.jobs = 2});
  ASSERT_TRUE(outcome.optimisation);
  const Candidate& best = outcome.optimisation->candidates[outcome.optimisation->best];
  const ScenarioResult scenario = read_scenario_file(folder.file("out/best.toml"));
  ASSERT_TRUE(scenario.ok()) << scenario.diagnostics.text();
  EXPECT_EQ(scenario.scenario.target.spin.y(), number_of_setting(best, 0));
  EXPECT_EQ(scenario.scenario.pocket.mesh_rows, 2);
  const std::string table = folder.text("out/study_optimisation.csv");
  EXPECT_EQ(std::ranges::count(table, '\n'), 26);
  EXPECT_TRUE(table.starts_with("candidate,generation,target.spin[1],objective,constraint_1,violation,")) << table;
  const std::string text = optimisation_text(study, *outcome.optimisation);
  EXPECT_NE(text.find("mean of angular_momentum_start (largest): "), text.npos) << text;
  EXPECT_NE(text.find("with 40 fresh draws: "), text.npos) << text;
  EXPECT_NE(optimisation_report(study, *outcome.optimisation).find("| at most 150 |"), std::string::npos);
}

// The relative speed is that of the target, least at rest.
TEST(Optimisation, WithoutScatterACandidateIsOneCapture) {
  const StudyFolder folder;
  const Study study = read_search_study(folder, "", R"(target.velocity = [0.2, 0.3, 0]
[optimise]
minimise = "relative_speed_start"
candidates = 120
restarts = 0
[optimise.over]
"target.velocity[0]" = { from = -0.5, to = 0.3 }
target.radius = { from = 3.5, to = 4.2 }
"target.velocity[1]" = { from = -0.2, to = 0.5 }
)");
  const StudyOutcome outcome = run_study(study, folder.file("out"), {.jobs = 2});
  ASSERT_TRUE(outcome.optimisation);
  const Optimisation& found = *outcome.optimisation;
  EXPECT_EQ(outcome.points, found.candidates.size());
  EXPECT_NEAR(found.candidates[0].objective, std::hypot(0.2, 0.3), 1e-12);
  EXPECT_LT(found.candidates[found.best].objective, 0.03);
  EXPECT_NEAR(number_of_setting(found.candidates[found.best], 0), 0, 0.03);
  EXPECT_TRUE(found.after.empty());
}

TEST(Optimisation, GoesOnWhereItWasInterrupted) {
  const StudyFolder folder;
  const Study study = read_search_study(folder, "sampling = \"sobol\"\nsamples = 4\n", kSpin);
  const StudyOutcome whole = run_study(study, folder.file("one"), {.jobs = 2});
  for (const std::size_t limit : {5u, 40u, 130u}) {
    std::stop_source stop;
    const StudyOutcome part = run_study(
        study, folder.file("two"), {.jobs = 2, .resume = true},
        [&](const StudyProgress& p) {
          if (p.points_done >= limit) stop.request_stop();
        },
        stop.get_token());
    EXPECT_TRUE(part.stopped);
    EXPECT_FALSE(part.optimisation);
    EXPECT_TRUE(part.has_tables);
    EXPECT_GE(part.points_done, limit);
    EXPECT_EQ(part.points, whole.points);
    EXPECT_EQ(study_status(folder.file("two")).finished, part.points_done);
  }
  const StudyOutcome rest = run_study(study, folder.file("two"), {.jobs = 1, .resume = true});
  EXPECT_LT(rest.runs_made, whole.runs_made - 120);
  for (const char* table : {"study.csv", "study.json", "study_columns.csv", "study_optimisation.csv", "best.toml"}) {
    EXPECT_FALSE(folder.text(std::string("one/") + table).empty()) << table;
    EXPECT_EQ(folder.text(std::string("one/") + table), folder.text(std::string("two/") + table)) << table;
  }
}

// A limit state that is linear in a normal input, beside inputs that do not matter: probability Phi(-3).
constexpr const char* kSlowTarget = R"(
[uncertain]
"target.velocity[1]" = { distribution = "normal", mean = 1, deviation = 0.2 }
target.mass = { distribution = "normal", mean = 200, deviation = 20 }
[rare]
of = "relative_speed_start"
at_most = 0.4
samples = 300
)";

TEST(RareFailure, IsAsRareAsTheFormulaSays) {
  const StudyFolder folder;
  const Study study = read_search_study(folder, "seed = 2\n", kSlowTarget);
  const StudyOutcome outcome = run_study(study, folder.file("out"), {.jobs = 2});
  ASSERT_TRUE(outcome.rare_failure);
  const SubsetResult& result = outcome.rare_failure->result;
  const double exact = normal_cumulative(-3);
  EXPECT_TRUE(result.is_resolved);
  EXPECT_EQ(result.levels, 3);
  EXPECT_EQ(result.evaluations, 300 + 2 * 270);
  EXPECT_EQ(outcome.points, 840u);
  EXPECT_TRUE(outcome.rare_failure->interval.contains(exact)) << result.probability;
  EXPECT_LT(outcome.rare_failure->interval.upper / outcome.rare_failure->interval.lower, 20);
  // What the first level takes a tenth of is the 10 % quantile of the speed.
  EXPECT_NEAR(level_value(study, result.steps[0]), 1 + 0.2 * normal_quantile(0.1), 0.05);
  EXPECT_EQ(outcome.rare_failure->refused, 0u);
  // The last level is the failure.
  const Interval last = level_interval(study, result.steps.back());
  EXPECT_DOUBLE_EQ(last.lower, outcome.rare_failure->interval.lower);
  EXPECT_DOUBLE_EQ(last.upper, outcome.rare_failure->interval.upper);
  EXPECT_TRUE(level_interval(study, result.steps[0]).contains(0.1));
  const std::string table = folder.text("out/study_rare.csv");
  EXPECT_TRUE(table.starts_with("level,relative_speed_start,probability,lower,upper\n1,0.7")) << table;
  EXPECT_NE(rare_failure_text(study, *outcome.rare_failure).find("relative_speed_start <= 0.4: "), std::string::npos);
}

TEST(RareFailure, GoesOnWhereItWasInterrupted) {
  const StudyFolder folder;
  const Study study = read_search_study(folder, "seed = 2\n", std::string(kSlowTarget) + "levels = 2\n");
  const StudyOutcome whole = run_study(study, folder.file("one"), {.jobs = 2});
  ASSERT_TRUE(whole.rare_failure);
  EXPECT_FALSE(whole.rare_failure->result.is_resolved);
  EXPECT_EQ(whole.rare_failure->interval.lower, 0);
  EXPECT_NE(rare_failure_text(study, *whole.rare_failure).find("at most about"), std::string::npos);
  std::stop_source stop;
  run_study(
      study, folder.file("two"), {.jobs = 2},
      [&](const StudyProgress& p) {
        if (p.points_done >= 400) stop.request_stop();
      },
      stop.get_token());
  const StudyOutcome rest = run_study(study, folder.file("two"), {.jobs = 2, .resume = true});
  EXPECT_LE(rest.runs_made, 170u);
  for (const char* table : {"study.csv", "study_rare.csv"}) {
    EXPECT_EQ(folder.text(std::string("one/") + table), folder.text(std::string("two/") + table)) << table;
  }
}

TEST(Search, SaysWhatIsWrong) {
  const StudyFolder folder;
  const auto expect = [&](const std::string& text, const std::string& words) {
    const std::string problems = folder.read(text).diagnostics.text();
    EXPECT_NE(problems.find(words), std::string::npos) << problems;
  };
  const std::string over = "[optimise.over]\ntarget.radius = { from = 3, to = 4 }\n";
  const std::string scatter = "[uncertain]\ntarget.mass = { distribution = \"uniform\", min = 1, max = 2 }\n";
  const std::string uncertain = "samples = 4\n" + scatter;
  expect("[optimise]\nminimise = \"peak_fy_N\"\ncandidates = 9\n", "names the parameters to choose");
  expect("[optimise]\ncandidates = 9\n" + over, "needs either 'minimise' or 'maximise'");
  expect("[optimise]\nminimise = \"peak_fy_N\"\n" + over, "says how many candidates to run");
  expect("[optimise]\nminimise = \"peak_fy_N\"\ncandidates = 9\nstatistic = \"median\"\n" + over,
         "share of a quantile");
  expect("[optimise]\nminimise = \"peak_fy_N\"\ncandidates = 9\n[optimise.over]\ntarget.shape = { from = 1, to = 2 }\n",
         "is no number");
  expect(
      "[optimise]\nminimise = \"peak_fy_N\"\ncandidates = 9\n[optimise.over]\ntarget.radius = { from = 4, to = 3 }\n",
      "'from' must be below 'to'");
  expect("[optimise]\nminimise = \"a\"\ncandidates = 9\n" + over + "[[optimise.constraint]]\nof = \"captured\"\n",
         "needs 'at_most' or 'at_least'");
  expect("[vary]\ntarget.mass = [1, 2]\n[optimise]\nminimise = \"a\"\ncandidates = 9\n" + over,
         "does not go with [optimise]");
  expect(
      uncertain + "[optimise]\nminimise = \"a\"\ncandidates = 9\n[optimise.over]\ntarget.mass = { from = 1, to = 2 }\n",
      "is [uncertain], and cannot be chosen too");
  expect("[rare]\nof = \"a\"\nat_most = 1\n", "needs [uncertain] inputs");
  expect(uncertain + "[rare]\nof = \"a\"\nat_most = 1\n", "does not go with [rare], which chooses its points itself");
  expect(scatter + "[rare]\nof = \"a\"\n", "needs either 'at_most' or 'at_least'");
  expect(scatter + "[rare]\nof = \"a\"\nat_most = 1\nsamples = 105\n", "is a multiple of 10");
}

}  // namespace
}  // namespace netpocket
