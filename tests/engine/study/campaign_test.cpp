// Campaigns: uncertain inputs, parts, early end and estimates, with the real engine over the first moments of a coarse
// pocket.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "engine/statistics/empirical_distribution.h"
#include "engine/study/record_files.h"
#include "engine/study/run_study.h"
#include "engine/study/study_plan.h"
#include "engine/study/study_status.h"
#include "engine/study/study_table.h"
#include "tests/engine/study/study_folder.h"

namespace netpocket {
namespace {

constexpr const char* kCoarse = R"(
[set]
pocket.elements_per_side = 1
pocket.mesh_rows = 2
pocket.mesh_columns = 2
output.end_time = 0.02
)";

Study read(const StudyFolder& folder, const std::string& head, const std::string& rest) {
  StudyResult result = folder.read(head + kCoarse + rest);
  EXPECT_TRUE(result.ok()) << result.diagnostics.text();
  return std::move(result.study);
}

constexpr const char* kUncertain = R"(
[uncertain]
target.mass = { distribution = "normal", mean = 200, deviation = 20 }
"target.velocity[1]" = { distribution = "uniform", min = -0.5, max = -0.1 }
target.spin = { distribution = "direction", size = 0.1 }
contact.friction = { distribution = "triangular", min = 0.5, mode = 1, max = 1.5, relative = true }
closing.law = { distribution = "discrete", values = ["cycloid", "quintic"], weights = [3, 1] }
)";

std::vector<StudyRecord> records_of(const std::string& folder) {
  std::map<std::size_t, StudyRecord> records;
  RecordReader reader;
  scan_records(folder, [&](const RecordPlace& place) { records[place.point] = reader.read(place); });
  std::vector<StudyRecord> list;
  for (auto& [point, record] : records) list.push_back(std::move(record));
  return list;
}

std::vector<double> used(const std::vector<StudyRecord>& records, const std::string& key) {
  std::vector<double> values;
  for (const StudyRecord& record : records) values.push_back(record["runs"][0]["used"][key].get<double>());
  return values;
}

double agreement(const std::vector<double>& values, const Distribution& distribution) {
  const double statistic = kolmogorov_smirnov_statistic(EmpiricalDistribution(values),
                                                        [&](double x) { return cumulative(distribution, x); });
  return kolmogorov_smirnov_probability(statistic, values.size());
}

// Each rod has draws of its own, and a panel is torn in one of four captures.
TEST(Campaign, SingleRodsAndPanelsScatter) {
  const StudyFolder folder;
  const Study study = read(folder, "samples = 60\nseed = 5\n", R"(
scatter.rod_stiffness = [[1, 1], [2, 1], [3, 1], [4, 1], [5, 1], [6, 1], [7, 1], [8, 1]]
[uncertain]
"scatter.rod_stiffness[*][1]" = { distribution = "normal", mean = 1, deviation = 0.05 }
scatter.panel_stiffness = { distribution = "discrete", values = [[], [[2, 0.001]]], weights = [3, 1] }
)");
  ASSERT_EQ(study.uncertain.size(), 9u);
  run_study(study, folder.file("out"), {.jobs = 2});
  const std::vector<StudyRecord> records = records_of(folder.file("out"));
  ASSERT_EQ(records.size(), 60u);
  std::vector<double> all;
  for (int rod = 0; rod < 8; ++rod) {
    const auto factors = used(records, "scatter.rod_stiffness[" + std::to_string(rod) + "][1]");
    EXPECT_GT(agreement(factors, Normal{1, 0.05}), 0.01) << "rod " << rod + 1;
    all.insert(all.end(), factors.begin(), factors.end());
  }
  EXPECT_GT(agreement(all, Normal{1, 0.05}), 0.05);
  EXPECT_LT(agreement(all, Normal{1, 0.07}), 0.001) << "the test can tell";
  EXPECT_EQ(std::set(all.begin(), all.end()).size(), 480u) << "rods share no draws";
  int torn = 0;
  for (const StudyRecord& record : records)
    torn += record["runs"][0]["used"]["scatter.panel_stiffness"] != "[]" ? 1 : 0;
  EXPECT_NEAR(torn, 15, 10);
}

