// Closing laws: derivatives against central differences, end conditions, monotony, values from closed forms.

#include "engine/control/closing_law.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/scenario/pocket_outline.h"

namespace netpocket {
namespace {

constexpr double kOpen = 5.786;
constexpr double kStart = 1.5;
constexpr double kDuration = 7.5;

ClosingParameters parameters_for(ClosingLaw law) {
  ClosingParameters parameters;
  parameters.law = law;
  parameters.start = kStart;
  parameters.duration = kDuration;
  parameters.table = {{0, kOpen}, {1, 5.5}, {3, 5.4}, {3.5, 3}, {6, 2.9}, {kDuration, 2.1}};
  return parameters;
}

class Laws : public testing::TestWithParam<ClosingLaw> {
 protected:
  ClosingSchedule schedule_{parameters_for(GetParam()), kOpen};

  // Times inside the closing at which the law and its derivatives are smooth over +-1e-3 s.
  std::vector<double> smooth_times() const {
    std::vector<double> times;
    for (int i = 1; i < 400; ++i) times.push_back(kStart + kDuration * (i + 0.1234) / 401);
    const auto near_corner = [](double time) {
      for (const double corner : {0.0, 1.0, 3.0, 3.5, 6.0, kDuration, kDuration / 4, kDuration * 3 / 4}) {
        if (std::abs(time - kStart - corner) < 2e-3) return true;
      }
      return false;
    };
    std::erase_if(times, near_corner);
    return times;
  }
};

TEST_P(Laws, DerivativesMatchCentralDifferences) {
  constexpr double h = 1e-4;
  double speed_error = 0;
  double acceleration_error = 0;
  for (const double t : smooth_times()) {
    const ClosingState before = schedule_.at(t - h);
    const ClosingState after = schedule_.at(t + h);
    const ClosingState now = schedule_.at(t);
    speed_error = std::max(speed_error, std::abs(now.speed - (after.length - before.length) / (2 * h)));
    acceleration_error =
        std::max(acceleration_error, std::abs(now.acceleration - (after.speed - before.speed) / (2 * h)));
  }
  std::printf("speed error %.2e m/s, acceleration error %.2e m/s^2\n", speed_error, acceleration_error);
  // h^2/6 times the third derivative, which is below 231 m/s^3 (the table's steepest piece: 12 * 2.4 m/(0.5 s)^3),
  // is 3.9e-7; round-off adds eps L/h = 1e-11.
  EXPECT_LT(speed_error, 4e-7);
  // The fourth derivative is below 2 m/s^4 for quintic and cycloid, zero for the others.
  EXPECT_LT(acceleration_error, 1e-8);
}

TEST_P(Laws, StartsOpenAndEndsClosed) {
  const double end = kStart + kDuration;
  EXPECT_EQ(schedule_.start(), kStart);
  EXPECT_EQ(schedule_.end(), end);
  EXPECT_EQ(schedule_.open_length(), kOpen);
  EXPECT_EQ(schedule_.closed_length(), 2.1);
  for (const double t : {-1.0, 0.0, kStart}) {
    EXPECT_EQ(schedule_.at(t).length, kOpen);
    EXPECT_EQ(schedule_.at(t).speed, 0);
    EXPECT_EQ(schedule_.at(t).acceleration, 0);
  }
  for (const double t : {end, end + 1, 1e6}) {
    EXPECT_EQ(schedule_.at(t).length, 2.1);
    EXPECT_EQ(schedule_.at(t).speed, 0);
    EXPECT_EQ(schedule_.at(t).acceleration, 0);
  }
  // No jump of the length anywhere, and of the speed only for the linear law.
  constexpr double kJust = 1e-9;
  EXPECT_NEAR(schedule_.at(kStart + kJust).length, kOpen, 1e-8);
  EXPECT_NEAR(schedule_.at(end - kJust).length, 2.1, 1e-8);
  const double jump = GetParam() == ClosingLaw::linear ? (kOpen - 2.1) / kDuration : 0;
  EXPECT_NEAR(schedule_.at(kStart + kJust).speed, -jump, 1e-7);
  EXPECT_NEAR(schedule_.at(end - kJust).speed, -jump, 1e-7);
}

TEST_P(Laws, NeverLengthens) {
  double last = kOpen;
  for (int i = 0; i <= 10000; ++i) {
    const ClosingState now = schedule_.at(kStart + kDuration * i / 10000);
    EXPECT_LE(now.length, last + 1e-15);
    EXPECT_LE(now.speed, 0);
    last = now.length;
  }
}

INSTANTIATE_TEST_SUITE_P(Closing, Laws,
                         testing::Values(ClosingLaw::cycloid, ClosingLaw::quintic, ClosingLaw::trapezoid,
                                         ClosingLaw::linear, ClosingLaw::table));

// Peak speeds in units of (open - closed)/duration: cycloid 2, minimum jerk 15/8, trapezoid with quarter ramps 4/3.
TEST(ClosingSchedule, HasTheTextbookPeakSpeed) {
  const double unit = (kOpen - 2.1) / kDuration;
  const auto middle = [](ClosingLaw law) {
    return ClosingSchedule(parameters_for(law), kOpen).at(kStart + kDuration / 2);
  };
  EXPECT_NEAR(middle(ClosingLaw::cycloid).speed, -2 * unit, 1e-14);
  EXPECT_NEAR(middle(ClosingLaw::quintic).speed, -15.0 / 8 * unit, 1e-14);
  EXPECT_NEAR(middle(ClosingLaw::trapezoid).speed, -4.0 / 3 * unit, 1e-14);
  EXPECT_NEAR(middle(ClosingLaw::linear).speed, -unit, 1e-14);
  EXPECT_NEAR(middle(ClosingLaw::cycloid).length, (kOpen + 2.1) / 2, 1e-14);
}

TEST(ClosingSchedule, TablePassesThroughItsPoints) {
  const ClosingParameters parameters = parameters_for(ClosingLaw::table);
  const ClosingSchedule schedule(parameters, kOpen);
  for (const auto& point : parameters.table) {
    EXPECT_NEAR(schedule.at(kStart + point.x()).length, point.y(), 1e-14);
  }
}

TEST(ClosingSchedule, TableStartsFromTheExactOpenLength) {
  ClosingParameters parameters = parameters_for(ClosingLaw::table);
  parameters.table.front().y() = 5.78;  // as the paper rounds it
  const ClosingSchedule schedule(parameters, kOpen);
  EXPECT_NEAR(schedule.at(kStart + 1e-9).length, kOpen, 1e-8);
}

// Tang et al. 2023, section 4.1: 5.78 m between adjacent tips of the open pocket.
TEST(PocketOutline, OpenTipDistanceIsThatOfThePaper) {
  EXPECT_NEAR(open_tip_distance(Scenario()), 5.78, 0.01);  // the paper's two decimals are rounded down from 5.786
}

TEST(PocketOutline, PanelsSpanTheOpenDistanceAndTheProfile) {
  const Scenario scenario;
  const auto panels = panel_outlines(scenario);
  ASSERT_EQ(panels.size(), 16u);
  for (std::size_t i = 1; i < panels.size(); i += 2) {
    EXPECT_NEAR((panels[i].upper[1] - panels[i].upper[0]).norm(), open_tip_distance(scenario), 1e-14);
    EXPECT_LT((panels[i].lower[0] - panels[i - 1].upper[0]).norm(), 1e-14);
    EXPECT_EQ(panels[i].point(0, 1), panels[i].upper[0]);
    EXPECT_EQ(panels[i].upper[0].y(), 12);
  }
}

}  // namespace
}  // namespace netpocket
