// The satellite: its parts touch but do not overlap, and it is where its volume is.

#include <gtest/gtest.h>

#include <random>

#include "engine/bodies/shape.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

const Satellite kSatellite({.bus = {2, 2.4, 1.8}, .span = 8.4, .panel_width = 1.7, .dish_diameter = 1.6});

double part_distance(const Satellite::Part& part, const Vector3d& point) {
  return std::visit(
      [&](const auto& solid) { return nearest_surface_point(Shape(solid), point - part.centre).distance; }, part.solid);
}

class RandomPoints {
 public:
  static constexpr double kVolume = 10 * 6 * 4;  // m^3, that they fill

  Vector3d next() { return {5 * unit_(random_), 3 * unit_(random_), 2 * unit_(random_)}; }

 private:
  std::mt19937 random_{3};
  std::uniform_real_distribution<double> unit_{-1, 1};
};

TEST(Satellite, HasItsDimensions) {
  const Eigen::AlignedBox3d box = extents(kSatellite);
  EXPECT_NEAR(box.sizes().x(), 8.4, 1e-14);
  EXPECT_NEAR(box.sizes().z(), 1.8, 1e-14);
  EXPECT_NEAR(box.max().x(), 4.2, 1e-14);
  EXPECT_GT(box.sizes().y(), 2.4 + 0.3 * 1.6);
  EXPECT_GE(bounding_radius(kSatellite), 4.2);
  EXPECT_LT(bounding_radius(kSatellite), 4.4);
}

TEST(Satellite, PartsDoNotOverlap) {
  RandomPoints points;
  for (int i = 0; i < 100000; ++i) {
    const Vector3d point = points.next();
    int inside = 0;
    for (const Satellite::Part& part : kSatellite.parts()) inside += part_distance(part, point) < -1e-12;
    ASSERT_LE(inside, 1) << point.transpose();
  }
}

TEST(Satellite, VolumeCentreAndInertiaAreThoseOfManyPoints) {
  RandomPoints points;
  constexpr int kTrials = 1'000'000;
  double count = 0;
  Vector3d first = Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (int i = 0; i < kTrials; ++i) {
    const Vector3d point = points.next();
    if (nearest_surface_point(kSatellite, point).distance >= 0) continue;
    ++count;
    first += point;
    second += point * point.transpose();
  }
  // Some 40,000 points are inside: their mean is good to 0.5 % of the size.
  EXPECT_NEAR(volume(kSatellite) / (count / kTrials * RandomPoints::kVolume), 1, 0.02);
  EXPECT_LT((first / count).norm(), 0.02);
  second /= count;
  const Eigen::Matrix3d inertia = second.trace() * Eigen::Matrix3d::Identity() - second;
  EXPECT_LT((solid_inertia(kSatellite, 1) - inertia).norm(), 0.03 * inertia.norm());
}

TEST(Satellite, DistanceOutsideIsExact) {
  RandomPoints points;
  for (int i = 0; i < 5000; ++i) {
    const Vector3d point = points.next();
    const SurfacePoint found = nearest_surface_point(kSatellite, point);
    if (found.distance < 0) continue;
    double least = HUGE_VAL;
    for (const Satellite::Part& part : kSatellite.parts()) least = std::min(least, part_distance(part, point));
    EXPECT_EQ(found.distance, least);
    EXPECT_NEAR(found.normal.norm(), 1, 1e-15);
    EXPECT_NEAR(nearest_surface_point(kSatellite, point - found.distance * found.normal).distance, 0, 1e-14);
  }
}

TEST(Satellite, BoundsHoldItWhateverItsAttitude) {
  RandomPoints points;
  const Vector3d position(1, -2, 3);
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(0.8, Vector3d(1, 2, -2) / 3).toRotationMatrix();
  const Eigen::AlignedBox3d box = bounding_box(kSatellite, position, rotation);
  for (int i = 0; i < 20000; ++i) {
    const Vector3d point = points.next();
    if (nearest_surface_point(kSatellite, point).distance > 0) continue;
    ASSERT_TRUE(box.contains(position + rotation * point));
    ASSERT_LE(point.norm(), bounding_radius(kSatellite));
  }
}

}  // namespace
}  // namespace netpocket