// Scatter that is set and never applied would go unnoticed in any table of settings. These values come from the
// simulation, and the motion of its bodies shows them.
TEST(Campaign, RunsUseTheValuesThatWereDrawn) {
  const StudyFolder folder;
  const Study study = read(folder, "samples = 60\nseed = 3\n", kUncertain);
  const StudyOutcome outcome = run_study(study, folder.file("out"), {.jobs = 2});
  EXPECT_EQ(outcome.points_done, 60u);
  EXPECT_EQ(outcome.runs_made, 60u);
  const std::vector<StudyRecord> records = records_of(folder.file("out"));
  ASSERT_EQ(records.size(), 60u);
  const auto masses = used(records, "target.mass"), speeds = used(records, "target.velocity[1]");
  EXPECT_EQ(std::set(masses.begin(), masses.end()).size(), 60u);
  EXPECT_GT(agreement(masses, Normal{200, 20}), 0.05);
  EXPECT_GT(agreement(speeds, Uniform{-0.5, -0.1}), 0.05);
  EXPECT_GT(agreement(used(records, "contact.friction"), Triangular{0.5 * 0.22, 0.22, 1.5 * 0.22}), 0.05);
  // A direction that is evenly distributed has a uniform height.
  EXPECT_GT(agreement(used(records, "target.spin[2]"), Uniform{-0.1, 0.1}), 0.05);
  EXPECT_LT(agreement(masses, Normal{205, 20}), agreement(masses, Normal{200, 20})) << "the test can tell";
  int quintic = 0;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const StudyRecord& run = records[i]["runs"][0];
    quintic += run["used"]["closing.law"] == "\"quintic\"" ? 1 : 0;
    EXPECT_NEAR(run["metrics"]["relative_speed_start"].get<double>(), std::abs(speeds[i]), 1e-12);
    // 1210 kg m^2 about every axis, turning at 0.1 rad/s.
    EXPECT_NEAR(run["metrics"]["angular_momentum_start"].get<double>(), 121, 1e-6);
  }
  EXPECT_NEAR(quintic, 15, 10);  // three standard deviations of a binomial number
  EXPECT_FALSE(std::filesystem::exists(folder.file("out/runs"))) << "nobody asked for recordings";
}

TEST(Campaign, MoreSamplesKeepTheOldPoints) {
  const StudyFolder folder;
  for (const char* sampling : {"monte_carlo", "sobol", "halton"}) {
    const auto points = [&](int samples) {
      return study_points(
          read(folder, "sampling = \"" + std::string(sampling) + "\"\nsamples = " + std::to_string(samples) + "\n",
               std::string("[vary]\nclosing.duration = [5, 10]\n") + kUncertain));
    };
    const auto few = points(3), many = points(8);
    ASSERT_EQ(few.size(), 6u);
    ASSERT_EQ(many.size(), 16u);
    for (std::size_t i = 0; i < few.size(); ++i) EXPECT_EQ(few[i].settings, many[i].settings) << sampling << i;
    // Each draw at every combination of the axes.
    EXPECT_NE(few[0].settings[4], few[1].settings[4]);
    EXPECT_EQ(few[0].settings.back(), few[1].settings.back());
  }
}

TEST(Campaign, AGridTakesTheMiddlesOfEquallyLikelyParts) {
  const StudyFolder folder;
  const Study study =
      read(folder, "sampling = \"grid\"\n",
           "[uncertain]\ntarget.mass = { distribution = \"uniform\", min = 0, max = 400, steps = 4 }\n");
  std::vector<std::string> values;
  for (const StudyPoint& point : study_points(study)) values.push_back(point.settings.back().value);
  EXPECT_EQ(values, (std::vector<std::string>{"50", "150", "250", "350"}));
}

