#include "engine/statistics/proportion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace netpocket {
namespace {

// 95 % intervals from Newcombe (1998), Two-sided confidence intervals for the single proportion, Stat. Med. 17(8),
// doi:10.1002/(SICI)1097-0258(19980430)17:8<857::AID-SIM777>3.0.CO;2-E, table I.
struct Published {
  int successes, trials;
  Interval wilson, clopper_pearson;
};
constexpr Published kPublished[] = {{81, 263, {0.2553, 0.3662}, {0.2527, 0.3676}},
                                    {15, 148, {0.0624, 0.1605}, {0.0578, 0.1617}},
                                    {0, 20, {0, 0.1611}, {0, 0.1684}},
                                    {1, 29, {0.0061, 0.1718}, {0.0009, 0.1776}}};

TEST(Proportion, HasThePublishedIntervals) {
  for (const Published& p : kPublished) {
    const Interval wilson = wilson_interval(p.successes, p.trials, 0.95);
    EXPECT_NEAR(wilson.lower, p.wilson.lower, 5e-5) << p.trials;
    EXPECT_NEAR(wilson.upper, p.wilson.upper, 5e-5) << p.trials;
    const Interval exact = clopper_pearson_interval(p.successes, p.trials, 0.95);
    EXPECT_NEAR(exact.lower, p.clopper_pearson.lower, 5e-5) << p.trials;
    EXPECT_NEAR(exact.upper, p.clopper_pearson.upper, 5e-5) << p.trials;
  }
}

// With no failure in n trials the lower end is (alpha/2)^(1/n).
TEST(Proportion, IsTheClosedFormWhenAllSucceed) {
  const Interval interval = clopper_pearson_interval(2000, 2000, 0.95);
  EXPECT_NEAR(interval.lower, std::pow(0.025, 1.0 / 2000), 1e-13);
  EXPECT_EQ(interval.upper, 1);
}

double binomial_probability(int k, int n, double p) {
  return std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) + k * std::log(p) +
                  (n - k) * std::log(1 - p));
}

TEST(Proportion, CoversAsPromised) {
  constexpr int kTrials = 40;
  double wilson_mean = 0;
  for (int i = 1; i < 100; ++i) {
    const double p = i / 100.0;
    double exact = 0, wilson = 0;
    for (int k = 0; k <= kTrials; ++k) {
      const double probability = binomial_probability(k, kTrials, p);
      if (clopper_pearson_interval(k, kTrials, 0.9).contains(p)) exact += probability;
      if (wilson_interval(k, kTrials, 0.9).contains(p)) wilson += probability;
    }
    EXPECT_GE(exact, 0.9 - 1e-9) << p;
    wilson_mean += wilson / 99;
  }
  EXPECT_NEAR(wilson_mean, 0.9, 0.01);
}

TEST(Proportion, EndsWhenTheIntervalIsNarrow) {
  EXPECT_FALSE(is_narrow_enough(5, 5, 0.95, 0.5)) << "too few trials for any statement";
  EXPECT_TRUE(is_narrow_enough(30, 30, 0.95, 0.06));
  EXPECT_FALSE(is_narrow_enough(30, 30, 0.95, 0.05));
  const std::int64_t most = most_trials_needed(0.95, 0.01);
  EXPECT_TRUE(is_narrow_enough(most / 2, most, 0.95, 0.01));
  EXPECT_FALSE(is_narrow_enough((most - 2) / 2, most - 2, 0.95, 0.01));
  // The normal approximation without correction asks for (1.96 / 0.02)^2 = 9604.
  EXPECT_NEAR(static_cast<double>(most), 9604, 150);
}

}  // namespace
}  // namespace netpocket
