// Gas leaves the rods at its rate, from its event on, down to the pressure that stays.

#include "engine/control/deflation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/control/resume.h"

namespace netpocket {
namespace {

constexpr double kFull = 200e3;  // Pa
constexpr double kStep = 0.03;   // s

// Pressure (Pa) at 1, 2, ..., 6 s.
std::vector<double> pressures(Deflation deflation) {
  std::vector<double> found;
  double time = 0;
  for (int second = 1; second <= 6; ++second) {
    for (; time < second - 0.5 * kStep; time += kStep) deflation.update(time, kStep);
    // The last step ends up to half a step away from the full second.
    found.push_back(deflation.pressure());
  }
  return found;
}

std::shared_ptr<CaptureTimes> times_of(double closing_start, double closing_end) {
  CaptureTimes times;
  times.closing_start = closing_start;
  times.closing_end = closing_end;
  return std::make_shared<CaptureTimes>(times);
}

// p = 200 kPa - 40 kPa/s (t - t0), at least 50 kPa.
TEST(Deflation, FollowsItsRateFromItsEventOn) {
  const DeflationParameters at_time{.starts_at = DeflationStart::time, .start = 1.505, .rate = 40e3, .pressure = 50e3};
  DeflationParameters at_closing = at_time, at_closed = at_time;
  at_closing.starts_at = DeflationStart::closing;
  at_closing.start = 0.5;
  at_closed.starts_at = DeflationStart::closed;
  at_closed.start = 0;
  const auto times = times_of(1.005, 1.505);
  for (const DeflationParameters& parameters : {at_time, at_closing, at_closed}) {
    EXPECT_DOUBLE_EQ(Deflation(parameters, kFull, times).start(), 1.505);
    const std::vector<double> found = pressures(Deflation(parameters, kFull, times));
    for (int i = 0; i < 6; ++i) {
      const double elapsed = std::max(0.0, i + 1 - 1.505);
      EXPECT_NEAR(found[static_cast<std::size_t>(i)], std::max(50e3, kFull - 40e3 * elapsed), 40e3 * 0.5 * kStep) << i;
    }
    EXPECT_DOUBLE_EQ(found.back(), 50e3);
  }
}

// The first step is cut where the gas begins to leave: no error of the time.
TEST(Deflation, StepsDoNotMatter) {
  const DeflationParameters parameters{.starts_at = DeflationStart::time, .start = 0.35, .rate = 40e3, .pressure = 1};
  Deflation coarse(parameters, kFull, times_of(0, 1)), fine(parameters, kFull, times_of(0, 1));
  for (int i = 0; i < 10; ++i) coarse.update(0.1 * i, 0.1);
  for (int i = 0; i < 1000; ++i) fine.update(0.001 * i, 0.001);
  EXPECT_NEAR(coarse.pressure(), kFull - 40e3 * 0.65, 1e-6);
  EXPECT_NEAR(fine.pressure(), kFull - 40e3 * 0.65, 1e-6);
}

TEST(Deflation, NeverLetsNothingOut) {
  Deflation never({}, kFull, times_of(0, 1)),
      unknown({.starts_at = DeflationStart::closing}, kFull, std::make_shared<CaptureTimes>()),
      not_inflated({.starts_at = DeflationStart::time}, 0, times_of(0, 1));
  for (Deflation* deflation : {&never, &unknown, &not_inflated}) {
    for (int i = 0; i < 100; ++i) deflation->update(i, 1);
    EXPECT_EQ(deflation->part(), 1);
  }
}

// Other parameters act from then on, without a jump. Gas does not come back.
TEST(Deflation, ChangesWithoutAJump) {
  DeflationParameters parameters{.starts_at = DeflationStart::time, .rate = 100e3, .pressure = 10e3};
  Deflation deflation(parameters, kFull, times_of(0, 1));
  deflation.update(0, 1);
  EXPECT_DOUBLE_EQ(deflation.part(), 0.5);
  parameters.rate = 20e3;
  parameters.start = 1;
  parameters.pressure = 80e3;
  deflation.change(parameters, kFull);
  EXPECT_DOUBLE_EQ(deflation.pressure(), 100e3);
  deflation.update(1, 0.5);
  EXPECT_DOUBLE_EQ(deflation.pressure(), 90e3);
  parameters.pressure = 150e3;
  deflation.change(parameters, kFull);
  deflation.update(1.5, 0.5);
  EXPECT_DOUBLE_EQ(deflation.pressure(), 90e3);
}

TEST(Deflation, Resumes) {
  test::expect_resumes(Deflation({.starts_at = DeflationStart::closing, .rate = 10e3}, kFull, times_of(0.1, 1)),
                       [](Deflation& deflation, int i) {
                         deflation.update(0.1 * i, 0.1);
                         return deflation.pressure();
                       });
}

}  // namespace
}  // namespace netpocket
