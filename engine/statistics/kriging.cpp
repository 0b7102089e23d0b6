#include "engine/statistics/kriging.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/statistics/evolution_strategy.h"

namespace netpocket {
namespace {

constexpr double kLeastLength = 0.02, kLargestLength = 10;
constexpr double kLeastNoise = 1e-8, kLargestNoise = 10;

// Matern covariance of smoothness 5/2 by that at zero distance: Rasmussen & Williams (2006), eq. 4.17.
double matern(double distance) {
  const double x = std::sqrt(5.0) * distance;
  return (1 + x + x * x / 3) * std::exp(-x);
}

// Correlation of a point, in units of the lengths, with others, one column each.
Eigen::VectorXd correlation_with(const Eigen::MatrixXd& scaled, const Eigen::VectorXd& point) {
  return (scaled.colwise() - point).colwise().norm().transpose().unaryExpr(&matern);
}

Eigen::MatrixXd correlation_matrix(const Eigen::MatrixXd& points, const Kriging::Settings& settings) {
  const Eigen::MatrixXd scaled = settings.lengths.cwiseInverse().asDiagonal() * points;
  Eigen::MatrixXd correlation(points.cols(), points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) correlation.col(i) = correlation_with(scaled, scaled.col(i));
  correlation.diagonal().array() += settings.noise;
  return correlation;
}

// Settings as logarithms, in which the search is even.
Kriging::Settings settings_of(const Eigen::VectorXd& logarithms) {
  const Eigen::Index inputs = logarithms.size() - 1;
  return {logarithms.head(inputs).array().exp(), std::exp(logarithms[inputs])};
}

Kriging::Settings most_likely_settings(const Eigen::MatrixXd& points, const Eigen::VectorXd& values,
                                       std::uint64_t seed) {
  const Eigen::Index inputs = points.rows();
  MinimisationOptions options;
  options.lower = Eigen::VectorXd::Constant(inputs + 1, std::log(kLeastLength));
  options.upper = Eigen::VectorXd::Constant(inputs + 1, std::log(kLargestLength));
  options.lower[inputs] = std::log(kLeastNoise);
  options.upper[inputs] = std::log(kLargestNoise);
  options.most_evaluations = 150 * static_cast<int>(inputs + 1);
  options.most_restarts = 2;
  options.least_step = 1e-4;
  options.seed = seed;
  const auto negative_likelihood = [&](const Eigen::MatrixXd& candidates) {
    Eigen::VectorXd results(candidates.cols());
    for (Eigen::Index i = 0; i < candidates.cols(); ++i) {
      results[i] = -Kriging(points, values, settings_of(candidates.col(i))).log_likelihood();
    }
    return results;
  };
  return settings_of(minimise(negative_likelihood, options).point);
}

}  // namespace

Kriging::Kriging(const Eigen::MatrixXd& points, const Eigen::VectorXd& values, std::uint64_t seed)
    : Kriging(points, values, most_likely_settings(points, values, seed)) {}

Kriging::Kriging(const Eigen::MatrixXd& points, const Eigen::VectorXd& values, const Settings& settings)
    : points_(points), values_(values), settings_(settings) {
  fit();
}

void Kriging::fit() {
  const auto count = static_cast<double>(values_.size());
  factor_.compute(correlation_matrix(points_, settings_));
  log_likelihood_ = -std::numeric_limits<double>::infinity();
  if (factor_.info() != Eigen::Success) return;
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(values_.size());
  ones_solved_ = factor_.solve(ones);
  mean_ = ones_solved_.dot(values_) / ones_solved_.sum();
  const Eigen::VectorXd rest = values_.array() - mean_;
  rest_solved_ = factor_.solve(rest);
  variance_ = rest.dot(rest_solved_) / count;
  // Values that are all alike have any likelihood.
  const double log_variance = std::log(std::max(variance_, std::numeric_limits<double>::min()));
  const double log_determinant = 2 * factor_.matrixLLT().diagonal().array().log().sum();
  log_likelihood_ = -(count * (std::log(2 * std::numbers::pi) + log_variance + 1) + log_determinant) / 2;
}

Prediction Kriging::predict(const Eigen::VectorXd& point) const {
  const Eigen::VectorXd scale = settings_.lengths.cwiseInverse();
  const Eigen::VectorXd correlation = correlation_with(scale.asDiagonal() * points_, scale.cwiseProduct(point));
  const double known = correlation.dot(factor_.solve(correlation));
  const double mean_error = 1 - ones_solved_.dot(correlation);
  const double share = 1 - known + mean_error * mean_error / ones_solved_.sum();
  return {mean_ + correlation.dot(rest_solved_), std::sqrt(variance_ * std::max(0.0, share))};
}

// Dubrule's inverse of the correlation bordered with ones is correlation^-1 - c c^T/(1^T c) with c = correlation^-1 1;
// times the values it is rest_solved_.
Eigen::VectorXd Kriging::leave_one_out_errors() const {
  const Eigen::MatrixXd inverse = factor_.solve(Eigen::MatrixXd::Identity(values_.size(), values_.size()));
  const Eigen::VectorXd bordered = inverse.diagonal() - ones_solved_.cwiseAbs2() / ones_solved_.sum();
  return rest_solved_.cwiseQuotient(bordered);
}

double Kriging::leave_one_out_quality() const {
  const double spread = (values_.array() - values_.mean()).square().mean();
  return 1 - leave_one_out_errors().squaredNorm() / static_cast<double>(values_.size()) / spread;
}

}  // namespace netpocket
