// Screening and Sobol indices of functions whose effects are known.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/statistics/screening.h"
#include "engine/statistics/sobol_indices.h"

namespace netpocket {
namespace {

template <typename Function>
Eigen::VectorXd outputs_at(const Eigen::MatrixXd& points, const Function& function) {
  Eigen::VectorXd outputs(points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) outputs[i] = function(Eigen::VectorXd(points.col(i)));
  return outputs;
}

TEST(Screening, WalksChangeEachInputOnceByHalfTheCube) {
  const Eigen::MatrixXd points = screening_points(5, 7, 4, 3);
  ASSERT_EQ(points.cols(), 42);
  EXPECT_EQ(points.minCoeff(), 0.125);
  EXPECT_EQ(points.maxCoeff(), 0.875);
  for (Eigen::Index walk = 0; walk < 7; ++walk) {
    Eigen::VectorXd changes = Eigen::VectorXd::Zero(5);
    for (Eigen::Index i = 6 * walk; i < 6 * walk + 5; ++i) changes += (points.col(i + 1) - points.col(i)).cwiseAbs();
    EXPECT_EQ(changes, Eigen::VectorXd::Constant(5, 0.5));
  }
  EXPECT_EQ(screening_points(5, 9, 4, 3).leftCols(42), points) << "more walks keep the old ones";
  EXPECT_NE(screening_points(5, 7, 4, 4), points);
}

TEST(Screening, OfALinearFunctionGivesItsCoefficients) {
  const Eigen::Vector4d coefficients(3, -2, 0, 0.5);
  const Eigen::MatrixXd points = screening_points(4, 10, 6, 1);
  const auto effects =
      screening_effects(points, outputs_at(points, [&](const Eigen::VectorXd& u) { return 7 + coefficients.dot(u); }));
  for (Eigen::Index i = 0; i < 4; ++i) {
    const InputEffect& effect = effects[static_cast<std::size_t>(i)];
    EXPECT_EQ(effect.steps, 10);
    EXPECT_NEAR(effect.mean, coefficients[i], 1e-13);
    EXPECT_NEAR(effect.mean_absolute, std::abs(coefficients[i]), 1e-13);
    EXPECT_NEAR(effect.deviation, 0, 1e-13);
  }
}

// The effect of an input of x y is the other input, whose levels 1/8, 3/8, 5/8, 7/8 are equally likely: mean 1/2,
// deviation sqrt(5/64). An effect that changes its sign has a mean of 0.
TEST(Screening, ShowsInteractions) {
  const Eigen::MatrixXd points = screening_points(2, 4000, 4, 1);
  auto effects = screening_effects(points, outputs_at(points, [](const Eigen::VectorXd& u) { return u[0] * u[1]; }));
  EXPECT_NEAR(effects[0].mean, 0.5, 0.02);
  EXPECT_NEAR(effects[0].deviation, std::sqrt(5.0 / 64), 0.01);
  effects = screening_effects(points, outputs_at(points, [](const Eigen::VectorXd& u) { return u[0] * (u[1] - 0.5); }));
  EXPECT_NEAR(effects[0].mean, 0, 0.02);
  EXPECT_NEAR(effects[0].mean_absolute, 0.25, 0.01);
}

TEST(Screening, LeavesOutWhatFailed) {
  const Eigen::MatrixXd points = screening_points(2, 3, 4, 1);
  Eigen::VectorXd outputs = outputs_at(points, [](const Eigen::VectorXd& u) { return u[0]; });
  outputs[4] = std::numeric_limits<double>::quiet_NaN();  // the middle of the second walk
  const auto effects = screening_effects(points, outputs);
  EXPECT_EQ(effects[0].steps, 2);
  EXPECT_EQ(effects[1].steps, 2);
  EXPECT_NEAR(effects[0].mean, 1, 1e-13);
}

// Ishigami & Homma (1990), doi:10.1109/ISUMA.1990.151285, with a = 7 and b = 0.1.
double ishigami(const Eigen::VectorXd& u) {
  const Eigen::Array3d x = std::numbers::pi * (2 * u.array() - 1);
  return std::sin(x[0]) + 7 * std::pow(std::sin(x[1]), 2) + 0.1 * std::pow(x[2], 4) * std::sin(x[0]);
}

TEST(SobolIndices, OfIshigamisFunction) {
  const double pi4 = std::pow(std::numbers::pi, 4);
  const double v1 = 0.5 * std::pow(1 + 0.1 * pi4 / 5, 2), v2 = 49.0 / 8, v13 = 0.01 * pi4 * pi4 * (1.0 / 18 - 1.0 / 50);
  const double variance = v1 + v2 + v13;
  const double first[] = {v1 / variance, v2 / variance, 0};
  const double total[] = {(v1 + v13) / variance, v2 / variance, v13 / variance};
  const Eigen::MatrixXd points = variance_points(3, 4096, 5);
  ASSERT_EQ(points.cols(), 4096 * 5);
  const auto indices = sobol_indices(3, outputs_at(points, ishigami), 0.95, 200, 1);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(indices[i].first.value, first[i], 0.01) << i;
    EXPECT_NEAR(indices[i].total.value, total[i], 0.01) << i;
    EXPECT_TRUE(indices[i].first.interval.contains(first[i])) << i;
    EXPECT_TRUE(indices[i].total.interval.contains(total[i])) << i;
    EXPECT_LT(indices[i].first.interval.half_width(), 0.06) << i;
    EXPECT_GT(indices[i].first.interval.half_width(), 0.005) << i;
  }
}

TEST(SobolIndices, MoreBlocksKeepTheOldOnesAndFailuresAreLeftOut) {
  const Eigen::MatrixXd points = variance_points(3, 256, 5);
  EXPECT_EQ(variance_points(3, 512, 5).leftCols(points.cols()), points);
  Eigen::VectorXd outputs = outputs_at(points, ishigami);
  outputs[7] = std::numeric_limits<double>::quiet_NaN();
  const auto indices = sobol_indices(3, outputs, 0.95, 50, 1);
  EXPECT_NEAR(indices[1].total.value, 0.4424, 0.08);
}

TEST(SobolIndices, OfAConstantAreNotNumbers) {
  const auto indices = sobol_indices(2, Eigen::VectorXd::Constant(4 * 8, 3.0), 0.95, 10, 1);
  EXPECT_TRUE(std::isnan(indices[0].first.value));
}

}  // namespace
}  // namespace netpocket
