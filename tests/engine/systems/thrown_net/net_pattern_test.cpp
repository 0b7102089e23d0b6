// Nets of every shape against what geometry says of them.

#include "engine/systems/thrown_net/net_pattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>

namespace netpocket {
namespace {

struct Case {
  NetShape shape;
  int cells, spokes;
  std::string name;
};

class EveryNet : public ::testing::TestWithParam<Case> {
 protected:
  NetPattern net() const { return net_pattern(GetParam().shape, kSize, GetParam().cells, GetParam().spokes); }
  static constexpr double kSize = 3;
};

double turned_area(const NetPattern& net, const std::array<std::int32_t, 3>& triangle) {
  const Eigen::Vector2d a = net.knots[triangle[0]], b = net.knots[triangle[1]], c = net.knots[triangle[2]];
  return 0.5 * ((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x());
}

TEST_P(EveryNet, TrianglesCoverItOnceAndTurnTheSameWay) {
  const NetPattern flat = net();
  double sum = 0;
  for (const auto& triangle : flat.triangles) {
    const double area = turned_area(flat, triangle);
    EXPECT_GT(area, 0);
    sum += area;
  }
  EXPECT_NEAR(sum, flat.area, 1e-12 * flat.area);
}

TEST_P(EveryNet, PerimeterEnclosesItsArea) {
  const NetPattern flat = net();
  double sum = 0;
  for (std::size_t i = 0; i < flat.perimeter.size(); ++i) {
    const Eigen::Vector2d a = flat.knots[flat.perimeter[i]];
    const Eigen::Vector2d b = flat.knots[flat.perimeter[(i + 1) % flat.perimeter.size()]];
    sum += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  EXPECT_NEAR(std::abs(sum), flat.area, 1e-12 * flat.area);
  for (const std::int32_t corner : flat.corners) EXPECT_EQ(std::ranges::count(flat.perimeter, corner), 1);
}

TEST_P(EveryNet, CordsAreStraightAndAsLongAsTheySay) {
  const NetPattern flat = net();
  for (const NetCord& cord : flat.cords) {
    const Eigen::Vector2d begin = flat.knots[cord.knots.front()], end = flat.knots[cord.knots.back()];
    EXPECT_NEAR((end - begin).norm(), cord.length, 1e-12) << cord.name;
    for (std::size_t i = 0; i < cord.knots.size(); ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(cord.knots.size() - 1);
      EXPECT_LT((flat.knots[cord.knots[i]] - ((1 - part) * begin + part * end)).norm(), 1e-12) << cord.name;
    }
  }
}

// Each side of a triangle that a cord should run along has one, and no two cords run along the same.
TEST_P(EveryNet, EveryKnotIsTied) {
  const NetPattern flat = net();
  std::set<std::pair<std::int32_t, std::int32_t>> ties;
  std::map<std::int32_t, int> at_knot;
  for (const NetCord& cord : flat.cords) {
    for (std::size_t i = 0; i + 1 < cord.knots.size(); ++i) {
      EXPECT_TRUE(ties.insert(std::minmax(cord.knots[i], cord.knots[i + 1])).second) << cord.name;
      ++at_knot[cord.knots[i]];
      ++at_knot[cord.knots[i + 1]];
    }
  }
  for (std::size_t knot = 0; knot < flat.knots.size(); ++knot) EXPECT_GE(at_knot[static_cast<int>(knot)], 2) << knot;
}

TEST_P(EveryNet, SidesRunRoundIt) {
  const NetPattern flat = net();
  double sides = 0, round = 0;
  int count = 0;
  for (const NetCord& cord : flat.cords) {
    if (!cord.is_side) continue;
    sides += cord.length;
    ++count;
  }
  for (std::size_t i = 0; i < flat.perimeter.size(); ++i) {
    round += (flat.knots[flat.perimeter[i]] - flat.knots[flat.perimeter[(i + 1) % flat.perimeter.size()]]).norm();
  }
  EXPECT_NEAR(sides, round, 1e-12);
  EXPECT_EQ(count, static_cast<int>(flat.corners.size()));
}

INSTANTIATE_TEST_SUITE_P(
    Nets, EveryNet,
    ::testing::Values(Case{NetShape::square, 1, 8, "square_1"}, Case{NetShape::square, 4, 8, "square_4"},
                      Case{NetShape::hexagonal, 1, 8, "hexagonal_1"}, Case{NetShape::hexagonal, 5, 8, "hexagonal_5"},
                      Case{NetShape::radial, 1, 3, "radial_1_3"}, Case{NetShape::radial, 6, 8, "radial_6_8"}),
    [](const auto& info) { return info.param.name; });

// A hexagon of n meshes a side has 3 n (n + 1) + 1 knots, 9 n^2 + 3 n mesh sides and 6 n^2 triangles.
TEST(NetPattern, CountsOfAHexagon) {
  const NetPattern net = net_pattern(NetShape::hexagonal, 2, 4, 8);
  std::size_t mesh_sides = 0;
  for (const NetCord& cord : net.cords) mesh_sides += cord.knots.size() - 1;
  EXPECT_EQ(net.knots.size(), 61u);
  EXPECT_EQ(mesh_sides, 156u);
  EXPECT_EQ(net.triangles.size(), 96u);
  EXPECT_NEAR(net.area, 1.5 * std::sqrt(3.0) * 4, 1e-12);
  EXPECT_EQ(net.knots[static_cast<std::size_t>(net.middle)], Eigen::Vector2d::Zero());
}

TEST(NetPattern, RadialNetTendsToACircle) {
  EXPECT_NEAR(net_pattern(NetShape::radial, 1, 3, 64).area, std::numbers::pi, 6e-3);
}

}  // namespace
}  // namespace netpocket
