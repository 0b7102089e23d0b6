// Scenarios that each parameter alone allows but that make no sense as a whole.

#include "engine/scenario/check_scenario.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "engine/scenario/pocket_outline.h"

namespace netpocket {
namespace {

std::string problems(const std::function<void(Scenario&)>& change) {
  Scenario scenario;
  change(scenario);
  return check_scenario(scenario).text();
}

// The only problem is with this key, and its message holds this text.
void expect_problem(const std::function<void(Scenario&)>& change, const std::string& key, const std::string& text) {
  Scenario scenario;
  change(scenario);
  const Diagnostics diagnostics = check_scenario(scenario);
  ASSERT_EQ(diagnostics.list().size(), 1u) << key << ":\n" << diagnostics.text();
  EXPECT_EQ(diagnostics.list()[0].key, key);
  EXPECT_NE(diagnostics.text().find(text), std::string::npos) << diagnostics.text();
}

TEST(CheckScenario, DefaultsPass) {
  EXPECT_EQ(problems([](Scenario&) {}), "");
}

TEST(CheckScenario, FindsValuesOutsideTheirLimits) {
  expect_problem([](Scenario& s) { s.net.diameter = -1; }, "net.diameter", "must be >=");
  expect_problem([](Scenario& s) { s.target.spin.y() = std::numeric_limits<double>::quiet_NaN(); }, "target.spin",
                 "finite");
  expect_problem([](Scenario& s) { s.pocket.rod_count = 2; }, "pocket.rod_count", "must be >= 3");
}

TEST(CheckScenario, RodProfileHasThreeRisingPoints) {
  expect_problem([](Scenario& s) { s.rods.profile.pop_back(); }, "rods.profile", "exactly three points");
  expect_problem([](Scenario& s) { s.rods.profile = {}; }, "rods.profile", "not 0");
  expect_problem([](Scenario& s) { s.rods.profile[1].y() = 12.5; }, "rods.profile", "must increase");
  expect_problem([](Scenario& s) { s.rods.profile[0].x() = 0; }, "rods.profile", "nearer than its diameter");
}

TEST(CheckScenario, NeighbouringRodsDoNotIntersect) {
  // Their axes are 2 r sin(pi/n) apart: 0.1 m, their diameter, at the root of n = 37.7 rods.
  expect_problem([](Scenario& s) { s.pocket.rod_count = 38; }, "rods.profile", "38 rods 0.6 m from the axis intersect");
  EXPECT_EQ(problems([](Scenario& s) {
              s.pocket.rod_count = 37;
              s.closing.closed_length = 0.5;
            }),
            "");
}

TEST(CheckScenario, WallsFitIntoTheRod) {
  expect_problem([](Scenario& s) { s.rods.wall_lower = 0.0501; }, "rods.wall_lower", "does not fit");
  expect_problem([](Scenario& s) { s.rods.wall_upper = 0.0501; }, "rods.wall_upper", "does not fit");
  EXPECT_EQ(problems([](Scenario& s) { s.rods.wall_lower = s.rods.wall_upper = 0.05; }), "") << "solid rods";
}

TEST(CheckScenario, InertiaObeysTheTriangleInequality) {
  expect_problem([](Scenario& s) { s.target.inertia = {1, 2, 3.1}; }, "target.inertia", "which no body has");
  expect_problem([](Scenario& s) { s.spacecraft.inertia = {5000, 1, 1}; }, "spacecraft.inertia", "which no body has");
  EXPECT_EQ(problems([](Scenario& s) { s.target.inertia = {0.1, 0.2, 0.1 + 0.2}; }), "") << "a thin plate";
}

TEST(CheckScenario, ClosedRopeIsShorterThanOpenAndLongerThanItsElements) {
  expect_problem([](Scenario& s) { s.closing.closed_length = 5.79; }, "closing.closed_length", "5.78617 m");
  expect_problem([](Scenario& s) { s.closing.closed_length = 0.007; }, "closing.closed_length", "at least 0.008 m");
  expect_problem([](Scenario& s) { s.closing.closed_length = 0; }, "closing.closed_length", "must be >=");
  expect_problem([](Scenario& s) { s.closing.duration = 0; }, "closing.duration", "must be >=");
}

TEST(CheckScenario, ClosingTableRunsForwardFromTheOpenMouth) {
  const auto table = [](std::vector<Eigen::Vector2d> rows) {
    return [rows](Scenario& s) {
      s.closing.law = ClosingLaw::table;
      s.closing.table = rows;
    };
  };
  EXPECT_EQ(problems(table({{0, 5.78}, {5, 4}, {10, 2.1}})), "");
  expect_problem(table({}), "closing.table", "at least two points");
  expect_problem(table({{0, 5.78}}), "closing.table", "at least two points");
  expect_problem(table({{1, 5.78}, {10, 2.1}}), "closing.table", "must start at time 0");
  expect_problem(table({{0, 5.5}, {10, 2.1}}), "closing.table", "between the open tips");
  expect_problem(table({{0, 5.78}, {5, 3}, {5, 2.1}}), "closing.table", "times must increase");
  EXPECT_EQ(problems(table({{0, 5.78}, {5, 3}, {7, 5.78}, {10, 2.1}})), "") << "paid out again";
  expect_problem(table({{0, 5.78}, {5, 3}, {7, 5.8}, {10, 2.1}}), "closing.table",
                 "row 3 asks for 5.8 m of rope, but only the 5.78617 m between the open tips can be paid out");
  expect_problem(table({{0, 5.78}, {5, 0}}), "closing.table", "at least 0.008 m");
}

TEST(CheckScenario, SizeIsBounded) {
  expect_problem(
      [](Scenario& s) {
        s.pocket.rod_count = 64;
        s.rods.profile[0].x() = 1.1;
        s.pocket.mesh_columns = s.pocket.mesh_rows = 100;
        s.pocket.elements_per_side = 20;
        s.net.diameter = 1e-4;
        s.closing.closed_length = 0.5;
      },
      "pocket", "2000000 are allowed");
  expect_problem([](Scenario& s) { s.output.frame_rate = 1e5; }, "output.frame_rate", "2e+06 frames");
  expect_problem([](Scenario& s) { s.solver.time_step = 0.05; }, "solver.time_step", "0.02 s between two frames");
  expect_problem([](Scenario& s) { s.pocket.mesh_columns = s.pocket.elements_per_side = 20, s.net.diameter = 0.05; },
                 "net.diameter", "shorter than the cord is thick");
}

TEST(CheckScenario, TargetStartsClearOfTheNet) {
  const auto starts_inside = "the target starts inside the net";
  // Distance from the sphere's centre to the lower panels: a plane through (0.6 c, 0), (4.8 c, 5.3), c = cos(22.5 deg).
  const double c = std::cos(M_PI / 8);
  const Eigen::Vector2d along = Eigen::Vector2d(4.2 * c, 5.3).normalized();
  const double clearance = std::abs(along.x() * 7.5 - along.y() * (0 - 0.6 * c));
  const double r = clearance - 0.002;  // less the cord's radius
  EXPECT_EQ(problems([&](Scenario& s) { s.target.radius = r - 1e-6; }), "");
  // The panels' sampled points miss the point of contact by at most half a cell, 0.1 m; the sphere's sagitta over that
  // distance is 0.1^2/(2 r) = 1.1 mm.
  expect_problem([&](Scenario& s) { s.target.radius = r + 1.5e-3; }, "target.position", starts_inside);
  expect_problem([](Scenario& s) { s.target.position.x() = 5; }, "target.position", starts_inside);
  EXPECT_EQ(problems([](Scenario& s) { s.target.position = {0, 20, 0}; }), "") << "before the mouth";
}

TEST(CheckScenario, ShapeAndAttitudeOfTheTargetCount) {
  const auto box = [](Eigen::Vector3d attitude) {
    return [attitude](Scenario& s) {
      s.target.shape = TargetShape::box;
      s.target.size = {10.4, 1, 1};
      s.target.attitude = attitude;
    };
  };
  // At its lower face, y = 7, the pocket measures 11.0 m between opposite rods, which stand on the x and z axes, and
  // 10.2 m between opposite panels; the box is 10.4 m long.
  EXPECT_EQ(problems(box({0, 0, 0})), "");
  EXPECT_EQ(problems(box({0, M_PI / 2, 0})), "");
  expect_problem(box({0, M_PI / 8, 0}), "target.position", "inside the net");
  const auto cylinder = [](double length, double radius) {
    return [=](Scenario& s) {
      s.target.shape = TargetShape::cylinder;
      s.target.length = length;
      s.target.radius = radius;
    };
  };
  EXPECT_EQ(problems(cylinder(6, 3.5)), "");
  expect_problem(cylinder(14, 1), "target.position", "inside the net");
  expect_problem(cylinder(1, 5.5), "target.position", "inside the net");
}

TEST(CheckScenario, SpacecraftStartsClearOfTargetAndNet) {
  const auto small_in_bus = [](Scenario& s) {
    s.target.radius = 0.02;
    s.target.position = {0.013, -1.007, 0.011};
  };
  expect_problem(small_in_bus, "target.position", "the target starts inside the spacecraft");
  EXPECT_NE(problems([](Scenario& s) {
              s.target.position = {0, 1, 0};
            }).find("inside the spacecraft"),
            std::string::npos);
  expect_problem([](Scenario& s) { s.spacecraft.position.y() = 0; }, "spacecraft.position", "reaches into the pocket");
}

TEST(Outline, ElementCountOfTheDefaultPocket) {
  // Per panel 6x6 squares: 7*6 + 6*7 sides, triangles 3*6*7/2 sides, and a rod of 12 sides; two elements each, two per
  // rope.
  EXPECT_EQ(largest_element_count(Scenario()), 8 * ((42 + 42 + 63 + 12) * 2 + 2));
}

TEST(Diagnostics, TextLeavesOutWhatDoesNotApply) {
  EXPECT_EQ((Diagnostic{"a.toml", 12, "net.diameter", "is wrong"}.text()), "a.toml:12: net.diameter: is wrong");
  EXPECT_EQ((Diagnostic{"", 0, "net.diameter", "is wrong"}.text()), "net.diameter: is wrong");
  EXPECT_EQ((Diagnostic{"a.toml", 0, "", "is missing"}.text()), "a.toml: is missing");
  Diagnostics diagnostics;
  EXPECT_EQ(diagnostics.text(), "");
  diagnostics.add({.message = "one"});
  diagnostics.add({.message = "two"});
  EXPECT_EQ(diagnostics.text(), "one\ntwo");
}

}  // namespace
}  // namespace netpocket
