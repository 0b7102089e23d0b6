#include "engine/statistics/kriging.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/sampling/design.h"
#include "engine/sampling/normal.h"
#include "engine/sampling/random.h"

namespace netpocket {
namespace {

Eigen::MatrixXd design_points(int count, int dimensions, std::uint64_t seed) {
  const Design design(DesignKind::sobol, dimensions, static_cast<std::uint64_t>(count), seed);
  Eigen::MatrixXd points(dimensions, count);
  for (Eigen::Index i = 0; i < count; ++i) points.col(i) = design.point(static_cast<std::uint64_t>(i));
  return points;
}

double unit_branin(const Eigen::Vector2d& u) {
  const double pi = std::numbers::pi, x = 15 * u[0] - 5, y = 15 * u[1];
  return std::pow(y - 5.1 / (4 * pi * pi) * x * x + 5 / pi * x - 6, 2) + 10 * (1 - 1 / (8 * pi)) * std::cos(x) + 10;
}

Eigen::VectorXd unit_branin_at(const Eigen::MatrixXd& points) {
  Eigen::VectorXd values(points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) values[i] = unit_branin(points.col(i));
  return values;
}

Eigen::MatrixXd without(const Eigen::MatrixXd& columns, Eigen::Index left_out) {
  Eigen::MatrixXd rest(columns.rows(), columns.cols() - 1);
  rest << columns.leftCols(left_out), columns.rightCols(columns.cols() - 1 - left_out);
  return rest;
}

// Two values: mean and prediction follow by hand. With r the correlation of the points, the mean is that of the values,
// and the prediction in the middle, where both correlations are c, as well.
TEST(Kriging, OfTwoPointsIsKnown) {
  Eigen::MatrixXd points(1, 2);
  points << 0, 1;
  const Kriging model(points, Eigen::Vector2d(1, 3), {Eigen::VectorXd::Constant(1, 0.5), 0});
  const auto matern = [](double d) {
    const double x = std::sqrt(5.0) * d;
    return (1 + x + x * x / 3) * std::exp(-x);
  };
  const double r = matern(2), c = matern(1);
  EXPECT_NEAR(model.mean(), 2, 1e-14);
  EXPECT_NEAR(model.process_variance(), 1 / (1 - r), 1e-14);
  const Prediction middle = model.predict(Eigen::VectorXd::Constant(1, 0.5));
  EXPECT_NEAR(middle.value, 2, 1e-14);
  const double share = 1 - 2 * c * c / (1 + r) + std::pow(1 - 2 * c / (1 + r), 2) * (1 + r) / 2;
  EXPECT_NEAR(middle.standard_error, std::sqrt(model.process_variance() * share), 1e-12);
}

TEST(Kriging, PassesThroughExactValues) {
  const Eigen::MatrixXd points = design_points(20, 2, 1);
  const Eigen::VectorXd values = unit_branin_at(points);
  const Kriging model(points, values, {Eigen::Vector2d(0.3, 0.5), 0});
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Prediction prediction = model.predict(points.col(i));
    EXPECT_NEAR(prediction.value, values[i], 1e-6);
    EXPECT_NEAR(prediction.standard_error, 0, 1e-3);
  }
}

// Dubrule's closed form against models that are made without the point.
TEST(Kriging, LeaveOneOutIsWhatItSays) {
  const Eigen::MatrixXd points = design_points(15, 2, 2);
  const Eigen::VectorXd values = unit_branin_at(points);
  const Kriging::Settings settings{Eigen::Vector2d(0.3, 0.5), 0.01};
  const Eigen::VectorXd errors = Kriging(points, values, settings).leave_one_out_errors();
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Kriging others(without(points, i), without(values.transpose(), i).transpose(), settings);
    EXPECT_NEAR(errors[i], values[i] - others.predict(points.col(i)).value, 1e-8) << i;
  }
}

TEST(Kriging, LearnsBranin) {
  const Eigen::MatrixXd points = design_points(40, 2, 3);
  const Kriging model(points, unit_branin_at(points));
  EXPECT_GT(model.leave_one_out_quality(), 0.98);
  const Eigen::MatrixXd fresh = design_points(200, 2, 99);
  const Eigen::VectorXd exact = unit_branin_at(fresh);
  double squares = 0, within = 0;
  for (Eigen::Index i = 0; i < fresh.cols(); ++i) {
    const Prediction prediction = model.predict(fresh.col(i));
    squares += std::pow(prediction.value - exact[i], 2) / 200;
    within += std::abs(prediction.value - exact[i]) < 2 * prediction.standard_error ? 1.0 / 200 : 0;
  }
  const double spread = (exact.array() - exact.mean()).square().mean();
  EXPECT_GT(1 - squares / spread, 0.98);
  EXPECT_GT(within, 0.85) << "the standard error is believable";
}

// The optimum of the likelihood, not just some settings.
TEST(Kriging, SettingsAreTheMostLikely) {
  const Eigen::MatrixXd points = design_points(25, 2, 4);
  const Eigen::VectorXd values = unit_branin_at(points);
  const Kriging model(points, values);
  for (const double factor : {0.8, 1.25}) {
    for (Eigen::Index input = 0; input < 2; ++input) {
      Kriging::Settings other = model.settings();
      other.lengths[input] = std::min(10.0, other.lengths[input] * factor);
      EXPECT_LE(Kriging(points, values, other).log_likelihood(), model.log_likelihood() + 1e-6);
    }
  }
  EXPECT_GT(model.log_likelihood(), Kriging(points, values, {Eigen::Vector2d(0.1, 0.1), 1e-8}).log_likelihood());
}

TEST(Kriging, FindsTheInputThatDoesNotMatter) {
  const Eigen::MatrixXd points = design_points(40, 3, 5);
  Eigen::VectorXd values(points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) values[i] = std::sin(6 * points(0, i)) + points(1, i);
  const Eigen::VectorXd lengths = Kriging(points, values).settings().lengths;
  EXPECT_GT(lengths[2], 5 * lengths[0]);
}

// A map of the probability of capture from captures and failures alone: 0 or 1, with the probability
// Phi((0.35 - r)/0.1) at the distance r from the middle.
TEST(Kriging, MapsAProbabilityFromYesAndNo) {
  const Eigen::MatrixXd points = design_points(300, 2, 6);
  const auto probability = [](const Eigen::Vector2d& u) {
    return normal_cumulative((0.35 - (u - Eigen::Vector2d(0.5, 0.5)).norm()) / 0.1);
  };
  Eigen::VectorXd captures(points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    captures[i] = random_fraction(1, static_cast<std::uint64_t>(i), 0) < probability(points.col(i)) ? 1 : 0;
  }
  const Kriging model(points, captures);
  EXPECT_GT(model.settings().noise, 0.01);
  const Eigen::MatrixXd fresh = design_points(200, 2, 77);
  double squares = 0;
  for (Eigen::Index i = 0; i < fresh.cols(); ++i) {
    squares += std::pow(model.predict(fresh.col(i)).value - probability(fresh.col(i)), 2) / 200;
  }
  EXPECT_LT(std::sqrt(squares), 0.1);
}

}  // namespace
}  // namespace netpocket
