// Polygons as triangles: their area, and that no triangle leaves the polygon.

#include "engine/bodies/polygon.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

namespace netpocket {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// In a slanted plane far from the origin.
std::vector<Vector3d> in_space(const std::vector<Vector2d>& outline) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  std::vector<Vector3d> corners;
  for (const Vector2d& p : outline) corners.push_back(turn * Vector3d(p.x(), p.y(), 0) + Vector3d(40, -30, 20));
  return corners;
}

double twice_area(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

bool is_inside(const std::vector<Vector2d>& outline, const Vector2d& point) {
  bool inside = false;
  for (std::size_t i = 0, k = outline.size() - 1; i < outline.size(); k = i++) {
    const Vector2d &a = outline[i], &b = outline[k];
    if ((a.y() > point.y()) != (b.y() > point.y()) &&
        point.x() < (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()) + a.x()) {
      inside = !inside;
    }
  }
  return inside;
}

// All triangles run as the polygon does, lie in it, and have its area together.
void expect_cover(const std::vector<Vector2d>& outline) {
  const auto result = triangulate(in_space(outline));
  ASSERT_TRUE(std::holds_alternative<CornerTriples>(result)) << std::get<std::string>(result);
  const auto& triangles = std::get<CornerTriples>(result);
  EXPECT_EQ(triangles.size(), outline.size() - 2);
  double area = 0, expected = 0;
  for (std::size_t i = 0; i < outline.size(); ++i)
    expected += twice_area(Vector2d::Zero(), outline[i], outline[(i + 1) % outline.size()]);
  for (const auto& [a, b, c] : triangles) {
    const double part = twice_area(outline[a], outline[b], outline[c]);
    EXPECT_GE(part, -1e-9);
    if (part > 1e-9) {
      EXPECT_TRUE(is_inside(outline, (outline[a] + outline[b] + outline[c]) / 3));
    }
    area += part;
  }
  EXPECT_NEAR(area, expected, 1e-9 * expected);
}

TEST(Polygon, Shapes) {
  expect_cover({{0, 0}, {1, 0}, {0, 1}});
  expect_cover({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}});                          // a notch
  expect_cover({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}});  // a U
  expect_cover({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}});                  // corners on straight sides
  expect_cover({{0, 0}, {2, -1}, {1, 0}, {2, 1}});                                 // an arrow
  // A square with a square hole, bridged from corner to corner.
  expect_cover({{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}});
}

TEST(Polygon, StarsOfAnyOutline) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> radius(0.2, 3);
  for (int trial = 0; trial < 200; ++trial) {
    const int count = 4 + trial % 40;
    std::vector<Vector2d> outline;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      outline.emplace_back(radius(random) * Vector2d(std::cos(angle), std::sin(angle)));
    }
    expect_cover(outline);
  }
}

TEST(Polygon, ConvexOnesAreFans) {
  const auto result = triangulate(in_space({{1, 0}, {0.3, 1}, {-0.8, 0.6}, {-0.8, -0.6}, {0.3, -1}}));
  const CornerTriples expected = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
  EXPECT_EQ(std::get<CornerTriples>(result), expected);
}

TEST(Polygon, WhatIsNoneHasItsSentence) {
  const auto problem = [](const std::vector<Vector3d>& corners) {
    const auto result = triangulate(corners);
    const auto* text = std::get_if<std::string>(&result);
    return text ? *text : "";
  };
  EXPECT_EQ(problem({{0, 0, 0}, {1, 0, 0}}), "a face has fewer than three corners");
  EXPECT_TRUE(problem({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}}).starts_with("a face is not plane: "));
  EXPECT_EQ(problem(in_space({{0, 0}, {4, 0}, {0, 2}, {4, 3}})), "a face crosses itself");
  EXPECT_EQ(problem(std::vector<Vector3d>(kMostPolygonCorners + 1)), "a face has 4097 corners; 4096 are allowed");
  EXPECT_EQ(problem({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}), "");  // a line: left to those who join triangles
}

}  // namespace
}  // namespace netpocket
