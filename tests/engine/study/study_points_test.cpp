#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/study/study.h"

namespace netpocket {
namespace {

Study with_axes(std::vector<Axis> axes) {
  Study study;
  study.places = {{}};
  study.variants = {{}};
  study.axes = std::move(axes);
  return study;
}

std::vector<std::string> values_of(const Study& study, std::size_t axis) {
  std::vector<std::string> values;
  for (const StudyPoint& point : study_points(study)) values.push_back(point.settings[axis].value);
  return values;
}

TEST(StudyPoints, AGridHasEveryCombination) {
  const Study study = with_axes({{.key = "target.radius", .from = 4, .to = 5, .steps = 3},
                                 {.key = "contact.friction", .values = {"0.2", "0.4"}}});
  EXPECT_EQ(values_of(study, 0), (std::vector<std::string>{"4", "4", "4.5", "4.5", "5", "5"}));
  EXPECT_EQ(values_of(study, 1), (std::vector<std::string>{"0.2", "0.4", "0.2", "0.4", "0.2", "0.4"}));
}

TEST(StudyPoints, AWholeNumberIsTakenOnce) {
  const Study study = with_axes({{.key = "pocket.mesh_rows", .from = 6, .to = 7, .steps = 3, .whole = true}});
  EXPECT_EQ(values_of(study, 0), (std::vector<std::string>{"6", "7"}));
}

TEST(StudyPoints, AStudyWithoutAxesHasItsPlaces) {
  Study study = with_axes({});
  EXPECT_EQ(study_points(study).size(), 1u);
  study.places = {{"a", {{"target.mass", "100"}}}, {"b", {}}};
  study.settings = {{"target.mass", "300"}};
  const auto points = study_points(study);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].place, "a");
  // The place's setting comes after that of all points and so counts.
  EXPECT_EQ(study_scenario(study, points[0], {}).scenario.target.mass, 100);
  EXPECT_EQ(study_scenario(study, points[1], {}).scenario.target.mass, 300);
}

// Draws repeat the first point with small displacements, each with a seed of its own.
TEST(StudyPoints, AnEnsembleFollowsThePoints) {
  Study study = with_axes({});
  study.places = {{"a", {{"target.mass", "100"}}}, {"b", {}}};
  study.ensemble = {.runs = 3, .perturbation = 1e-6};
  const auto points = study_points(study);
  ASSERT_EQ(points.size(), 5u);
  EXPECT_EQ(points[1].draw, 0);
  for (int draw = 1; draw <= 3; ++draw) {
    const StudyPoint& point = points[static_cast<std::size_t>(draw) + 1];
    EXPECT_EQ(point.draw, draw);
    EXPECT_EQ(point.place, "a");
    const Scenario scenario = study_scenario(study, point, {}).scenario;
    EXPECT_EQ(scenario.target.mass, 100);
    EXPECT_EQ(scenario.solver.perturbation, 1e-6);
    EXPECT_EQ(scenario.solver.seed, draw);
  }
}

TEST(StudyPoints, LogarithmicStepsHaveEqualRatios) {
  const Study study =
      with_axes({{.key = "rods.hinge_stiffness", .from = 1, .to = 1000, .steps = 4, .logarithmic = true}});
  EXPECT_EQ(values_of(study, 0), (std::vector<std::string>{"1", "10", "100", "1000"}));
}

// The first base^m points of a van der Corput sequence are k/base^m (Niederreiter 1992, section 3.1); a shift modulo 1
// keeps their distances.
TEST(StudyPoints, HaltonFillsEachAxisEvenly) {
  Study study = with_axes({{.key = "target.radius", .from = 0, .to = 16}, {.key = "target.mass", .from = 0, .to = 27}});
  study.sampling = Sampling::halton;
  for (const auto& [axis, samples] : {std::pair(0u, 16), {1u, 27}}) {
    study.samples = samples;
    std::vector<double> numbers;
    for (const std::string& text : values_of(study, axis)) numbers.push_back(std::stod(text));
    std::sort(numbers.begin(), numbers.end());
    for (std::size_t i = 1; i < numbers.size(); ++i) {
      EXPECT_NEAR(numbers[i] - numbers[i - 1], 1, 1e-9) << "axis " << axis;
    }
  }
}

TEST(StudyPoints, SeedsGiveDifferentSamplesAndTheSameOnesAgain) {
  Study study = with_axes({{.key = "target.radius", .from = 4, .to = 5}});
  study.sampling = Sampling::halton;
  study.samples = 3;
  const auto first = values_of(study, 0);
  EXPECT_EQ(values_of(study, 0), first);
  study.seed = 2;
  EXPECT_NE(values_of(study, 0), first);
}

TEST(StudyPoints, HaltonTakesListsAndWholeNumbersWithEqualShares) {
  Study study = with_axes({{.key = "target.shape", .values = {"\"box\"", "\"sphere\""}},
                           {.key = "pocket.mesh_rows", .from = 4, .to = 6, .whole = true}});
  study.sampling = Sampling::halton;
  study.samples = 54;
  const auto shapes = values_of(study, 0);
  EXPECT_NEAR(std::count(shapes.begin(), shapes.end(), "\"box\""), 27, 1);
  const auto rows = values_of(study, 1);
  for (const char* row : {"4", "5", "6"}) EXPECT_NEAR(std::count(rows.begin(), rows.end(), row), 18, 1) << row;
}

TEST(StudyPoints, AVariantGoesOnTopAndNamesTheRun) {
  const Study study = with_axes({{.key = "closing.duration", .values = {"9"}}});
  const auto made = study_scenario(study, study_points(study)[0], {"fast", {{"closing.duration", "5"}}});
  EXPECT_TRUE(made.diagnostics.ok()) << made.diagnostics.text();
  EXPECT_EQ(made.scenario.closing.duration, 5);
  EXPECT_EQ(made.scenario.name, "fast");
}

TEST(StudyPoints, SaysWhyAPointIsNotValid) {
  const Study study = with_axes({{.key = "target.radius", .values = {"7"}}});
  const auto made = study_scenario(study, study_points(study)[0], {});
  EXPECT_NE(made.diagnostics.text().find("the target starts inside"), std::string::npos) << made.diagnostics.text();
}

}  // namespace
}  // namespace netpocket
