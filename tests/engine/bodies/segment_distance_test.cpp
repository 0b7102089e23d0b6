#include "engine/bodies/segment_distance.h"

#include <fcl/fcl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <random>

namespace netpocket {
namespace {

using Eigen::Vector3d;

double distance_to_segment(const Vector3d& point, const Segment& s) {
  const Vector3d d = s.end - s.start;
  const double f = d.squaredNorm() > 0 ? std::clamp(d.dot(point - s.start) / d.squaredNorm(), 0.0, 1.0) : 0.0;
  return (s.start + f * d - point).norm();
}

// The distance of a point of the first segment from the second is a convex function, so a ternary search finds it.
double searched_distance(const Segment& a, const Segment& b) {
  double low = 0, high = 1;
  const auto at = [&](double f) { return distance_to_segment(a.start + f * (a.end - a.start), b); };
  for (int i = 0; i < 120; ++i) {
    const double third = (high - low) / 3;
    if (at(low + third) < at(high - third))
      high -= third;
    else
      low += third;
  }
  return at(0.5 * (low + high));
}

class RandomSegments {
 public:
  Vector3d point() { return {coordinate_(random_), coordinate_(random_), coordinate_(random_)}; }
  Segment segment() { return {point(), point()}; }
  // Turned from the direction of another one by no more than about `angle` rad.
  Segment nearly_parallel(const Segment& other, double angle) {
    const Vector3d start = point();
    return {start, start + (other.end - other.start) + angle * point()};
  }

 private:
  std::mt19937 random_{11};
  std::uniform_real_distribution<double> coordinate_{-1, 1};
};

void expect_consistent(const Segment& a, const Segment& b, const SegmentDistance& found) {
  EXPECT_GE(found.first_fraction, 0);
  EXPECT_LE(found.first_fraction, 1);
  EXPECT_GE(found.second_fraction, 0);
  EXPECT_LE(found.second_fraction, 1);
  EXPECT_LT((a.start + found.first_fraction * (a.end - a.start) - found.first_point).norm(), 1e-15);
  EXPECT_LT((b.start + found.second_fraction * (b.end - b.start) - found.second_point).norm(), 1e-15);
  EXPECT_NEAR((found.first_point - found.second_point).norm(), found.distance, 1e-15);
}

TEST(SegmentDistance, IsThatOfASearch) {
  RandomSegments random;
  double largest_error = 0;
  for (int i = 0; i < 5000; ++i) {
    const Segment a = random.segment(), b = random.segment();
    const SegmentDistance found = closest_points(a, b);
    expect_consistent(a, b, found);
    largest_error = std::max(largest_error, std::abs(found.distance - searched_distance(a, b)));
    EXPECT_NEAR(found.distance, closest_points(b, a).distance, 1e-14);
  }
  std::printf("largest error %.1e m\n", largest_error);
  // The search stops where the distance is flat, sqrt(1e-16) from the minimum, where it is right to round-off.
  EXPECT_LT(largest_error, 1e-14);
}

TEST(SegmentDistance, StaysExactForNearlyParallelSegments) {
  RandomSegments random;
  for (double angle : {1e-3, 1e-6, 1e-8, 1e-10, 1e-13, 1e-15, 0.0}) {
    double largest_error = 0;
    for (int i = 0; i < 2000; ++i) {
      const Segment a = random.segment(), b = random.nearly_parallel(a, angle);
      const SegmentDistance found = closest_points(a, b);
      expect_consistent(a, b, found);
      largest_error = std::max(largest_error, std::abs(found.distance - searched_distance(a, b)));
    }
    // Round-off of coordinates of order 1, and at 1e-14 rad the directions are taken as parallel.
    EXPECT_LT(largest_error, 3e-14) << "angle " << angle;
  }
}

// FCL's capsules lie along z, centred.
fcl::CollisionObjectd capsule(const Segment& s, double radius) {
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  pose.translation() = 0.5 * (s.start + s.end);
  pose.linear() = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), s.end - s.start).toRotationMatrix();
  return {std::make_shared<fcl::Capsuled>(radius, (s.end - s.start).norm()), pose};
}

TEST(SegmentDistance, IsThatOfFclForCapsules) {
  RandomSegments random;
  const double radius = 0.002;
  double largest_error = 0;
  for (int i = 0; i < 1000; ++i) {
    const Segment a = random.segment(), b = random.segment();
    const SegmentDistance found = closest_points(a, b);
    if (found.distance < 3 * radius) continue;
    const fcl::CollisionObjectd first = capsule(a, radius), second = capsule(b, radius);
    fcl::DistanceResultd result;
    largest_error = std::max(largest_error, std::abs(fcl::distance(&first, &second, fcl::DistanceRequestd(), result) +
                                                     2 * radius - found.distance));
  }
  std::printf("largest difference from FCL %.1e m\n", largest_error);
  EXPECT_LT(largest_error, 1e-6);  // FCL's own tolerance for capsules
}

TEST(SegmentDistance, SpecialPositions) {
  const Segment x{{0, 0, 0}, {1, 0, 0}};
  // Crossing, one above the other.
  const SegmentDistance cross = closest_points(x, {{0.25, -1, 0.5}, {0.25, 1, 0.5}});
  EXPECT_DOUBLE_EQ(cross.distance, 0.5);
  EXPECT_DOUBLE_EQ(cross.first_fraction, 0.25);
  EXPECT_DOUBLE_EQ(cross.second_fraction, 0.5);
  // Intersecting.
  EXPECT_EQ(closest_points(x, {{0.5, -1, 0}, {0.5, 1, 0}}).distance, 0);
  // Parallel side by side: the middle of the shared stretch, either way round.
  for (const Segment& other : {Segment{{0.5, 1, 0}, {2, 1, 0}}, Segment{{2, 1, 0}, {0.5, 1, 0}}}) {
    const SegmentDistance parallel = closest_points(x, other);
    EXPECT_DOUBLE_EQ(parallel.distance, 1);
    EXPECT_DOUBLE_EQ(parallel.first_fraction, 0.75);
  }
  // In line, apart and overlapping.
  EXPECT_DOUBLE_EQ(closest_points(x, {{3, 0, 0}, {2, 0, 0}}).distance, 1);
  EXPECT_EQ(closest_points(x, {{0.5, 0, 0}, {2, 0, 0}}).distance, 0);
  // The same segment.
  EXPECT_EQ(closest_points(x, x).distance, 0);
  // Points.
  EXPECT_DOUBLE_EQ(closest_points({{0.3, 2, 0}, {0.3, 2, 0}}, x).distance, 2);
  EXPECT_DOUBLE_EQ(closest_points(x, {{0.3, 2, 0}, {0.3, 2, 0}}).distance, 2);
  EXPECT_DOUBLE_EQ(closest_points({{0, 0, 0}, {0, 0, 0}}, {{0, 3, 4}, {0, 3, 4}}).distance, 5);
}

TEST(SegmentDistance, QuarterTurnAboutYIsExact) {
  const auto turned = [](const Vector3d& v) { return Vector3d(v.z(), v.y(), -v.x()); };
  RandomSegments random;
  for (int i = 0; i < 2000; ++i) {
    const Segment a = random.segment(), b = random.segment();
    const SegmentDistance here = closest_points(a, b);
    const SegmentDistance there = closest_points({turned(a.start), turned(a.end)}, {turned(b.start), turned(b.end)});
    ASSERT_EQ(here.distance, there.distance);
    ASSERT_EQ(turned(here.first_point), there.first_point);
  }
}

}  // namespace
}  // namespace netpocket
