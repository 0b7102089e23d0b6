#include <gtest/gtest.h>

#include <numbers>

#include "gui/workbench/viewport/orbit_camera.h"

namespace netpocket {
namespace {

constexpr double kPixels = 1e-6;  // round-off of a projection
const QSizeF kSize(800, 600);

CameraView view(double half_height) { return {{3, 4, 12}, {0.5, 1, -2}, {0, 1, 0}, 40, half_height}; }

class OrbitCameraTest : public testing::TestWithParam<double> {};

// Perspective and parallel projection.
INSTANTIATE_TEST_SUITE_P(Projections, OrbitCameraTest, testing::Values(0.0, 3.0));

TEST_P(OrbitCameraTest, SeesItsFocalPointInTheMiddle) {
  const OrbitCamera camera(view(GetParam()));
  const auto point = camera.project(camera.view().focal_point, kSize);
  ASSERT_TRUE(point);
  EXPECT_NEAR(point->position.x(), 400, kPixels);
  EXPECT_NEAR(point->position.y(), 300, kPixels);
}

TEST_P(OrbitCameraTest, RayAndProjectionAreInverse) {
  const OrbitCamera camera(view(GetParam()));
  const QPointF pixel(123, 456);
  const ViewRay ray = camera.ray(pixel, kSize);
  for (const double distance : {1.0, 7.0, 50.0}) {
    const auto point = camera.project(ray.origin + distance * ray.direction, kSize);
    ASSERT_TRUE(point);
    EXPECT_NEAR(point->position.x(), pixel.x(), kPixels);
    EXPECT_NEAR(point->position.y(), pixel.y(), kPixels);
  }
}

TEST_P(OrbitCameraTest, PanMovesWhatIsSeenWithTheMouse) {
  OrbitCamera camera(view(GetParam()));
  const Eigen::Vector3d seen = camera.view().focal_point;
  camera.pan(0.25, 0.1);
  const auto point = camera.project(seen, kSize);
  EXPECT_NEAR(point->position.x(), 400 + 0.25 * 600, kPixels);
  EXPECT_NEAR(point->position.y(), 300 - 0.1 * 600, kPixels);
}

TEST_P(OrbitCameraTest, ZoomKeepsWhatIsUnderTheMouse) {
  OrbitCamera camera(view(GetParam()));
  const QPointF mouse(650, 150);
  const ViewRay ray = camera.ray(mouse, kSize);
  // The point under the mouse in the plane of the focal point.
  const Eigen::Vector3d forward = (camera.view().focal_point - camera.view().position).normalized();
  const double distance = (camera.view().focal_point - ray.origin).dot(forward) / ray.direction.dot(forward);
  const Eigen::Vector3d point = ray.origin + distance * ray.direction;
  camera.zoom_at(mouse, kSize, 1.7);
  const auto after = camera.project(point, kSize);
  EXPECT_NEAR(after->position.x(), mouse.x(), kPixels);
  EXPECT_NEAR(after->position.y(), mouse.y(), kPixels);
}

TEST_P(OrbitCameraTest, FullTurnComesBack) {
  OrbitCamera camera(view(GetParam()));
  const CameraView before = camera.view();
  for (int i = 0; i < 8; ++i) camera.orbit(std::numbers::pi / 4, 0);
  EXPECT_LT((camera.view().position - before.position).norm(), 1e-12 * 20);
}

TEST(OrbitCamera, DoesNotSeeBehindItself) {
  const OrbitCamera camera(view(0));
  EXPECT_FALSE(camera.project({5, 6, 40}, kSize));
}

}  // namespace
}  // namespace netpocket
