// Subset simulation where the probability is known.

#include <gtest/gtest.h>

#include <cmath>

#include "engine/sampling/normal.h"
#include "engine/statistics/subset_simulation.h"

namespace netpocket {
namespace {

// Fails where the sum of the variables exceeds beta sqrt(n): probability Phi(-beta) in any number of dimensions.
Eigen::VectorXd linear_limit_state(const Eigen::MatrixXd& points, double beta) {
  return beta - points.colwise().sum().transpose().array() / std::sqrt(static_cast<double>(points.rows()));
}

// Of estimates by the exact probability.
struct Spread {
  double mean = 0, standard_error = 0;
  double log_deviation = 0;  // of their logarithms, because single estimates are several times too large
  double reported = 0;       // mean coefficient of variation
};

Spread spread_of_estimates(double beta, int dimensions, int runs) {
  Eigen::ArrayXd ratios(runs);
  Spread spread;
  for (int run = 0; run < runs; ++run) {
    const auto limit_state = [&](const Eigen::MatrixXd& points) { return linear_limit_state(points, beta); };
    const SubsetOptions options{.samples = 500, .seed = static_cast<std::uint64_t>(run + 1)};
    const SubsetResult result = subset_simulation(limit_state, dimensions, options);
    EXPECT_TRUE(result.is_resolved);
    ratios[run] = result.probability / normal_cumulative(-beta);
    spread.reported += result.variation / runs;
  }
  const auto deviation = [&](const Eigen::ArrayXd& values) {
    return std::sqrt((values - values.mean()).square().sum() / (runs - 1));
  };
  spread.mean = ratios.mean();
  spread.standard_error = deviation(ratios) / std::sqrt(runs);
  spread.log_deviation = deviation(ratios.log());
  return spread;
}

TEST(SubsetSimulation, FindsTheProbabilityOfALinearLimitState) {
  for (const auto& [beta, dimensions] : {std::pair(2.0, 2), {3.5, 10}, {4.5, 10}}) {
    const Spread spread = spread_of_estimates(beta, dimensions, 30);
    // The estimate is biased by the order of its squared variation (Au & Beck, section 5.1).
    EXPECT_NEAR(spread.mean, 1, 4 * spread.standard_error + spread.reported * spread.reported) << beta;
    EXPECT_GT(spread.log_deviation, 0.7 * spread.reported) << beta;
    EXPECT_LT(spread.log_deviation, 2 * spread.reported) << beta;
    EXPECT_LT(spread.reported, 0.6) << beta;
  }
}

// The two coefficients of variation enclose the true one, and the interval holds the probability at least as often as
// it says.
TEST(SubsetSimulation, ItsIntervalHoldsTheProbability) {
  const double exact = normal_cumulative(-3.5);
  constexpr int kRuns = 120;
  int held = 0;
  double squares = 0, least = 0, most = 0;
  for (int run = 0; run < kRuns; ++run) {
    const auto limit_state = [](const Eigen::MatrixXd& points) { return linear_limit_state(points, 3.5); };
    const SubsetResult result =
        subset_simulation(limit_state, 10, {.samples = 500, .seed = static_cast<std::uint64_t>(1000 + run)});
    held += subset_interval(result, 0.95).contains(exact) ? 1 : 0;
    squares += std::pow(result.probability / exact - 1, 2) / kRuns;
    least += result.variation / kRuns;
    most += result.most_variation / kRuns;
    ASSERT_FALSE(result.steps.empty());
    EXPECT_EQ(result.steps.back().probability, result.probability);
  }
  EXPECT_GE(held, 110) << "binomial: 114 of 120 less two standard deviations";
  EXPECT_LT(least, std::sqrt(squares));
  EXPECT_GT(most, std::sqrt(squares));
}

// Numbers that many points share, as those of a count do: the limit state in steps of 1/2.
TEST(SubsetSimulation, CountsEqualValues) {
  constexpr int kRuns = 60;
  Eigen::ArrayXd ratios(kRuns);
  for (int run = 0; run < kRuns; ++run) {
    const auto stepped = [](const Eigen::MatrixXd& points) {
      return Eigen::VectorXd((2 * linear_limit_state(points, 3.5)).array().floor() / 2);
    };
    const SubsetResult result =
        subset_simulation(stepped, 5, {.samples = 500, .seed = static_cast<std::uint64_t>(run + 1)});
    EXPECT_TRUE(result.is_resolved);
    // A value of 0 is one from 0 to 1/2.
    ratios[run] = result.probability / normal_cumulative(-3);
  }
  const double deviation = std::sqrt((ratios - ratios.mean()).square().sum() / (kRuns - 1));
  EXPECT_NEAR(ratios.mean(), 1, 4 * deviation / std::sqrt(kRuns) + 0.1);
}

TEST(SubsetSimulation, NeedsFarFewerRunsThanMonteCarlo) {
  const auto limit_state = [](const Eigen::MatrixXd& points) { return linear_limit_state(points, 4.5); };
  const SubsetResult result = subset_simulation(limit_state, 10, {.samples = 500, .seed = 3});
  EXPECT_EQ(result.levels, 6);  // Phi(-4.5) = 3.4e-6
  EXPECT_EQ(result.evaluations, 500 + 5 * 450);
}

TEST(SubsetSimulation, IsPlainMonteCarloForFrequentFailures) {
  const auto limit_state = [](const Eigen::MatrixXd& points) { return linear_limit_state(points, 0.5); };
  const SubsetResult result = subset_simulation(limit_state, 3, {.samples = 1000, .seed = 2});
  const double exact = normal_cumulative(-0.5), deviation = std::sqrt(exact * (1 - exact) / 1000);
  EXPECT_EQ(result.levels, 1);
  EXPECT_NEAR(result.probability, exact, 4 * deviation);
  EXPECT_NEAR(result.variation, deviation / exact, 0.1 * deviation / exact);
}

TEST(SubsetSimulation, SaysWhenItGetsNowhere) {
  const auto never = [](const Eigen::MatrixXd& points) { return Eigen::VectorXd::Ones(points.cols()).eval(); };
  const SubsetResult result = subset_simulation(never, 2, {.samples = 100, .most_levels = 3});
  EXPECT_FALSE(result.is_resolved);
  EXPECT_EQ(result.levels, 3);
  const auto far = [](const Eigen::MatrixXd& points) { return linear_limit_state(points, 9); };
  const SubsetResult bound = subset_simulation(far, 2, {.samples = 500, .most_levels = 4});
  EXPECT_FALSE(bound.is_resolved);
  EXPECT_NEAR(bound.probability, 1e-4, 1e-12);
}

}  // namespace
}  // namespace netpocket
