// What towing asks of the spacecraft.
#include "engine/dynamics/towing.h"

#include <gtest/gtest.h>

#include <numbers>

namespace netpocket {
namespace {

Eigen::Vector3d point_of_thrust(double offset, double angle) {
  TowingParameters towing;
  towing.start = 0;
  towing.offset = offset;
  towing.offset_angle = angle;
  return SpacecraftDrive(towing, StationKeeping::free, 1).at(1, 0).point;
}

// Geometry; tolerance: round-off.
TEST(Towing, LineOfThrustIsOffInItsDirection) {
  EXPECT_EQ(point_of_thrust(0.005, 0), Eigen::Vector3d(0.005, 0, 0));  // to the last bit: the plane of symmetry stays
  EXPECT_TRUE(point_of_thrust(2, std::numbers::pi / 2).isApprox(Eigen::Vector3d(0, 0, 2), 1e-15));
  EXPECT_TRUE(point_of_thrust(2, std::numbers::pi / 6).isApprox(Eigen::Vector3d(std::sqrt(3.0), 0, 1), 1e-15));
}

TEST(Towing, PullsOnlyFromItsStart) {
  TowingParameters towing;
  towing.start = 10;
  SpacecraftDrive drive(towing, StationKeeping::free, 1000);
  EXPECT_EQ(drive.at(9.9, 0).force, Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(drive.at(9.9, 0).point, Eigen::Vector3d(0, 0, 0));
  // Half way the thrust is the whole: size times mass, towards -Y.
  EXPECT_EQ(drive.at(10 + towing.duration / 2, 0).force, Eigen::Vector3d(0, -1000 * towing.size, 0));
}

}  // namespace
}  // namespace netpocket
