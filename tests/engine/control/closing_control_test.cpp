// The closing law as a controller of wound ropes.
#include "engine/control/closing_control.h"

#include <gtest/gtest.h>

#include <cmath>

namespace netpocket {
namespace {

TEST(ClosingControl, FollowsTheLawOfEachRope) {
  const ClosingParameters closing;
  const ClosingControl control(closing, {5.0, 6.0, 5.0});
  for (const double time : {0.0, 3.0, 9.9, 12.0}) {
    for (const std::size_t rope : {0, 1, 2}) {
      const ClosingState law = ClosingSchedule(closing, rope == 1 ? 6.0 : 5.0).at(time);
      EXPECT_EQ(control.motion(rope, time), (RopeMotion{law.length, law.speed, law.acceleration}));
    }
  }
  EXPECT_EQ(control.shortest_length(1, 2, 4), ClosingSchedule(closing, 6).at(4).length);
  EXPECT_TRUE(std::isinf(control.shortest_length(3, 2, 4)));  // not one of its ropes
  EXPECT_EQ(control.suspicion(), "");
}

TEST(ClosingControl, ChangesTheLawWithoutAJump) {
  Scenario scenario;
  ClosingControl control(scenario.closing, {5.0});
  const RopeMotion before = control.motion(0, 4);
  scenario.towing.size *= 2;  // not its concern
  control.change(scenario, 4);
  EXPECT_EQ(control.motion(0, 4), before);
  scenario.closing.duration = 6;
  control.change(scenario, 4);
  const RopeMotion after = control.motion(0, 4);
  EXPECT_NEAR(after.length, before.length, 1e-12);
  EXPECT_NEAR(after.rate, before.rate, 1e-12);
  EXPECT_NEAR(after.acceleration, before.acceleration, 1e-12);
  EXPECT_EQ(control.motion(0, 100).length, scenario.closing.closed_length);

  // A saved state holds the change.
  std::vector<double> state;
  control.visit_state([&](double& number) { state.push_back(number); });
  ClosingControl restored(scenario.closing, {5.0});
  std::size_t next = 0;
  restored.visit_state([&](double& number) { number = state[next++]; });
  for (const double time : {4.0, 4.7, 5.9}) EXPECT_EQ(restored.motion(0, time), control.motion(0, time));
}

}  // namespace
}  // namespace netpocket
