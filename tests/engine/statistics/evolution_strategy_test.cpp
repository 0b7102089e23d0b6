// CMA-ES on the usual functions, with fixed seeds and budgets.

#include "engine/statistics/evolution_strategy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace netpocket {
namespace {

template <typename Function>
BatchFunction each(const Function& function) {
  return [function](const Eigen::MatrixXd& points) {
    Eigen::VectorXd values(points.cols());
    for (Eigen::Index i = 0; i < points.cols(); ++i) values[i] = function(Eigen::VectorXd(points.col(i)));
    return values;
  };
}

MinimisationOptions within(int dimensions, double lower, double upper) {
  MinimisationOptions options;
  options.lower = Eigen::VectorXd::Constant(dimensions, lower);
  options.upper = Eigen::VectorXd::Constant(dimensions, upper);
  return options;
}

double sphere(const Eigen::VectorXd& x) { return (x.array() - 0.3).square().sum(); }

double rosenbrock(const Eigen::VectorXd& x) {
  double sum = 0;
  for (Eigen::Index i = 0; i + 1 < x.size(); ++i) {
    sum += 100 * std::pow(x[i + 1] - x[i] * x[i], 2) + std::pow(1 - x[i], 2);
  }
  return sum;
}

double rastrigin(const Eigen::VectorXd& x) {
  return (x.array().square() - 10 * (2 * std::numbers::pi * x.array()).cos() + 10).sum();
}

double branin(const Eigen::VectorXd& x) {
  const double pi = std::numbers::pi;
  const double valley = x[1] - 5.1 / (4 * pi * pi) * x[0] * x[0] + 5 / pi * x[0] - 6;
  return valley * valley + 10 * (1 - 1 / (8 * pi)) * std::cos(x[0]) + 10;
}

TEST(EvolutionStrategy, MinimisesASphere) {
  MinimisationOptions options = within(10, -5, 5);
  options.target = 1e-10;
  options.most_evaluations = 4000;
  const Minimum minimum = minimise(each(sphere), options);
  EXPECT_TRUE(minimum.has_reached_target) << minimum.value;
  EXPECT_LT((minimum.point.array() - 0.3).abs().maxCoeff(), 1e-4);
}

TEST(EvolutionStrategy, FollowsRosenbrocksValley) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    MinimisationOptions options = within(5, -3, 3);
    options.target = 1e-10;
    options.most_evaluations = 20000;
    options.seed = seed;
    EXPECT_TRUE(minimise(each(rosenbrock), options).has_reached_target) << seed;
  }
}

TEST(EvolutionStrategy, LeavesRastriginsLocalMinimaByRestarts) {
  MinimisationOptions options = within(5, -5.12, 5.12);
  options.target = 1e-8;
  options.most_evaluations = 60000;
  const Minimum minimum = minimise(each(rastrigin), options);
  EXPECT_TRUE(minimum.has_reached_target) << minimum.value;
  EXPECT_GT(minimum.restarts, 0);
}

// Dixon & Szego (1978): 0.397887 at three points.
TEST(EvolutionStrategy, FindsBraninsMinimum) {
  MinimisationOptions options = within(2, -5, 10);
  options.lower[1] = 0;
  options.upper[1] = 15;
  options.most_evaluations = 1500;
  EXPECT_NEAR(minimise(each(branin), options).value, 0.397887, 1e-6);
}

TEST(EvolutionStrategy, KeepsTheBoundsAndFindsMinimaOnThem) {
  const auto slope = [](const Eigen::VectorXd& x) {
    EXPECT_GE(x.minCoeff(), -1);
    EXPECT_LE(x.maxCoeff(), 2);
    return 3 * x[0] - x[1] + x[2] * x[2];
  };
  MinimisationOptions options = within(3, -1, 2);
  options.most_evaluations = 5000;
  const Minimum minimum = minimise(each(slope), options);
  EXPECT_NEAR(minimum.value, -5, 1e-6);
}

TEST(EvolutionStrategy, DoesTheSameAgainAndKeepsItsBudget) {
  MinimisationOptions options = within(4, -1, 1);
  options.most_evaluations = 100;
  options.seed = 8;
  const Minimum once = minimise(each(rosenbrock), options), again = minimise(each(rosenbrock), options);
  EXPECT_EQ(once.point, again.point);
  EXPECT_EQ(once.evaluations, 104);  // 13 generations of 8
  options.seed = 9;
  EXPECT_NE(minimise(each(rosenbrock), options).point, once.point);
}

TEST(EvolutionStrategy, BeginsWhereItIsTold) {
  MinimisationOptions options = within(2, 0, 100);
  options.start = Eigen::Vector2d(20, 80);
  options.step = 1e-3;
  options.most_evaluations = 6;
  const Minimum minimum = minimise(each(sphere), options);
  EXPECT_NEAR(minimum.point[0], 20, 0.5);
  EXPECT_NEAR(minimum.point[1], 80, 0.5);
}

TEST(EvolutionStrategy, GoesRoundFailures) {
  const auto function = [](const Eigen::VectorXd& x) { return x[0] < 0.2 ? std::nan("") : sphere(x); };
  MinimisationOptions options = within(2, -1, 1);
  options.most_evaluations = 2000;
  EXPECT_NEAR(minimise(each(function), options).value, 0, 1e-10);
}

}  // namespace
}  // namespace netpocket