TEST(Campaign, CorrelatedInputsAreDrawnTogether) {
  const StudyFolder folder;
  const Study study = read(folder, "samples = 400\n", R"(
[[correlated]]
keys = ["target.position[0]", "target.position[2]"]
mean = [0.1, -0.1]
deviation = [0.02, 0.05]
correlation = [[1, 0.8], [0.8, 1]]
)");
  const StudyPlan plan(study);
  Eigen::Matrix2Xd values(2, 400);
  for (Eigen::Index i = 0; i < 400; ++i) {
    const Scenario scenario = unchecked_scenario(study, plan.point(static_cast<std::size_t>(i)), {}).scenario;
    values.col(i) = Eigen::Vector2d(scenario.target.position.x(), scenario.target.position.z());
  }
  const Eigen::Vector2d mean = values.rowwise().mean();
  EXPECT_NEAR(mean.x(), 0.1, 0.004);
  EXPECT_NEAR(mean.y(), -0.1, 0.01);
  const Eigen::Matrix2Xd rest = values.colwise() - mean;
  const double correlation = rest.row(0).dot(rest.row(1)) / (rest.row(0).norm() * rest.row(1).norm());
  EXPECT_NEAR(correlation, 0.8, 0.06);  // three times (1 - rho^2)/sqrt(n)
}

std::string problems(const StudyFolder& folder, const std::string& rest) {
  return folder.read("samples = 4\n" + rest).diagnostics.text();
}

TEST(Campaign, SaysWhatIsWrongWithAnInput) {
  const StudyFolder folder;
  const auto expect = [&](const std::string& rest, const std::string& words) {
    EXPECT_NE(problems(folder, rest).find(words), std::string::npos) << problems(folder, rest);
  };
  expect("[uncertain]\ntarget.mass = 3\n", "expects a distribution");
  expect("[uncertain]\ntarget.mass = { distribution = \"gauss\", mean = 1 }\n", "'distribution' is one of normal, ");
  expect("[uncertain]\ntarget.mass = { distribution = \"normal\", mean = 1 }\n", "needs the number 'deviation'");
  expect("[uncertain]\ntarget.mass = { distribution = \"normal\", mean = 1, deviation = -1 }\n", "deviation");
  expect("[uncertain]\ntarget.mass = { distribution = \"uniform\", min = 1, max = 2, mode = 1 }\n",
         "does not take 'mode'");
  expect("[uncertain]\ntarget.moss = { distribution = \"uniform\", min = 1, max = 2 }\n", "did you mean");
  expect("[uncertain]\ntarget.spin = { distribution = \"direction\" }\n", "needs 'size'");
  expect("[uncertain]\nclosing.law = { distribution = \"normal\", mean = 1, deviation = 1, relative = true }\n",
         "no number");
  expect("[[correlated]]\nkeys = [\"target.mass\"]\nmean = [1, 2]\ndeviation = [1]\ncorrelation = [[1]]\n",
         "a mean and a deviation for each of the 1 keys");
  expect("[until]\nhalf_width = 0.1\n", "needs [uncertain] inputs");
  expect("[sensitivity]\nmethod = \"sobol\"\n", "needs 'blocks'");
  expect("[sensitivity]\nblocks = 4\n", "needs [uncertain] inputs");
}

constexpr const char* kTables[] = {"study.csv", "study.json", "study_columns.csv", "study_estimates.csv"};

TEST(Campaign, PartsGiveTheTablesOfOneProgram) {
  const StudyFolder folder;
  const Study study = read(folder, "sampling = \"sobol\"\nsamples = 7\n",
                           std::string(kUncertain) + "[estimate]\nof = [\"utilisation_peak\"]\n");
  run_study(study, folder.file("one"), {.jobs = 1});
  for (const int part : {3, 1, 2}) {
    const StudyOutcome outcome = run_study(study, folder.file("parts"), {.jobs = 2, .resume = true, .part = {part, 3}});
    EXPECT_FALSE(outcome.stopped);
    EXPECT_EQ(outcome.has_tables, part == 2) << "the last one writes them";
  }
  for (const char* table : kTables) {
    EXPECT_FALSE(folder.text(std::string("one/") + table).empty()) << table;
    EXPECT_EQ(folder.text(std::string("one/") + table), folder.text(std::string("parts/") + table)) << table;
  }
  // What is done is not run again, whatever the division.
  EXPECT_EQ(run_study(study, folder.file("parts"), {.resume = true, .part = {1, 2}}).runs_made, 0u);
}

TEST(Campaign, ALineThatAKilledProgramLeftIsRunAgain) {
  const StudyFolder folder;
  const Study study = read(folder, "samples = 4\n", kUncertain);
  run_study(study, folder.file("out"), {.jobs = 1});
  const std::string table = folder.text("out/study.csv"), records = folder.text("out/records/1_of_1.jsonl");
  const auto third = records.find("\n{\"point\":3,");
  ASSERT_NE(third, records.npos);
  folder.write("out/records/1_of_1.jsonl", records.substr(0, third + 200));
  EXPECT_EQ(study_status(folder.file("out")).finished, 2u);
  EXPECT_EQ(run_study(study, folder.file("out"), {.resume = true}).runs_made, 2u);
  EXPECT_EQ(folder.text("out/study.csv"), table);
}

