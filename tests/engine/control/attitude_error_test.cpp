// Attitude errors against rotations of known axis and angle.

#include "engine/control/attitude_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/control/tracking_error.h"

namespace netpocket {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

Quaterniond turned(double angle, const Vector3d& axis) {
  return Quaterniond(Eigen::AngleAxisd(angle, axis.normalized()));
}

const Vector3d kAxis = Vector3d(1, -2, 2) / 3;
const Quaterniond kWanted = turned(0.8, {3, 1, -1});

// Euler's theorem: the error of an attitude turned by an angle about a body axis is that angle times the axis.
TEST(AttitudeError, IsTheRotationFromTheWantedAttitude) {
  for (const double angle : {1e-12, 1e-4, 0.3, 2.0, 3.1}) {
    const Vector3d error = attitude_error(kWanted * turned(angle, kAxis), kWanted);
    EXPECT_NEAR((error - angle * kAxis).norm(), 0, 1e-15 + 1e-15 * angle) << angle;
  }
  EXPECT_EQ(attitude_error(kWanted, kWanted).norm(), 0);
}

// Beyond half a turn the way back is shorter, whichever of the two quaternions of an attitude is given.
TEST(AttitudeError, GoesTheShorterWay) {
  const Quaterniond present = kWanted * turned(1.5 * kPi, kAxis);
  const Quaterniond same = Quaterniond(-present.coeffs());
  EXPECT_NEAR((attitude_error(present, kWanted) + 0.5 * kPi * kAxis).norm(), 0, 2e-15);
  EXPECT_NEAR((attitude_error(same, kWanted) + 0.5 * kPi * kAxis).norm(), 0, 2e-15);
  EXPECT_NEAR(attitude_error(kWanted * turned(kPi, kAxis), kWanted).norm(), kPi, 1e-15);
}

// Rotations by 90 degrees: a body turned about world z sees a world vector along x along its -y axis.
TEST(TrackingError, RateIsInBodyAxes) {
  BodyState present, wanted;
  present.attitude = turned(kPi / 2, Vector3d::UnitZ());
  present.angular_velocity = {0.5, 0, 0};
  wanted.angular_velocity = {0.2, 0, 0};
  const TrackingError error = rotation_error(present, wanted);
  EXPECT_NEAR((error.error - Vector3d(0, 0, kPi / 2)).norm(), 0, 1e-15);
  EXPECT_NEAR((error.rate - Vector3d(0, -0.3, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR((to_world_axes(present, error.rate) - Vector3d(0.3, 0, 0)).norm(), 0, 1e-15);
}

}  // namespace
}  // namespace netpocket
