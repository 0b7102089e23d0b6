// PID by hand-computed numbers, its closed loop, and its limits.

#include "engine/control/pid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/control/position_pid.h"

namespace netpocket {
namespace {

// By hand: -(3 * 2 + 4 * 1) - 5 * 2 * 0.1 = -11, and -12 at the next period.
TEST(Pid, SumsItsThreeParts) {
  Pid pid({.proportional = 3, .integral = 5, .derivative = 4});
  EXPECT_DOUBLE_EQ(pid.update(2, 1, 0.1), -11);
  EXPECT_DOUBLE_EQ(pid.update(2, 1, 0.1), -12);
  EXPECT_DOUBLE_EQ(pid.update(2, 1, 0.1, 100), 87);
}

// With conditional integration the demand leaves its limit as soon as the error changes its sign.
TEST(Pid, DoesNotWindUp) {
  Pid pid({.proportional = 1, .integral = 1, .least = -2, .most = 2});
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(pid.update(-5, 0, 0.1), 2);
  EXPECT_LT(std::abs(pid.integral()), 2);
  EXPECT_LT(pid.update(0.5, 0, 0.1), 0);
}

// A mass m under a steady force: the integral takes it up. Routh: stable for P D > m I.
TEST(PositionPid, TakesUpASteadyForce) {
  constexpr double kMass = 1200, kPeriod = 0.01;
  const Eigen::Vector3d load(5, -7, 3);
  const PidSettings axis = {.proportional = 300, .integral = 30, .derivative = 800};
  PositionPid pid({axis, axis, axis}, kMass);
  BodyState body;
  WantedMotion wanted;
  wanted.state.position = {1, 2, 3};
  for (int i = 0; i < 20'000; ++i) {
    const Wrench demand = pid.update(body, wanted, kPeriod);
    EXPECT_EQ(demand.torque.norm(), 0);
    body.velocity += kPeriod / kMass * (demand.force + load);
    body.position += kPeriod * body.velocity;
  }
  EXPECT_NEAR((body.position - wanted.state.position).norm(), 0, 1e-6);
  EXPECT_NEAR((pid.update(body, wanted, kPeriod).force + load).norm(), 0, 1e-3);
}

// A wanted acceleration is fed forward: without an error the force is m a.
TEST(PositionPid, FeedsTheWantedAccelerationForward) {
  PositionPid pid({PidSettings{.proportional = 1}, PidSettings{}, PidSettings{}}, 10);
  WantedMotion wanted;
  wanted.acceleration = {1, 2, 3};
  EXPECT_EQ(pid.update({}, wanted, 0.1).force, Eigen::Vector3d(10, 20, 30));
}

}  // namespace
}  // namespace netpocket
