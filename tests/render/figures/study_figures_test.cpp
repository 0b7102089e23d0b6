// Figures of campaigns, from results whose answers are known.
#include "render/figures/study_figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "engine/base/file_error.h"
#include "render/figures/contour.h"
#include "render/figures/figure_file.h"
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
