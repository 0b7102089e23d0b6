#include "render/figures/axis_ticks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace netpocket {
namespace {

using Labels = std::vector<std::string>;

TEST(NiceStep, IsTheSmallestRoundStepThatFits) {
  EXPECT_DOUBLE_EQ(nice_step(20, 8), 5);
  EXPECT_DOUBLE_EQ(nice_step(20, 10), 2);
  EXPECT_DOUBLE_EQ(nice_step(1, 5), 0.2);
  EXPECT_DOUBLE_EQ(nice_step(3.68, 4), 1);
  EXPECT_DOUBLE_EQ(nice_step(1e-5, 4), 5e-6);
  EXPECT_DOUBLE_EQ(nice_step(700, 1), 1000);
}

TEST(NiceStep, NeverGivesMoreIntervalsThanAsked) {
  for (double span = 1e-7; span < 1e7; span *= 1.37) {
    for (int intervals = 1; intervals < 12; ++intervals) {
      const double step = nice_step(span, intervals);
      EXPECT_LE(span / step, intervals * (1 + 1e-6)) << span << " in " << intervals;
      EXPECT_GT(span / step, intervals / 2.6) << span << " in " << intervals;
    }
  }
}

TEST(Ticks, OfTheTimeAxisOfTheCases) {
  const AxisTicks ticks = make_ticks({0, 20}, 6);
  EXPECT_EQ(ticks.major, (std::vector<double>{0, 5, 10, 15, 20}));
  EXPECT_EQ(ticks.labels, (Labels{"0", "5", "10", "15", "20"}));
  EXPECT_EQ(ticks.minor.size(), 16u);
  EXPECT_EQ(ticks.multiplier, "");
}

TEST(Ticks, HaveTypographicMinusSignsAndNoMinusZero) {
  EXPECT_EQ(make_ticks({-0.25, 0.25}, 5).labels, (Labels{"−0.2", "−0.1", "0.0", "0.1", "0.2"}));
  EXPECT_EQ(number_text(-0.001, 2), "0.00");
  EXPECT_EQ(number_text(-42.06, 1), "−42.1");
}

TEST(Ticks, PutAPowerOfTenAsideWhenValuesAreSmallOrLarge) {
  const AxisTicks small = make_ticks({-2.2e-5, 2.2e-5}, 4);
  EXPECT_EQ(small.exponent, -5);
  EXPECT_EQ(small.labels, (Labels{"−2", "0", "2"}));
  EXPECT_EQ(small.multiplier, "×10^{−5}");
  const AxisTicks large = make_ticks({0, 30000}, 3);
  EXPECT_EQ(large.labels, (Labels{"0", "1", "2", "3"}));
  EXPECT_EQ(large.multiplier, "×10^{4}");
  EXPECT_EQ(make_ticks({0, 0.05}, 5).multiplier, "");
}

TEST(Ticks, SplitOffWhatAllLabelsShare) {
  const AxisTicks ticks = make_ticks({7.500002, 7.500011}, 4);
  EXPECT_DOUBLE_EQ(ticks.offset, 7.5);
  EXPECT_EQ(ticks.multiplier, "×10^{−5} + 7.5");
  EXPECT_EQ(ticks.labels, (Labels{"0.5", "1.0"}));
  EXPECT_EQ(make_ticks({-1.0000021, -0.9999987}, 4).multiplier, "×10^{−6} − 1");
}

TEST(Ticks, LieWithinTheLimitsAndMinorOnesBetween) {
  for (double low = -3.7; low < 4; low += 0.61) {
    const AxisTicks ticks = make_ticks({low, low + 2.9}, 5);
    ASSERT_GE(ticks.major.size(), 2u);
    ASSERT_EQ(ticks.major.size(), ticks.labels.size());
    for (const double value : ticks.major) {
      EXPECT_GE(value, low - 1e-9);
      EXPECT_LE(value, low + 2.9 + 1e-9);
      for (const double minor : ticks.minor) EXPECT_GT(std::abs(minor - value), 1e-3);
    }
  }
}

TEST(Ticks, OfWholeNumbersHaveNothingBetween) {
  const AxisTicks few = make_ticks({-0.5, 1.5}, 6, 1);
  EXPECT_EQ(few.labels, (Labels{"0", "1"}));
  EXPECT_TRUE(few.minor.empty());
  EXPECT_EQ(make_ticks({-0.5, 0.5}, 6, 1).labels, Labels{"0"});
  EXPECT_EQ(make_ticks({0, 10}, 5, 1).labels, (Labels{"0", "2", "4", "6", "8", "10"}));
  EXPECT_EQ(make_ticks({0, 10}, 5, 1).minor, (std::vector<double>{1, 3, 5, 7, 9}));
  EXPECT_EQ(make_ticks({0, 300}, 6, 1).major, make_ticks({0, 300}, 6).major);
}

TEST(Ticks, AreAtLeastTwo) {
  EXPECT_EQ(make_ticks({-1, 45}, 1).labels, (Labels{"0", "20", "40"}));
  EXPECT_EQ(make_ticks({-1e-3, 1e-3}, 1).labels.size(), 3u);
}

TEST(Limits, KeepAMarginAroundTheData) { EXPECT_EQ(padded_limits(0, 10, 0.1, 0), (AxisLimits{-1, 11})); }

TEST(Limits, CanBeDrawnForConstantData) {
  EXPECT_EQ(padded_limits(0, 0, 0.1, 0), (AxisLimits{-1, 1}));
  EXPECT_EQ(padded_limits(10, 10, 0.1, 0), (AxisLimits{9.5, 10.5}));
}

TEST(Limits, OfNothingButZeroAreRound) { EXPECT_EQ(padded_limits(0, 0, 0.1, 1e-3), (AxisLimits{-1, 1})); }

TEST(Limits, DoNotMagnifyRoundOff) { EXPECT_EQ(padded_limits(-1e-17, 1e-17, 0.1, 2e-9), (AxisLimits{-1e-9, 1e-9})); }

}  // namespace
}  // namespace netpocket