// Far from the pocket nothing is caught: 0 of 30 has a Clopper-Pearson interval of half width 0.058, and fewer than
// kFewestTrials never end a study.
TEST(Campaign, EndsAtTheBatchAtWhichTheIntervalIsNarrow) {
  for (const int jobs : {1, 3}) {
    const StudyFolder folder;
    const Study study =
        read(folder, "samples = 200\n",
             std::string("closing.duration = 0.01\nclosing.closed_length = 5.78\ntarget.position = [0, 40, 0]\n") +
                 kUncertain + "[until]\nhalf_width = 0.06\nbatch = 15\n");
    const StudyOutcome outcome = run_study(study, folder.file("out"), {.jobs = jobs});
    EXPECT_EQ(outcome.points, 30u);
    EXPECT_EQ(outcome.points_done, 30u);
    EXPECT_FALSE(outcome.stopped);
    ASSERT_EQ(outcome.estimates.size(), 1u);
    EXPECT_EQ(outcome.estimates[0].tally.judged, 30);
    EXPECT_NEAR(outcome.estimates[0].clopper_pearson.upper, 1 - std::pow(0.025, 1 / 30.0), 1e-9);
    EXPECT_EQ(run_study(study, folder.file("out"), {.jobs = jobs, .resume = true}).points, 30u);
  }
}

// 81 of 263: Newcombe (1998), Stat. Med. 17(8), table I.
TEST(CampaignEstimator, GivesPublishedIntervals) {
  const StudyFolder folder;
  const Study study =
      read(folder, "samples = 300\n", std::string(kUncertain) + "[estimate]\nof = [\"hits\"]\nquantiles = [0.5]\n");
  CampaignEstimator estimator(study);
  for (int i = 0; i < 263; ++i) {
    estimator.add({{"point", i + 1}, {"runs", {{{"captured", i < 81}, {"metrics", {{"hits", i}}}}}}});
  }
  estimator.add({{"point", 264}, {"runs", {{{"captured", nullptr}, {"metrics", {{"hits", nullptr}}}}}}});
  estimator.add({{"point", 265}, {"runs", StudyRecord::array()}});
  const auto estimates = estimator.estimates();
  ASSERT_EQ(estimates.size(), 1u);
  const GroupEstimate& e = estimates[0];
  EXPECT_NEAR(e.wilson.lower, 0.2553, 5e-5);
  EXPECT_NEAR(e.wilson.upper, 0.3662, 5e-5);
  EXPECT_NEAR(e.clopper_pearson.lower, 0.2527, 5e-5);
  EXPECT_NEAR(e.clopper_pearson.upper, 0.3676, 5e-5);
  EXPECT_EQ(e.tally.not_judged, 1);
  EXPECT_EQ(e.refused, 1);
  ASSERT_EQ(e.quantiles.size(), 1u);
  EXPECT_EQ(e.quantiles[0].value, 131);  // the 132nd of 263
  EXPECT_EQ(e.quantiles[0].count, 263);
  EXPECT_NE(estimates_text(study, estimates).find("81 of 263 captures, 1 more not judged"), std::string::npos);
}

// The angular momentum at the start is I f w, with a factor f of the inertia, even from 0.5 to 1.5, and a rate w, even
// from 0 to 0.2 rad/s. For a product of independent inputs V = E[f^2] E[w^2] - E[f]^2 E[w]^2 = 1/225, of which Var(f)
// E[w]^2 = 1/1200 comes from f alone and Var(w) E[f]^2 = 1/300 from w alone: 3/16 and 3/4.
constexpr const char* kProduct = R"(
[uncertain]
target.inertia = { distribution = "uniform", min = 0.5, max = 1.5, relative = true }
"target.spin[1]" = { distribution = "uniform", min = 0, max = 0.2 }
)";

