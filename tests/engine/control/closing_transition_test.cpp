// Changes of the closing law in the midst of a run: nothing jumps, nothing is faster than what is asked for.

#include "engine/control/closing_transition.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace netpocket {
namespace {

constexpr double kOpenLength = 5.786;

ClosingParameters parameters_for(ClosingLaw law, double start, double duration) {
  ClosingParameters parameters;
  parameters.law = law;
  parameters.start = start;
  parameters.duration = duration;
  // Closes by half, is paid out again, and closes.
  parameters.table = {
      {0, kOpenLength}, {0.3 * duration, 3.5}, {0.5 * duration, 4.5}, {0.9 * duration, 2.2}, {duration, 2.1}};
  return parameters;
}

constexpr std::array kLaws = {ClosingLaw::cycloid, ClosingLaw::quintic, ClosingLaw::trapezoid, ClosingLaw::linear,
                              ClosingLaw::table};

double size_of_jump(const ClosingState& a, const ClosingState& b) {
  return std::max(
      {std::abs(a.length - b.length), std::abs(a.speed - b.speed), std::abs(a.acceleration - b.acceleration)});
}

// What every transition keeps.
void expect_no_blow(const ClosingTransition& transition, const ClosingSchedule& schedule, double now,
                    const ClosingState& before) {
  // Round-off of numbers up to 10.
  EXPECT_LT(size_of_jump(transition.at(now), before), 1e-12);
  const double just_before = std::max(now, transition.end() - 1e-9);
  EXPECT_LT(size_of_jump(transition.at(just_before), schedule.at(just_before)), 1e-5);
  const double fastest = std::max({1.1 * schedule.fastest(), 1.1 * std::abs(before.speed), 0.01 * kOpenLength});
  const double shortest = std::min(before.length, schedule.shortest()) - 0.25 * std::abs(before.speed);
  constexpr int kCount = 2000;
  const double end = transition.end() + 0.1;
  for (int i = 1; i <= kCount; ++i) {
    const double time = now + (end - now) * i / kCount, h = 1e-5;
    const ClosingState state = transition.at(time);
    // Between the places that the transition itself looks at, the speed may be some 1e-3 larger.
    EXPECT_LE(std::abs(state.speed), 1.003 * fastest) << time;
    EXPECT_LE(state.length, kOpenLength) << time;
    EXPECT_GE(state.length, std::max(shortest, 0.2) - 1e-6) << time;
    if (std::abs(time - now) < 2 * h || std::abs(time - transition.end()) < 2 * h || time > transition.end()) continue;
    const double speed = (transition.at(time + h).length - transition.at(time - h).length) / (2 * h);
    EXPECT_NEAR(state.speed, speed, 1e-5) << time;  // h^2/6 times the third derivative, below 1e5 m/s^3
  }
  // From its end on the new law rules.
  for (const double later : {0.0, 0.5, 3.0, 100.0})
    EXPECT_EQ(transition.at(transition.end() + later), schedule.at(transition.end() + later));
}

TEST(ClosingTransition, EveryLawToEveryOtherAtAnyTime) {
  for (const ClosingLaw old_law : kLaws) {
    const ClosingSchedule before(parameters_for(old_law, 1, 6), kOpenLength);
    for (const ClosingLaw new_law : kLaws) {
      for (const auto& [start, duration] : {std::pair(1.0, 6.0), {1.0, 2.0}, {1.0, 20.0}, {5.0, 4.0}, {0.0, 0.5}}) {
        const ClosingSchedule after(parameters_for(new_law, start, duration), kOpenLength);
        for (double now = 0.3; now < 8; now += 0.37) {
          SCOPED_TRACE(testing::Message() << static_cast<int>(old_law) << " to " << static_cast<int>(new_law)
                                          << ", start " << start << ", duration " << duration << ", at " << now);
          expect_no_blow(ClosingTransition(after, now, before.at(now)), after, now, before.at(now));
          ASSERT_FALSE(HasFailure());
        }
      }
    }
  }
}

// A change upon a change starts from where the first one has come.
TEST(ClosingTransition, AChangeUponAChange) {
  const ClosingSchedule first(parameters_for(ClosingLaw::cycloid, 0, 10), kOpenLength);
  const ClosingSchedule second(parameters_for(ClosingLaw::linear, 0, 5), kOpenLength);
  const ClosingSchedule third(parameters_for(ClosingLaw::table, 0, 12), kOpenLength);
  const ClosingTransition to_second(second, 3, first.at(3));
  for (const double now : {3.01, 3.2, 3.6, 4.5}) {
    SCOPED_TRACE(now);
    expect_no_blow(ClosingTransition(third, now, to_second.at(now)), third, now, to_second.at(now));
  }
}

TEST(ClosingTransition, ALawThatAsksForThePresentStateRulesAtOnce) {
  const ClosingSchedule before(parameters_for(ClosingLaw::cycloid, 4, 6), kOpenLength);
  const ClosingSchedule after(parameters_for(ClosingLaw::linear, 2, 3), kOpenLength);
  EXPECT_EQ(ClosingTransition(after, 1, before.at(1)).end(), 1);
  EXPECT_EQ(ClosingTransition(before, 7, before.at(7)).end(), 7);
  for (double time = 1; time < 8; time += 0.1)
    EXPECT_EQ(ClosingTransition(after, 1, before.at(1)).at(time), after.at(time));
}

// A slightly other law is reached within half a second, and a law that has ended is caught up with as fast as it was
// itself: a rest-to-rest quintic is 15/8 times as fast as on average.
TEST(ClosingTransition, IsAsShortAsTheSpeedAllows) {
  const ClosingSchedule before(parameters_for(ClosingLaw::cycloid, 0, 10), kOpenLength);
  const ClosingSchedule slightly(parameters_for(ClosingLaw::cycloid, 0, 10.05), kOpenLength);
  EXPECT_NEAR(ClosingTransition(slightly, 4, before.at(4)).end(), 4.5, 1e-12);
  const ClosingSchedule ended(parameters_for(ClosingLaw::cycloid, 0, 3), kOpenLength);
  const ClosingTransition late(ended, 5, before.at(5));
  const double way = before.at(5).length - 2.1, fastest = 1.1 * ended.fastest();
  EXPECT_GT(late.end() - 5, way / fastest);
  EXPECT_LT(late.end() - 5, 1.1 * 15.0 / 8 * way / fastest);
}

// Ropes that run in fast are paid out again: they must first come to rest.
TEST(ClosingTransition, TurnsRound) {
  const ClosingSchedule before(parameters_for(ClosingLaw::linear, 0, 2), kOpenLength);
  const ClosingSchedule open_again(parameters_for(ClosingLaw::cycloid, 50, 10), kOpenLength);
  for (const double now : {0.2, 1.0, 1.9, 1.99}) {
    SCOPED_TRACE(now);
    const ClosingTransition transition(open_again, now, before.at(now));
    expect_no_blow(transition, open_again, now, before.at(now));
    EXPECT_EQ(transition.at(40).length, kOpenLength);
  }
}

TEST(ClosingSchedule, KnowsItsLargestSpeedAndLeastLength) {
  for (const ClosingLaw law : kLaws) {
    const ClosingSchedule schedule(parameters_for(law, 0, 10), kOpenLength);
    double fastest = 0, shortest = kOpenLength;
    for (int i = 1; i < 20000; ++i) {
      const ClosingState state = schedule.at(10.0 * i / 20000);
      fastest = std::max(fastest, std::abs(state.speed));
      shortest = std::min(shortest, state.length);
    }
    EXPECT_NEAR(schedule.fastest(), fastest, 1e-5 * fastest) << static_cast<int>(law);
    EXPECT_NEAR(schedule.shortest(), shortest, 3e-4) << static_cast<int>(law);
  }
}

}  // namespace
}  // namespace netpocket
