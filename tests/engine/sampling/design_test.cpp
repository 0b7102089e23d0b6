#include "engine/sampling/design.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "engine/sampling/halton_sequence.h"
#include "engine/sampling/sobol_sequence.h"

namespace netpocket {
namespace {

constexpr DesignKind kKinds[] = {DesignKind::monte_carlo, DesignKind::latin_hypercube, DesignKind::sobol,
                                 DesignKind::halton};

TEST(Design, PointsLieWithinTheCube) {
  for (const DesignKind kind : kKinds) {
    const Design design(kind, kMostDimensions, 50, 1);
    for (std::uint64_t i = 0; i < design.count(); ++i) {
      EXPECT_GT(design.point(i).minCoeff(), 0);
      EXPECT_LT(design.point(i).maxCoeff(), 1);
    }
  }
}

TEST(Design, MorePointsKeepTheOldOnes) {
  for (const DesignKind kind : {DesignKind::monte_carlo, DesignKind::sobol, DesignKind::halton}) {
    const Design few(kind, 5, 100, 9), many(kind, 5, 100000, 9);
    for (std::uint64_t i = 0; i < few.count(); ++i) EXPECT_EQ(few.point(i), many.point(i));
  }
}

TEST(Design, SeedsGiveDifferentPointsAndTheSameOnesAgain) {
  for (const DesignKind kind : kKinds) {
    EXPECT_EQ(Design(kind, 3, 100, 5).point(42), Design(kind, 3, 100, 5).point(42));
    EXPECT_NE(Design(kind, 3, 100, 5).point(42), Design(kind, 3, 100, 6).point(42));
  }
}

// Whether the points fill each cell of a grid with these numbers of cells in the first coordinates exactly once.
bool fills_each_cell_once(const Design& design, const std::vector<int>& cells, const std::vector<int>& axes) {
  std::set<std::vector<int>> filled;
  for (std::uint64_t i = 0; i < design.count(); ++i) {
    std::vector<int> cell;
    for (std::size_t a = 0; a < axes.size(); ++a) {
      cell.push_back(static_cast<int>(std::floor(design.point(i)[axes[a]] * cells[a])));
    }
    filled.insert(cell);
  }
  return filled.size() == design.count();
}

TEST(LatinHypercube, HasOnePointInEachStratum) {
  const Design design(DesignKind::latin_hypercube, 6, 37, 4);
  for (int axis = 0; axis < 6; ++axis) EXPECT_TRUE(fills_each_cell_once(design, {37}, {axis})) << axis;
}

TEST(LatinHypercube, CoordinatesAreNotCorrelated) {
  const Design design(DesignKind::latin_hypercube, 2, 10000, 4);
  double sum = 0;
  for (std::uint64_t i = 0; i < design.count(); ++i) {
    const Eigen::VectorXd point = design.point(i);
    sum += 12 * (point[0] - 0.5) * (point[1] - 0.5) / static_cast<double>(design.count());
  }
  EXPECT_NEAR(sum, 0, 4 / std::sqrt(1e4));
}

// The first points in three dimensions as Joe & Kuo publish them with their direction numbers.
TEST(Sobol, BeginsWithThePublishedPoints) {
  const double published[10][3] = {{0, 0, 0},
                                   {0.5, 0.5, 0.5},
                                   {0.75, 0.25, 0.25},
                                   {0.25, 0.75, 0.75},
                                   {0.375, 0.375, 0.625},
                                   {0.875, 0.875, 0.125},
                                   {0.625, 0.125, 0.875},
                                   {0.125, 0.625, 0.375},
                                   {0.1875, 0.3125, 0.9375},
                                   {0.6875, 0.8125, 0.4375}};
  for (std::uint64_t i = 0; i < 10; ++i) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(sobol(i, axis), published[i][axis]) << i << ", " << axis;
  }
}

TEST(Sobol, WalkGivesTheSamePoints) {
  SobolWalk walk(kMostDimensions);
  for (std::uint64_t i = 0; i < 3000; ++i, walk.next()) {
    for (int axis = 0; axis < kMostDimensions; ++axis) ASSERT_EQ(walk[axis], sobol(i, axis)) << i << ", " << axis;
  }
}

// The first two coordinates are a (0, 2)-sequence in base 2 (Niederreiter 1992, section 4.2), and every coordinate a
// (0, 1)-sequence. Nested scrambling keeps that.
TEST(ScrambledSobol, FillsElementaryIntervals) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const Design design(DesignKind::sobol, kMostDimensions, 64, seed);
    for (const auto& cells : {std::vector{8, 8}, {2, 32}, {32, 2}, {4, 16}}) {
      EXPECT_TRUE(fills_each_cell_once(design, cells, {0, 1}));
    }
    for (int axis = 0; axis < kMostDimensions; ++axis) EXPECT_TRUE(fills_each_cell_once(design, {64}, {axis})) << axis;
  }
}

// The mean of (4 |x - 1/2|) (4 |y - 1/2|) is 1; the variance of a draw is 7/9.
double error_of_mean(DesignKind kind, std::uint64_t seed) {
  const Design design(kind, 2, 4096, seed);
  double sum = 0;
  for (std::uint64_t i = 0; i < design.count(); ++i) {
    const Eigen::VectorXd point = design.point(i);
    sum += 16 * std::abs(point[0] - 0.5) * std::abs(point[1] - 0.5);
  }
  return sum / static_cast<double>(design.count()) - 1;
}

TEST(Design, EvenOnesIntegrateBetterThanChance) {
  const double chance = std::sqrt(7.0 / 9 / 4096);  // standard error of Monte Carlo
  double monte_carlo = 0, scrambled_sobol = 0, halton = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    monte_carlo += std::pow(error_of_mean(DesignKind::monte_carlo, seed), 2) / 20;
    scrambled_sobol += std::pow(error_of_mean(DesignKind::sobol, seed), 2) / 20;
    halton += std::pow(error_of_mean(DesignKind::halton, seed), 2) / 20;
  }
  // 20 squares of a normal number have a mean between 0.3 and 2.3 with a probability of 0.999.
  EXPECT_GT(std::sqrt(monte_carlo), std::sqrt(0.3) * chance);
  EXPECT_LT(std::sqrt(monte_carlo), std::sqrt(2.3) * chance);
  EXPECT_LT(std::sqrt(scrambled_sobol), chance / 50);
  EXPECT_LT(std::sqrt(halton), chance / 5);
}

TEST(Halton, MirrorsDigits) {
  EXPECT_EQ(radical_inverse(0, 2), 0);
  EXPECT_EQ(radical_inverse(6, 2), 0.375);           // 110 -> 0.011
  EXPECT_DOUBLE_EQ(radical_inverse(5, 3), 7.0 / 9);  // 12 -> 0.21
  EXPECT_EQ(prime(0), 2u);
  EXPECT_EQ(prime(11), 37u);
  EXPECT_EQ(prime(kMostDimensions - 1), 311u);
}

TEST(Grid, HasEveryCombinationOnce) {
  EXPECT_EQ(grid_size({2, 3}), 6u);
  EXPECT_EQ(grid_point({2, 3}, 0), Eigen::Vector2d(0.25, 1.0 / 6));
  EXPECT_EQ(grid_point({2, 3}, 1), Eigen::Vector2d(0.25, 0.5));
  EXPECT_EQ(grid_point({2, 3}, 5), Eigen::Vector2d(0.75, 2.5 / 3));
}

}  // namespace
}  // namespace netpocket
