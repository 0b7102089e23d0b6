#include "render/figures/polyline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace netpocket {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

TEST(MapCurve, SplitsAtValuesThatAreNotFinite) {
  const PaperMap map{10, 2, 100, -1};
  const std::vector<Polyline> lines = map_curve({0, 1, 2, 3, 4}, {0, 5, kMissing, 7, INFINITY}, map);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0], (Polyline{{10, 100}, {12, 95}}));
  EXPECT_EQ(lines[1], (Polyline{{16, 93}}));
}

TEST(Decimate, KeepsFirstLowestHighestLastOfAColumnInOrder) {
  const Polyline line = {{0.0, 1}, {0.1, 9}, {0.2, 4}, {0.3, -5}, {0.4, 2}, {0.5, 3}, {1.5, 0}};
  EXPECT_EQ(decimate(line, 1), (Polyline{{0.0, 1}, {0.1, 9}, {0.3, -5}, {0.5, 3}, {1.5, 0}}));
}

TEST(Decimate, LosesNoSpikeOfALongCurve) {
  Polyline line;
  for (int i = 0; i < 100000; ++i) line.push_back({i * 0.01, std::sin(0.001 * i)});
  line[54321].y = 77;
  const Polyline kept = decimate(line, 1);
  EXPECT_LE(kept.size(), 4u * 1000u);
  bool found = false;
  for (const Point& point : kept) found = found || point.y == 77;
  EXPECT_TRUE(found);
}

TEST(Decimate, LeavesSparseCurvesAlone) {
  const Polyline line = {{0, 1}, {1.2, 5}, {2.4, 2}};
  EXPECT_EQ(decimate(line, 1), line);
}

TEST(LengthInside, ClipsAtTheBox) {
  const PlotBox box{0, 0, 10, 10};
  EXPECT_DOUBLE_EQ(length_inside({{-5, 5}, {15, 5}}, box), 10);
  EXPECT_DOUBLE_EQ(length_inside({{2, 2}, {5, 6}}, box), 5);
  EXPECT_DOUBLE_EQ(length_inside({{-5, 12}, {15, 12}}, box), 0);
  EXPECT_DOUBLE_EQ(length_inside({{-1, 9.5}, {5, 24.5}}, box), 0);
}

}  // namespace
}  // namespace netpocket