TEST(Sensitivity, SobolIndicesOfAProductAreThoseOfItsFormula) {
  const StudyFolder folder;
  const Study study =
      read(folder, "",
           std::string(kProduct) + "[sensitivity]\nmethod = \"sobol\"\nblocks = 64\nof = \"angular_momentum_start\"\n");
  const StudyOutcome outcome = run_study(study, folder.file("out"), {.jobs = 2});
  EXPECT_EQ(outcome.points, 256u);
  ASSERT_EQ(outcome.sensitivities.size(), 1u);
  const auto& indices = outcome.sensitivities[0].sobol;
  ASSERT_EQ(indices.size(), 2u);
  EXPECT_NEAR(indices[0].first.value, 3.0 / 16, 0.06);
  EXPECT_NEAR(indices[1].first.value, 3.0 / 4, 0.06);
  EXPECT_NEAR(indices[0].total.value, 1.0 / 4, 0.06);
  EXPECT_NEAR(indices[1].total.value, 13.0 / 16, 0.06);
  EXPECT_TRUE(indices[1].total.interval.contains(13.0 / 16));
  EXPECT_FALSE(folder.text("out/study_sensitivity.csv").empty());
}

TEST(Sensitivity, ScreeningFindsWhatMatters) {
  const StudyFolder folder;
  const Study study =
      read(folder, "",
           std::string(kProduct) + "target.mass = { distribution = \"uniform\", min = 150, max = 250 }\n" +
               "[sensitivity]\nmethod = \"morris\"\ntrajectories = 6\nof = \"angular_momentum_start\"\n");
  const StudyOutcome outcome = run_study(study, folder.file("out"), {.jobs = 2});
  EXPECT_EQ(outcome.points, 24u);
  ASSERT_EQ(outcome.sensitivities.size(), 1u);
  const auto& effects = outcome.sensitivities[0].effects;
  ASSERT_EQ(effects.size(), 3u);
  // Inertia, mass, rate: keys of one table stand together.
  EXPECT_GT(effects[2].mean_absolute, effects[0].mean_absolute);
  EXPECT_GT(effects[0].mean_absolute, 0);
  EXPECT_EQ(effects[1].mean_absolute, 0) << "the mass has no part in it";
  EXPECT_NEAR(effects[2].mean, effects[2].mean_absolute, 1e-9);
}

TEST(StudyStatus, CountsAndNamesFailures) {
  const StudyFolder folder;
  const Study study = read(folder, "", "[vary]\ntarget.radius = [4.0, 9.0]\n");
  run_study(study, folder.file("out"), {});
  const StudyStatus status = study_status(folder.file("out"));
  EXPECT_EQ(status.points, 2u);
  EXPECT_EQ(status.finished, 2u);
  EXPECT_EQ(status.refused, 1u);
  ASSERT_EQ(status.failures.size(), 1u);
  EXPECT_EQ(status.failures[0].point, 2u);
  EXPECT_NE(status.failures[0].reason.find("starts inside"), std::string::npos);
  EXPECT_TRUE(status.writing.empty());
  const RecordWriter writer(records_path(folder.file("out"), 1, 2));
  EXPECT_EQ(study_status(folder.file("out")).writing, std::vector<std::string>{"1_of_2.jsonl"});
  EXPECT_THROW(RecordWriter(records_path(folder.file("out"), 1, 2)), FileError);
  EXPECT_THROW(study_status(folder.file("")), FileError);
}

// Every column says what it is.
TEST(StudyTable, ColumnsHaveUnitsAndMeanings) {
  const StudyFolder folder;
  const Study study = read(folder, "samples = 2\n", kUncertain);
  run_study(study, folder.file("out"), {});
  std::istringstream columns(folder.text("out/study_columns.csv"));
  const std::string csv = folder.text("out/study.csv"), header = csv.substr(0, csv.find('\n'));
  std::string line, names;
  std::getline(columns, line);
  EXPECT_EQ(line, "name,unit,meaning");
  while (std::getline(columns, line)) {
    if (!names.empty()) names += ',';
    names += line.substr(0, line.find(','));
    EXPECT_NE(line.back(), ',') << line;
  }
  EXPECT_EQ(names, header);
  EXPECT_NE(header.find("target.spin[0],target.spin[1]"), header.npos);
  EXPECT_NE(header.find(",utilisation_peak,"), header.npos);
}

}  // namespace
}  // namespace netpocket
