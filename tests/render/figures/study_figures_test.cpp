// Figures of campaigns, from results whose answers are known.
#include "render/figures/study_figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "engine/base/file_error.h"
#include "engine/study/worst_captures.h"
#include "render/figures/contour.h"
#include "render/figures/figure_file.h"
#include "render/figures/rich_text.h"
#include "tests/render/figures/test_directory.h"

namespace netpocket {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

TEST(Contour, OfARadiusIsACircle) {
  std::vector<double> places;
  for (int i = 0; i <= 40; ++i) places.push_back(-2 + 0.1 * i);
  Eigen::MatrixXd squares(41, 41);
  for (Eigen::Index i = 0; i < 41; ++i) {
    for (Eigen::Index j = 0; j < 41; ++j) {
      const double x = -2 + 0.1 * static_cast<double>(i), y = -2 + 0.1 * static_cast<double>(j);
      squares(j, i) = x * x + y * y;
    }
  }
  const auto segments = contour(places, places, squares, 1.21);
  double length = 0;
  for (const ContourSegment& segment : segments) {
    // Linear interpolation of a square over 0.1 is off by 0.1^2/4 at most; the slope is 2.2.
    EXPECT_NEAR(segment.from.norm(), 1.1, 1.2e-3);
    EXPECT_NEAR(segment.to.norm(), 1.1, 1.2e-3);
    length += (segment.to - segment.from).norm();
  }
  EXPECT_NEAR(length, 2 * 3.14159265 * 1.1, 0.02);
}

TEST(Contour, OfASaddleJoinsTheCornersOfTheMiddle) {
  Eigen::Matrix2d values;
  values << 1, -0.5, -0.5, 1;  // rows by y; the mean is above zero
  const auto segments = contour({0, 1}, {0, 1}, values, 0);
  ASSERT_EQ(segments.size(), 2u);
  for (const ContourSegment& segment : segments) {
    const Eigen::Vector2d middle = (segment.from + segment.to) / 2;
    EXPECT_GT(std::abs(middle.x() - middle.y()), 0.5) << "cuts off a corner that is below zero";
  }
  EXPECT_TRUE(contour({0, 1}, {0, 1}, values, 2).empty());
}

// 56 of 70 and 48 of 80: Newcombe (1998), Stat. Med. 17(8), 873-890, table II, example (a), method 10.
StudyResults published() {
  StudyResults results;
  results.inputs = {{"target.mass", "kg", {}}, {"contact.friction", "1", {}}};
  results.measures = {{"closed_time", "s", {}}};
  for (int i = 0; i < 150; ++i) {
    results.points.push_back(i + 1);
    results.inputs[0].values.push_back(i < 70 ? 1 : 0);
    results.inputs[1].values.push_back(i % 10);
    results.measures[0].values.push_back(i);
    results.captured.push_back(i < 56 || (i >= 70 && i < 118) ? 1 : 0);
  }
  return results;
}

TEST(StudyFigures, InfluenceIsThatOfAPublishedExample) {
  const auto influences = input_influences(published());
  ASSERT_EQ(influences.size(), 2u);
  EXPECT_EQ(influences[0].input, 0u);
  EXPECT_NEAR(influences[0].difference, 0.2, 1e-12);
  EXPECT_NEAR(influences[0].lower, 0.0524, 5e-5);
  EXPECT_NEAR(influences[0].upper, 0.3339, 5e-5);
}

TEST(StudyFigures, AreMadeOfAnyResults) {
  StudyResults unjudged = published();
  for (double& value : unjudged.captured) value = kUnknown;
  for (const StudyResults& results : {published(), unjudged, StudyResults{}}) {
    for (const std::string& name : study_figure_names()) {
      EXPECT_FALSE(encode_figure(make_study_figure(name, results), FigureFormat::svg).empty()) << name;
    }
  }
  EXPECT_THROW(make_study_figure("map", published()), FigureError);
  const Figure convergence = make_study_figure("convergence", published());
  EXPECT_NEAR(convergence.panels[0].curves.back().y.back(), 104 / 150.0, 1e-12);
}

// Of 100,000 captures, whose table is in the order of an input as that of a grid is, a map shows a fair sample.
TEST(StudyFigures, OfLargeCampaignsShowSomeCapturesAndSaySo) {
  constexpr int kRows = 100'000;
  StudyResults results;
  results.inputs = {{"target.mass", "kg", {}}, {"contact.friction", "1", {}}};
  results.measures = {{"closed_time", "s", {}}};
  for (int i = 0; i < kRows; ++i) {
    results.points.push_back(i + 1);
    results.inputs[0].values.push_back(i);
    results.inputs[1].values.push_back(i % 100);
    results.measures[0].values.push_back(static_cast<double>(i) * i);
    results.captured.push_back(i % 4 == 0 ? 0 : 1);
  }
  const Figure map = make_study_figure("capture_map", results);
  EXPECT_NE(map.title.find(", about 4000 of 100000 captures drawn"), map.title.npos) << map.title;
  const auto marks = [&](std::size_t curve) { return static_cast<double>(map.panels[0].curves[curve].x.size()) / 2; };
  EXPECT_NEAR(marks(0) + marks(1), 4000, 4 * 63) << "four standard deviations";
  EXPECT_NEAR(marks(0) / (marks(0) + marks(1)), 0.75, 4 * 0.0069);
  const Figure convergence = make_study_figure("convergence", results);
  const Curve& estimate = convergence.panels[0].curves.back();
  EXPECT_LE(estimate.x.size(), 2001u);
  EXPECT_EQ(estimate.x.back(), kRows);
  EXPECT_NEAR(estimate.y.back(), 0.75, 1e-12);
  const Figure distributions = make_study_figure("distributions", results);
  const Curve& shares = distributions.panels[0].curves[0];
  EXPECT_LE(shares.x.size(), 4000u);
  EXPECT_EQ(shares.x.front(), 0);
  EXPECT_EQ(shares.y.back(), 1);
  for (std::size_t i = 0; i < shares.x.size(); ++i) {
    EXPECT_NEAR(shares.y[i], std::sqrt(shares.x[i]) / kRows, 2.0 / 2000) << "a step of the curve";
  }
}

TEST(StudyFigures, SearchesHaveFiguresOfTheirOwn) {
  const auto has = [](const std::vector<std::string>& names, const char* name) {
    return std::ranges::find(names, name) != names.end();
  };
  StudyResults results = published();
  EXPECT_FALSE(has(suitable_study_figures(results), "optimisation"));
  EXPECT_FALSE(has(suitable_study_figures(results), "rare_failure"));
  results.optimisation = {{"candidate", "", {0, 1, 2, 3}},   {"generation", "", {0, 1, 1, 2}},
                          {"objective", "", {9, 7, 5, 6}},   {"violation", "", {0, 0, 2, 0}},
                          {"is_feasible", "", {1, 1, 0, 1}}, {"best_so_far", "", {9, 7, 7, 6}}};
  results.objective = "mean of load_body";
  ASSERT_TRUE(has(suitable_study_figures(results), "optimisation"));
  const Figure search = make_study_figure("optimisation", results);
  ASSERT_EQ(search.panels.size(), 2u) << "and the violation";
  EXPECT_EQ(search.panels[0].y.title, plain_text("mean of load_body"));
  for (const Panel& panel : search.panels) EXPECT_TRUE(panel.x.whole_numbers) << "there are no half generations";
  const Curve& misses = search.panels[0].curves[1];
  EXPECT_EQ(misses.x.size(), 2u) << "one candidate and the gap after it";
  EXPECT_EQ(misses.y[0], 5);
  const Curve& best = search.panels[0].curves[2];
  EXPECT_EQ(best.x, (std::vector<double>{0, 1, 1, 2, 2}));
  EXPECT_EQ(best.y, (std::vector<double>{9, 9, 7, 7, 6}));

  results.rare = {{"level", "", {1, 2}},
                  {"escape_depth", "m", {1.5, 0.2}},
                  {"probability", "", {0.1, 0.004}},
                  {"lower", "", {0.07, 0.001}},
                  {"upper", "", {0.14, 0.02}}};
  ASSERT_TRUE(has(suitable_study_figures(results), "rare_failure"));
  const Panel panel = make_study_figure("rare_failure", results).panels[0];
  EXPECT_EQ(panel.x.title, plain_text("escape_depth (m)"));
  ASSERT_EQ(panel.curves.size(), 3u);
  EXPECT_NEAR(panel.curves[0].y[3], std::log10(0.001), 1e-12);
  EXPECT_NEAR(panel.curves[1].y[1], std::log10(0.004), 1e-12);
  ASSERT_TRUE(panel.y.limits);
  EXPECT_EQ(panel.y.limits->low, -3);
  EXPECT_EQ(panel.y.limits->high, 0);
  ASSERT_EQ(panel.y.names.size(), 4u);
  EXPECT_EQ(panel.y.names[1].name, "10^{−2}");
}

TEST(StudyFigures, IndicesAreATornado) {
  StudyResults results = published();
  results.sensitivity = {{"first", "1", {0.2, 0.6}},       {"first_lower", "1", {0.1, 0.5}},
                         {"first_upper", "1", {0.3, 0.7}}, {"total", "1", {0.25, 0.7}},
                         {"total_lower", "1", {0.1, 0.6}}, {"total_upper", "1", {0.4, 0.8}}};
  results.sensitivity_inputs = {"target.mass", "contact.friction"};
  results.sensitivity_of = "captured";
  const std::vector<std::string> names = suitable_study_figures(results);
  EXPECT_EQ(std::ranges::count(names, "sensitivity"), 1);
  const Panel panel = make_study_figure("sensitivity", results).panels[0];
  ASSERT_EQ(panel.y.names.size(), 2u);
  EXPECT_EQ(panel.y.names[0].name, plain_text("contact.friction")) << "the greater one comes first";
  ASSERT_EQ(panel.curves.size(), 8u);
  EXPECT_EQ(panel.curves[0].x, (std::vector<double>{0, 0.7}));
  EXPECT_EQ(panel.curves[1].x, (std::vector<double>{0.6, 0.8}));
  EXPECT_EQ(panel.curves[2].x, (std::vector<double>{0, 0.6}));

  results.sensitivity = {{"mean", "1", {1, -2}}, {"mean_absolute", "1", {1, 2}}, {"deviation", "1", {0.5, 3}}};
  const Panel screening = make_study_figure("sensitivity", results).panels[0];
  ASSERT_EQ(screening.curves.size(), 4u) << "without intervals";
  EXPECT_EQ(screening.curves[0].x, (std::vector<double>{0, 2}));
}

TEST(WorstCaptures, AreThoseOfTheRanking) {
  StudyResults results;
  results.measures = {{"depth", "m", {0.5, -1, kUnknown, 2, -3, 0.6}}};
  results.points = {1, 2, 3, 4, 5, 6};
  results.captured = {1, 0, kUnknown, 1, 0, 1};
  EXPECT_EQ(worst_captures(results, {.by = "depth"}, 3), (std::vector<std::size_t>{4, 1, 0}));
  EXPECT_EQ(worst_captures(results, {.by = "depth", .largest_is_worst = true}, 2), (std::vector<std::size_t>{3, 5}));
  EXPECT_EQ(worst_captures(results, {.by = "depth"}, 99).back(), 2u) << "without a number it is last";
  EXPECT_TRUE(worst_captures(results, {.by = "load"}, 3).empty());
  EXPECT_EQ(typical_captures(results, "depth", 2), (std::vector<std::size_t>{5, 0}));
  EXPECT_EQ(typical_captures(results, "depth", 99).size(), 3u) << "captured ones only";
}

TEST(StudyResults, AreReadFromTheTables) {
  const std::string folder = test_directory().string();
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "/study_columns.csv") << "name,unit,meaning\ntarget.mass,kg,mass\nclosing.law,,law\n";
  std::ofstream(folder + "/study.csv")
      << "point,place,draw,target.mass,closing.law,variant,refused,ended,captured,closed_time\n"
         "1,,0,200,\"\"\"cycloid\"\"\",,,finished,yes,9.5\n"
         "2,,0,210,\"a, \"\"b\"\"\",,,finished,no,\n"
         "3,,0,,,,\"not valid, at all\",,,\n"
         "4,,0,220,,,,diverged,diverged,8\n";
  const StudyResults results = read_study_results(folder);
  ASSERT_EQ(results.size(), 3u);
  ASSERT_EQ(results.inputs.size(), 1u) << "a law is no number";
  EXPECT_EQ(results.inputs[0].unit, "kg");
  EXPECT_EQ(results.inputs[0].values, (std::vector<double>{200, 210, 220}));
  EXPECT_EQ(results.captured[0], 1);
  EXPECT_EQ(results.captured[1], 0);
  EXPECT_TRUE(std::isnan(results.captured[2]));
  EXPECT_EQ(results.find("closed_time")->values[2], 8);
  EXPECT_EQ(results.find("nothing"), nullptr);
  EXPECT_THROW(read_study_results(folder + "/nowhere"), FileError);
}

}  // namespace
}  // namespace netpocket
