// Events happen once, at the time of their crossing.

#include "engine/control/event.h"

#include <gtest/gtest.h>

namespace netpocket {
namespace {

using Kind = EventCondition::Kind;

TEST(Event, TimeIsReached) {
  Event event({.kind = Kind::time, .level = 2.5});
  EXPECT_FALSE(event.look({.time = 0}));
  EXPECT_FALSE(event.look({.time = 2.4}));
  EXPECT_TRUE(event.look({.time = 2.6}));
  EXPECT_EQ(event.time(), 2.5);
}

// The value 3 t - 1 reaches 5 at t = 2; looks at 1.5 and 2.5 interpolate it.
TEST(Event, CrossingIsInterpolatedAndLatched) {
  Event rises({.kind = Kind::above, .level = 5}), falls({.kind = Kind::below, .level = -5});
  for (const double t : {0.5, 1.5, 2.5}) {
    EXPECT_EQ(rises.look({t, 3 * t - 1}), t > 2);
    EXPECT_EQ(falls.look({t, 1 - 3 * t}), t > 2);
  }
  EXPECT_DOUBLE_EQ(rises.time(), 2);
  EXPECT_DOUBLE_EQ(falls.time(), 2);
  EXPECT_TRUE(rises.look({3, 0}));  // latched
  EXPECT_DOUBLE_EQ(rises.time(), 2);
}

TEST(Event, HappensAtOnceIfTheConditionHoldsAtFirst) {
  Event event({.kind = Kind::above, .level = 5});
  EXPECT_TRUE(event.look({1, 7}));
  EXPECT_EQ(event.time(), 1);
}

// Inside from 1 to 2 s, and from 4 s on: for 1.5 s without a break first at 5.5 s.
TEST(Event, ConditionMustHoldWithoutABreak) {
  Event event({.kind = Kind::target_inside, .hold = 1.5});
  for (int i = 0; i <= 100; ++i) {
    const double t = 0.1 * i;
    const bool inside = (i >= 10 && i < 20) || i >= 40;
    EXPECT_EQ(event.look({.time = t, .target_inside = inside}), t > 5.45) << t;
  }
  EXPECT_NEAR(event.time(), 5.5, 1e-12);
}

}  // namespace
}  // namespace netpocket
