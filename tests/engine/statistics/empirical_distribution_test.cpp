// Quantiles with intervals, and that every distribution of the room below follows its own law (Kolmogorov-Smirnov
// against Boost.Math).

#include "engine/statistics/empirical_distribution.h"

#include <gtest/gtest.h>

#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/triangular.hpp>
#include <cmath>
#include <numeric>

#include "engine/sampling/design.h"
#include "engine/sampling/distribution.h"
#include "engine/sampling/joint_distribution.h"

namespace netpocket {
namespace {

EmpiricalDistribution ranks(int size) {
  std::vector<double> values(static_cast<std::size_t>(size));
  std::iota(values.rbegin(), values.rend(), 1);
  return EmpiricalDistribution(values);
}

TEST(EmpiricalDistribution, HasItsOwnQuantiles) {
  const EmpiricalDistribution sample = ranks(20);
  EXPECT_EQ(sample.quantile(0), 1);
  EXPECT_EQ(sample.quantile(0.5), 10);
  EXPECT_EQ(sample.quantile(0.95), 19);
  EXPECT_EQ(sample.quantile(0.951), 20);
  EXPECT_EQ(sample.quantile(1), 20);
  EXPECT_EQ(sample.cumulative(0.9), 0);
  EXPECT_EQ(sample.cumulative(10), 0.5);
  EXPECT_EQ(sample.cumulative(30), 1);
}

// Ranks of 95 % intervals of the median as tables of the sign test have them (e.g. Conover 1999, Practical
// Nonparametric Statistics, section 3.2).
TEST(EmpiricalDistribution, BoundsTheMedianByThePublishedRanks) {
  const std::vector<std::array<int, 3>> published = {{10, 2, 9}, {20, 6, 15}, {30, 10, 21}, {100, 40, 61}};
  for (const auto& [size, lower, upper] : published) {
    const QuantileEstimate median = ranks(size).quantile_estimate(0.5, 0.95);
    EXPECT_EQ(median.interval.lower, lower) << size;
    EXPECT_EQ(median.interval.upper, upper) << size;
  }
}

// Wilks (1941), Ann. Math. Stat. 12(1), doi:10.1214/aoms/1177731788: the largest of 59 values exceeds the 95 % quantile
// with a probability of 95 %, that of 58 does not.
TEST(EmpiricalDistribution, BoundsAHighQuantileOnlyWithEnoughValues) {
  EXPECT_EQ(ranks(59).quantile_estimate(0.95, 0.9).interval.upper, 59);
  EXPECT_EQ(ranks(58).quantile_estimate(0.95, 0.9).interval.upper, std::numeric_limits<double>::infinity());
  EXPECT_EQ(ranks(5).quantile_estimate(0.01, 0.9).interval.lower, -std::numeric_limits<double>::infinity());
}

TEST(KolmogorovSmirnov, IsTheLargestDifference) {
  const EmpiricalDistribution sample({0.7, 0.1, 0.4});
  EXPECT_NEAR(kolmogorov_smirnov_statistic(sample, [](double x) { return x; }), 0.3, 1e-15);
}

// Critical values of Miller (1956), Table of percentage points of Kolmogorov statistics, J. Am. Stat. Assoc. 51,
// doi:10.1080/01621459.1956.10501314.
TEST(KolmogorovSmirnov, HasThePublishedCriticalValues) {
  struct Critical {
    std::size_t size;
    double five_per_cent, one_per_cent;
  };
  for (const auto& c : {Critical{10, 0.40925, 0.48893}, Critical{20, 0.29408, 0.35241}, Critical{50, 0.18841, 0.22585},
                        Critical{100, 0.13403, 0.16081}}) {
    EXPECT_NEAR(kolmogorov_smirnov_probability(c.five_per_cent, c.size), 0.05, 1e-3) << c.size;
    EXPECT_NEAR(kolmogorov_smirnov_probability(c.one_per_cent, c.size), 0.01, 1e-3) << c.size;
  }
  EXPECT_EQ(kolmogorov_smirnov_probability(0, 10), 1);
  EXPECT_LT(kolmogorov_smirnov_probability(1, 10), 1e-8);
}

// Probability that draws from `distribution` at a Monte Carlo design follow `law`.
double agreement(const Distribution& distribution, const std::function<double(double)>& law, std::uint64_t seed) {
  const Design design(DesignKind::monte_carlo, 1, 5000, seed);
  std::vector<double> values;
  for (std::uint64_t i = 0; i < design.count(); ++i) values.push_back(quantile(distribution, design.point(i)[0]));
  const EmpiricalDistribution sample(values);
  return kolmogorov_smirnov_probability(kolmogorov_smirnov_statistic(sample, law), values.size());
}

TEST(KolmogorovSmirnov, AcceptsEveryDistribution) {
  const boost::math::normal normal(2, 3);
  const boost::math::lognormal log_normal(std::log(5), 0.4);
  const boost::math::triangular triangular(-1, 0, 3);
  const double low = boost::math::cdf(normal, 1), high = boost::math::cdf(normal, 6);
  const std::vector<std::pair<Distribution, std::function<double(double)>>> laws = {
      {Normal{2, 3}, [&](double x) { return boost::math::cdf(normal, x); }},
      {TruncatedNormal{2, 3, 1, 6}, [&](double x) { return (boost::math::cdf(normal, x) - low) / (high - low); }},
      {Uniform{-1, 4}, [](double x) { return (x + 1) / 5; }},
      {LogNormal{5, 0.4}, [&](double x) { return boost::math::cdf(log_normal, x); }},
      {Triangular{-1, 0, 3}, [&](double x) { return boost::math::cdf(triangular, x); }}};
  std::uint64_t seed = 0;
  for (const auto& [distribution, law] : laws) EXPECT_GT(agreement(distribution, law, ++seed), 0.01) << seed;
}

TEST(KolmogorovSmirnov, RejectsAnotherDistribution) {
  const boost::math::normal shifted(2.2, 3), wider(2, 3.4);
  EXPECT_LT(agreement(
                Normal{2, 3}, [&](double x) { return boost::math::cdf(shifted, x); }, 1),
            0.001);
  EXPECT_LT(agreement(
                Normal{2, 3}, [&](double x) { return boost::math::cdf(wider, x); }, 1),
            0.001);
}

// Weighted values: the chi-squared statistic of three classes.
TEST(Discrete, IsDrawnByItsWeights) {
  const Design design(DesignKind::monte_carlo, 1, 10000, 3);
  std::array<double, 3> counts{};
  for (std::uint64_t i = 0; i < design.count(); ++i) {
    ++counts.at(static_cast<std::size_t>(quantile(Discrete{{0, 1, 2}, {1, 2, 7}}, design.point(i)[0])));
  }
  const std::array<double, 3> expected = {1000, 2000, 7000};
  double chi_squared = 0;
  for (std::size_t i = 0; i < 3; ++i) chi_squared += std::pow(counts[i] - expected[i], 2) / expected[i];
  EXPECT_LT(chi_squared, 13.8);  // 0.1 % point for 2 degrees of freedom
}

TEST(CorrelatedNormals, HaveTheirCorrelationAndTheirOwnLaws) {
  CorrelatedNormals group{Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(1, 2, 0.5), Eigen::Matrix3d::Identity()};
  group.correlation(0, 1) = group.correlation(1, 0) = 0.7;
  group.correlation(1, 2) = group.correlation(2, 1) = -0.4;
  constexpr int kCount = 20000;
  const Design design(DesignKind::monte_carlo, 3, kCount, 8);
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  std::vector<double> last;
  for (std::uint64_t i = 0; i < kCount; ++i) {
    const Eigen::Vector3d values = correlated_values(group, design.point(i));
    const Eigen::Vector3d z = (values - group.mean).cwiseQuotient(group.deviation);
    moments += z * z.transpose() / kCount;
    last.push_back(z[2]);
  }
  // Four standard errors, that of a variance being the largest.
  EXPECT_LT((moments - group.correlation).cwiseAbs().maxCoeff(), 4 * std::sqrt(2.0 / kCount));
  const boost::math::normal normal;
  const auto law = [&](double x) { return boost::math::cdf(normal, x); };
  EXPECT_GT(kolmogorov_smirnov_probability(kolmogorov_smirnov_statistic(EmpiricalDistribution(last), law), kCount),
            0.01);
}

// Archimedes: every coordinate of a random direction is uniform, and so is that along any other axis.
TEST(Direction, IsEvenOnTheSphere) {
  const Design design(DesignKind::monte_carlo, 2, 5000, 6);
  const auto uniform = [](double x) { return (x + 1) / 2; };
  for (const Eigen::Vector3d& axis : {Eigen::Vector3d::UnitX().eval(), Eigen::Vector3d::UnitZ().eval(),
                                      Eigen::Vector3d(1, -2, 2).normalized().eval()}) {
    std::vector<double> heights;
    for (std::uint64_t i = 0; i < design.count(); ++i) {
      const Eigen::VectorXd point = design.point(i);
      heights.push_back(axis.dot(direction(point[0], point[1])));
    }
    const EmpiricalDistribution sample(heights);
    EXPECT_GT(kolmogorov_smirnov_probability(kolmogorov_smirnov_statistic(sample, uniform), heights.size()), 0.01);
  }
}

}  // namespace
}  // namespace netpocket
