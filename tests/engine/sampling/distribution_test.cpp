// Quantiles against Boost.Math, closed forms and numerical integrals; one sentence for each fault.

#include "engine/sampling/distribution.h"

#include <gtest/gtest.h>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/triangular.hpp>
#include <cmath>
#include <limits>

#include "engine/sampling/joint_distribution.h"
#include "engine/sampling/normal.h"

namespace netpocket {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(NormalQuantile, IsThatOfBoost) {
  const boost::math::normal normal;
  for (const double u : {1e-300, 1e-100, 1e-20, 1e-12, 1e-6, 0.001, 0.05, 0.074, 0.076, 0.3, 0.49999, 0.5, 0.7, 0.924,
                         0.926, 0.99, 0.999999}) {
    const double exact = boost::math::quantile(normal, u);
    EXPECT_NEAR(normal_quantile(u), exact, 4e-15 * std::abs(exact)) << u;
  }
  EXPECT_EQ(normal_quantile(0), -kInfinity);
  EXPECT_EQ(normal_quantile(1), kInfinity);
  EXPECT_TRUE(std::isnan(normal_quantile(-0.1)));
  EXPECT_TRUE(std::isnan(normal_quantile(kNaN)));
}

TEST(NormalCumulative, IsThatOfBoost) {
  const boost::math::normal normal;
  for (double x = -36.9; x < 9; x += 0.37) {
    const double exact = boost::math::cdf(normal, x);
    EXPECT_NEAR(normal_cumulative(x), exact, (x > -5 ? 1e-14 : 2e-13) * exact) << x;
  }
  EXPECT_NEAR(normal_cumulative(-2.0000001), 0.0227501 - 5.4e-9, 5e-8);
  EXPECT_EQ(normal_cumulative(-kInfinity), 0);
  EXPECT_EQ(normal_cumulative(kInfinity), 1);
}

TEST(Distribution, HasTheQuantilesOfClosedForms) {
  EXPECT_NEAR(quantile(Normal{3, 2}, 0.975), 3 + 2 * 1.959963984540054, 1e-14);
  EXPECT_EQ(quantile(Uniform{-2, 6}, 0.25), 0);
  EXPECT_NEAR(quantile(LogNormal{5, 0.3}, 0.8413447460685429), 5 * std::exp(0.3), 1e-13);
  const boost::math::triangular triangular(1, 2, 5);
  for (const double u : {0.01, 0.2, 0.25, 0.3, 0.9}) {
    EXPECT_NEAR(quantile(Triangular{1, 2, 5}, u), boost::math::quantile(triangular, u), 1e-14) << u;
  }
  EXPECT_NEAR(quantile(Triangular{1, 1, 2}, 0.75), 1.5, 1e-15);
  EXPECT_NEAR(quantile(Triangular{1, 2, 2}, 0.25), 1.5, 1e-15);
  // A normal number that is known to be positive has the median Phi^-1(3/4).
  EXPECT_NEAR(quantile(TruncatedNormal{0, 1, 0, 1000}, 0.5), 0.6744897501960817, 1e-14);
  EXPECT_NEAR(quantile(TruncatedNormal{0, 1, -1000, 0}, 0.5), -0.6744897501960817, 1e-14);
}

// Share of the density between min and x, by Simpson's rule.
double integrated_share(const TruncatedNormal& d, double x) {
  const double peak = std::max(d.min, std::min(d.mean, d.max));
  const auto density = [&](double t) {
    return std::exp(-((t - d.mean) * (t - d.mean) - (peak - d.mean) * (peak - d.mean)) /
                    (2 * d.deviation * d.deviation));
  };
  const auto integral = [&](double to) {
    constexpr int kIntervals = 2000;
    const double h = (to - d.min) / kIntervals;
    double sum = density(d.min) + density(to);
    for (int i = 1; i < kIntervals; ++i) sum += (i % 2 == 1 ? 4 : 2) * density(d.min + i * h);
    return sum * h / 3;
  };
  return integral(x) / integral(d.max);
}

TEST(TruncatedNormal, IsRightFarFromItsMeanToo) {
  for (const TruncatedNormal& d : {TruncatedNormal{0, 1, -1, 2}, TruncatedNormal{0, 1, 10, 11},
                                   TruncatedNormal{5, 2, -15, -13}, TruncatedNormal{0, 1, 30, 30.5}}) {
    for (const double u : {0.01, 0.3, 0.5, 0.99}) {
      const double x = quantile(d, u);
      EXPECT_NEAR(integrated_share(d, x), u, 1e-9) << d.min;
      EXPECT_NEAR(cumulative(d, x), u, 1e-10) << d.min;
      EXPECT_GE(x, d.min);
      EXPECT_LE(x, d.max);
    }
  }
}

TEST(Distribution, CumulativeIsTheInverse) {
  for (const Distribution& d : {Distribution(Normal{1, 2}), Distribution(Uniform{-1, 4}), Distribution(LogNormal{2, 1}),
                                Distribution(Triangular{0, 3, 4})}) {
    for (const double u : {1e-6, 0.1, 0.5, 0.77, 0.999}) EXPECT_NEAR(cumulative(d, quantile(d, u)), u, 1e-13);
    EXPECT_EQ(cumulative(d, -1e9), 0);
    EXPECT_EQ(cumulative(d, 1e9), 1);
  }
}

TEST(Distribution, IsFiniteAtTheEndsOfTheUnitInterval) {
  for (const double u : {0.0, 1.0}) {
    EXPECT_TRUE(std::isfinite(quantile(Normal{}, u)));
    EXPECT_TRUE(std::isfinite(quantile(LogNormal{}, u)));
  }
  EXPECT_LT(quantile(Normal{}, 0), -8);
}

TEST(Discrete, GivesEachValueItsShare) {
  const Discrete d{{3, 1, 2, 9}, {1, 2, 1, 0}};
  EXPECT_EQ(quantile(d, 0), 1);
  EXPECT_EQ(quantile(d, 0.49), 1);
  EXPECT_EQ(quantile(d, 0.51), 2);
  EXPECT_EQ(quantile(d, 0.76), 3);
  EXPECT_EQ(quantile(d, 1), 3) << "a value without weight is never drawn";
  EXPECT_EQ(cumulative(d, 0.9), 0);
  EXPECT_EQ(cumulative(d, 2), 0.75);
  const Samples s{{7, 5}};
  EXPECT_EQ(quantile(s, 0.4), 5);
  EXPECT_EQ(quantile(s, 0.6), 7);
}

TEST(Distribution, SaysWhatIsWrong) {
  const std::vector<std::pair<Distribution, std::string>> faults = {
      {Normal{kNaN, 1}, "has a number that is not finite"},
      {Normal{0, kInfinity}, "has a number that is not finite"},
      {Normal{0, 0}, "needs a deviation > 0, not 0"},
      {TruncatedNormal{0, -1, 0, 1}, "needs a deviation > 0, not -1"},
      {TruncatedNormal{0, 1, 2, 1}, "needs a min below its max, not 2 and 1"},
      {TruncatedNormal{0, 1, 50, 51}, "is cut to 50 to 51, too far from its mean 0 for its deviation 1"},
      {Uniform{1, 1}, "needs a min below its max, not 1 and 1"},
      {LogNormal{0, 1}, "needs a median > 0, not 0"},
      {LogNormal{1, -2}, "needs a deviation > 0, not -2"},
      {Triangular{0, 2, 1}, "needs a mode from 0 to 1, not 2"},
      {Discrete{}, "needs at least one value"},
      {Discrete{{1, kNaN}, {}}, "has a number that is not finite"},
      {Discrete{{1, 2}, {1}}, "needs as many weights as values, not 1 and 2"},
      {Discrete{{1, 2}, {1, -1}}, "has a weight below 0"},
      {Discrete{{1, 2}, {0, 0}}, "needs weights with a finite sum above 0"},
      {Samples{}, "needs at least one value"}};
  for (const auto& [distribution, fault] : faults) EXPECT_EQ(find_fault(distribution), fault);
  EXPECT_EQ(find_fault(Triangular{0, 0, 1}), "");
  EXPECT_EQ(find_fault(TruncatedNormal{0, 1, 30, 31}), "");
  EXPECT_EQ(find_fault(Discrete{{1, 2}, {0, 3}}), "");
}

CorrelatedNormals pair_with(double correlation) {
  CorrelatedNormals group{Eigen::Vector2d(1, -2), Eigen::Vector2d(2, 0.5), Eigen::Matrix2d::Identity()};
  group.correlation(0, 1) = group.correlation(1, 0) = correlation;
  return group;
}

// The Cholesky factor of two inputs is known in closed form.
TEST(CorrelatedNormals, FollowsTheCholeskyFactor) {
  const double r = -0.6, z1 = 1.2, z2 = -0.4;
  const Eigen::Vector2d values =
      correlated_values(pair_with(r), Eigen::Vector2d(normal_cumulative(z1), normal_cumulative(z2)));
  EXPECT_NEAR(values[0], 1 + 2 * z1, 1e-12);
  EXPECT_NEAR(values[1], -2 + 0.5 * (r * z1 + 0.8 * z2), 1e-12);
}

TEST(CorrelatedNormals, SaysWhatIsWrong) {
  EXPECT_EQ(find_fault(pair_with(0.99)), "");
  EXPECT_EQ(find_fault(pair_with(1.5)), "has a correlation matrix that is not positive definite: no such inputs exist");
  EXPECT_EQ(find_fault(pair_with(kNaN)), "has a number that is not finite");
  CorrelatedNormals group = pair_with(0.5);
  group.correlation(0, 1) = 0.4;
  EXPECT_EQ(find_fault(group), "needs a symmetric correlation matrix");
  group = pair_with(0.5);
  group.correlation(0, 0) = 2;
  EXPECT_EQ(find_fault(group), "needs a correlation matrix with ones on its diagonal");
  group = pair_with(0.5);
  group.deviation[1] = 0;
  EXPECT_EQ(find_fault(group), "needs a deviation > 0, not 0");
  group.deviation.resize(3);
  EXPECT_EQ(find_fault(group), "needs 2 deviations and 2 x 2 correlations, one for each mean");
  EXPECT_EQ(find_fault(CorrelatedNormals{}), "needs at least one input");
}

TEST(Direction, IsOnTheSphere) {
  EXPECT_EQ(direction(0.5, 0), Eigen::Vector3d(1, 0, 0));
  EXPECT_TRUE(direction(0.5, 0.25).isApprox(Eigen::Vector3d(0, 1, 0)));
  EXPECT_EQ(direction(1, 0.3), Eigen::Vector3d(0, 0, 1));
  EXPECT_NEAR(direction(0.123, 0.456).norm(), 1, 1e-15);
}

}  // namespace
}  // namespace netpocket
