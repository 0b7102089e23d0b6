// What a tracker remembers must not show in its answers.

#include "engine/contact/surface_tracker.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/engine/bodies/mesh_samples.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

class TrackerTest : public testing::TestWithParam<double> {};  // longest step, m

INSTANTIATE_TEST_SUITE_P(Steps, TrackerTest, testing::Values(1e-5, 1e-3, 0.03, 0.5));

TEST_P(TrackerTest, AnswersAreThoseOfTheMeshToTheLastBit) {
  constexpr std::size_t kPoints = 20;
  for (const MeshData& data : {samples::torus(3, 1, 60, 30), samples::wedge(), samples::geodesic_sphere(2, 12),
                               samples::cylinder(1, 3, 200)}) {
    const MeshShape shape = {samples::checked_mesh(data)};
    const Shape body = shape;
    SurfaceTracker tracker(body, kPoints);
    std::mt19937 random(17);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto direction = [&] { return Vector3d(unit(random), unit(random), unit(random)); };
    std::vector<Vector3d> points;
    for (std::size_t i = 0; i < kPoints; ++i) {  // within a few millimetres of the surface
      Vector3d point = 2 * shape.mesh->bounding_radius() * direction();
      const SurfacePoint found = shape.mesh->nearest(point);
      points.push_back(point - (found.distance - 0.004 * unit(random)) * found.normal);
    }
    int touching = 0;
    for (int step = 0; step < 300; ++step) {
      const double reach = step % 7 == 0 ? 0.05 : 0.002;
      for (std::size_t i = 0; i < kPoints; ++i) {
        points[i] += GetParam() * direction();
        const SurfacePoint exact = shape.mesh->nearest(points[i]);
        double clearance = 0;
        const auto found = tracker.nearest(i, points[i], reach, clearance);
        ASSERT_EQ(found.has_value(), exact.distance < reach);
        ASSERT_LE(clearance, exact.distance);
        if (!found) continue;
        ++touching;
        ASSERT_EQ(found->distance, exact.distance);
        ASSERT_EQ(found->normal, exact.normal);
      }
    }
    EXPECT_GT(touching, 10);
  }
}

TEST(Tracker, OtherShapesHaveTheirClosedForm) {
  const Shape sphere = Sphere{2};
  SurfaceTracker tracker(sphere, 1);
  double clearance = 0;
  EXPECT_FALSE(tracker.nearest(0, {0, 2.3, 0}, 0.1, clearance));
  EXPECT_NEAR(clearance, 0.3, 1e-15);
  EXPECT_NEAR(tracker.nearest(0, {0, 2.05, 0}, 0.1, clearance)->distance, 0.05, 1e-15);
}

TEST(Tracker, NotANumberTouchesNothing) {
  const Shape body = MeshShape{samples::checked_mesh(samples::wedge())};
  SurfaceTracker tracker(body, 1);
  double clearance = 0;
  EXPECT_FALSE(tracker.nearest(0, {NAN, 0, 0}, 0.1, clearance));
  EXPECT_TRUE(tracker.nearest(0, {0, 0, 0}, 0.1, clearance));
}

}  // namespace
}  // namespace netpocket
