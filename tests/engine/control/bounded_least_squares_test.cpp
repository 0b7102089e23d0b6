// Least squares with bounds: hand-computed cases, and the conditions of optimality in random ones.

#include "engine/control/bounded_least_squares.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/control/random_numbers.h"

namespace netpocket {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double kFar = 1e6;

MatrixXd matrix(int rows, int columns, const std::vector<double>& by_row) {
  return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(by_row.data(), rows,
                                                                                                  columns);
}

VectorXd not_negative(const MatrixXd& a, const VectorXd& b, double most = kFar) {
  return bounded_least_squares(a, b, VectorXd::Zero(a.cols()), VectorXd::Constant(a.cols(), most));
}

void expect_solution(const VectorXd& x, const std::vector<double>& expected) {
  ASSERT_EQ(x.size(), static_cast<Eigen::Index>(expected.size()));
  for (Eigen::Index i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], expected[i], 1e-7) << i;
}

// By hand. The columns (2, 1) and (1, 2) give (-1/3, 5/3) for (1, 3); without the first x2 = (1 + 6)/5.
TEST(BoundedLeastSquares, SolvesHandComputedCases) {
  const MatrixXd a = matrix(2, 2, {2, 1, 1, 2});
  expect_solution(not_negative(a, Vector2d(4, 5)), {1, 2});
  expect_solution(not_negative(a, Vector2d(1, 3)), {0, 1.4});
  expect_solution(not_negative(a, Vector2d(-1, -1)), {0, 0});
  // x1 at its limit 0.5: x2 = ((4 - 1) + 2 (5 - 0.5))/5 = 2.4, beyond 0.5 as well.
  expect_solution(not_negative(a, Vector2d(4, 5), 0.5), {0.5, 0.5});
  // Negative lower bounds: the unbounded solution.
  expect_solution(bounded_least_squares(a, Vector2d(1, 3), Vector2d(-1, -1), Vector2d(9, 9)), {-1.0 / 3, 5.0 / 3});
}

// Four thrusters, two each way: the pairs share the load, which is the shortest of all solutions.
TEST(BoundedLeastSquares, SharesTheLoadEvenly) {
  expect_solution(not_negative(matrix(1, 4, {1, -1, 1, -1}), VectorXd::Constant(1, 3)), {1.5, 0, 1.5, 0});
  expect_solution(not_negative(matrix(1, 4, {1, -1, 1, -1}), VectorXd::Constant(1, -3), 1), {0, 1, 0, 1});
}

// Kuhn & Tucker: no slope inside, slopes outwards at the bounds.
TEST(BoundedLeastSquares, MeetsTheConditionsOfOptimality) {
  RandomNumbers random(2);
  int at_lower = 0, at_upper = 0, inside = 0;
  for (int round = 0; round < 300; ++round) {
    const int columns = 1 + static_cast<int>(20 * random.uniform());
    MatrixXd a(6, columns);
    for (double& element : a.reshaped()) element = random.normal();
    VectorXd b(6), lower(columns), upper(columns);
    for (double& element : b) element = 3 * random.normal();
    for (int i = 0; i < columns; ++i) {
      lower[i] = random.uniform() < 0.5 ? 0 : -random.uniform();
      upper[i] = random.uniform();
    }
    const VectorXd x = bounded_least_squares(a, b, lower, upper);
    const double added = 1e-8 * a.colwise().squaredNorm().maxCoeff();
    const VectorXd slope = a.transpose() * (a * x - b) + added * x;
    const double round_off = 1e-11 * (a.transpose() * b).cwiseAbs().maxCoeff();
    for (int i = 0; i < columns; ++i) {
      ASSERT_GE(x[i], lower[i]);
      ASSERT_LE(x[i], upper[i]);
      EXPECT_TRUE(x[i] == lower[i] || slope[i] < round_off) << round;
      EXPECT_TRUE(x[i] == upper[i] || slope[i] > -round_off) << round;
      ++(x[i] == lower[i] ? at_lower : x[i] == upper[i] ? at_upper : inside);
    }
  }
  EXPECT_GT(std::min({at_lower, at_upper, inside}), 300);
}

}  // namespace
}  // namespace netpocket
