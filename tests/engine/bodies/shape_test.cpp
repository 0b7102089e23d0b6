#include "engine/bodies/shape.h"

#include <fcl/fcl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace netpocket {
namespace {

using Eigen::Vector3d;

struct Case {
  std::string name;
  Shape shape;
};

// Unlike edges and radii, so that a mix-up of axes shows.
const std::vector<Case> kCases = {
    {"sphere", Sphere{4.5}}, {"box", Box{{1.6, 2.0, 6.0}}}, {"cylinder", Cylinder{0.7, 3.0}}};

class ShapeTest : public testing::TestWithParam<Case> {
 protected:
  // Random point in a box twice as large as the bounding sphere.
  Vector3d random_point() {
    const double reach = 2 * bounding_radius(GetParam().shape);
    std::uniform_real_distribution<double> coordinate(-reach, reach);
    return {coordinate(random_), coordinate(random_), coordinate(random_)};
  }
  // Random point of the surface: the foot of a random point, whose being on the surface another test shows.
  Vector3d random_surface_point() {
    const Vector3d point = random_point();
    const SurfacePoint nearest = nearest_surface_point(GetParam().shape, point);
    return point - nearest.distance * nearest.normal;
  }
  SurfacePoint nearest(const Vector3d& point) const { return nearest_surface_point(GetParam().shape, point); }

  std::mt19937 random_{7};
};

INSTANTIATE_TEST_SUITE_P(Shapes, ShapeTest, testing::ValuesIn(kCases),
                         [](const auto& info) { return info.param.name; });

// FCL's cylinder lies along its z axis.
fcl::CollisionObjectd fcl_object(const Shape& shape) {
  if (const auto* s = std::get_if<Sphere>(&shape))
    return fcl::CollisionObjectd(std::make_shared<fcl::Sphered>(s->radius));
  if (const auto* b = std::get_if<Box>(&shape)) return fcl::CollisionObjectd(std::make_shared<fcl::Boxd>(b->size));
  const auto& c = std::get<Cylinder>(shape);
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  pose.linear() = Eigen::AngleAxisd(-std::numbers::pi / 2, Vector3d::UnitX()).toRotationMatrix();
  return {std::make_shared<fcl::Cylinderd>(c.radius, c.length), pose};
}

TEST_P(ShapeTest, DistanceOutsideIsThatOfFcl) {
  const double probe_radius = 1e-3;
  fcl::CollisionObjectd body = fcl_object(GetParam().shape);
  fcl::CollisionObjectd probe(std::make_shared<fcl::Sphered>(probe_radius));
  double largest_error = 0;
  for (int tested = 0; tested < 1000;) {
    const Vector3d point = random_point();
    const SurfacePoint ours = nearest(point);
    if (ours.distance < 2 * probe_radius) continue;
    ++tested;
    probe.setTranslation(point);
    probe.computeAABB();
    fcl::DistanceResultd result;
    const double theirs = fcl::distance(&body, &probe, fcl::DistanceRequestd(), result) + probe_radius;
    largest_error = std::max(largest_error, std::abs(theirs - ours.distance));
  }
  RecordProperty("largest_error", std::to_string(largest_error));
  // FCL's closed forms for these pairs agree to round-off at distances of some metres.
  EXPECT_LT(largest_error, 1e-12);
}

TEST_P(ShapeTest, NormalsAreUnitAndLeadToTheSurface) {
  for (int i = 0; i < 2000; ++i) {
    const Vector3d point = i % 2 ? random_point() : random_point() / 4;  // half of them mostly inside
    const SurfacePoint found = nearest(point);
    EXPECT_NEAR(found.normal.norm(), 1, 4e-16) << point.transpose();
    const Vector3d foot = point - found.distance * found.normal;
    EXPECT_NEAR(nearest(foot).distance, 0, 1e-14) << point.transpose();
  }
}

TEST_P(ShapeTest, NoSurfacePointIsNearer) {
  std::vector<Vector3d> surface(2000);
  std::generate(surface.begin(), surface.end(), [this] { return random_surface_point(); });
  for (int i = 0; i < 500; ++i) {
    const Vector3d point = i % 2 ? random_point() : random_point() / 4;
    const double distance = std::abs(nearest(point).distance);
    for (const Vector3d& other : surface) ASSERT_GE((other - point).norm(), distance - 1e-14);
  }
}

TEST_P(ShapeTest, NormalIsTheGradientOfTheDistance) {
  const double h = 1e-6;
  for (int i = 0; i < 1000; ++i) {
    const Vector3d point = random_point() / 2;
    Vector3d gradient;
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d step = h * Vector3d::Unit(axis);
      gradient[axis] = (nearest(point + step).distance - nearest(point - step).distance) / (2 * h);
    }
    // Round-off: 1e-15 / h = 1e-9; truncation: h^2 over the squared distance to the axis, here above 1e-2.
    EXPECT_LT((gradient - nearest(point).normal).norm(), 1e-8) << point.transpose();
  }
}

TEST_P(ShapeTest, BoundingRadiusHoldsTheShapeAndTouchesIt) {
  double farthest = 0;
  for (int i = 0; i < 20000; ++i) farthest = std::max(farthest, random_surface_point().norm());
  const double radius = bounding_radius(GetParam().shape);
  EXPECT_LE(farthest, radius + 1e-14);
  EXPECT_GT(farthest, 0.999 * radius);
}

TEST_P(ShapeTest, BoundingBoxHoldsTheTurnedShapeAndTouchesIt) {
  const Vector3d position(1, -2, 3);
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(0.8, Vector3d(1, 2, -2) / 3).toRotationMatrix();
  const Eigen::AlignedBox3d box = bounding_box(GetParam().shape, position, rotation);
  Eigen::AlignedBox3d found;
  for (int i = 0; i < 50000; ++i) found.extend(position + rotation * random_surface_point());
  // 50,000 samples miss the extreme points by a per cent of the size at most.
  const double slack = 0.03 * bounding_radius(GetParam().shape);
  EXPECT_TRUE((found.min() - box.min()).minCoeff() > -1e-13 && (box.max() - found.max()).minCoeff() > -1e-13);
  EXPECT_LT((found.min() - box.min()).maxCoeff(), slack);
  EXPECT_LT((box.max() - found.max()).maxCoeff(), slack);
}

Vector3d quarter_turn(const Vector3d& v) { return {v.z(), v.y(), -v.x()}; }

TEST_P(ShapeTest, QuarterTurnAboutYIsExact) {
  Shape turned = GetParam().shape;
  if (Box* box = std::get_if<Box>(&turned)) std::swap(box->size.x(), box->size.z());
  for (int i = 0; i < 2000; ++i) {
    const Vector3d point = random_point() / 2;
    const SurfacePoint here = nearest(point);
    const SurfacePoint there = nearest_surface_point(turned, quarter_turn(point));
    ASSERT_EQ(here.distance, there.distance);
    ASSERT_EQ(quarter_turn(here.normal), there.normal);
  }
}

TEST_P(ShapeTest, CentreHasAnAnswer) {
  const SurfacePoint centre = nearest(Vector3d::Zero());
  EXPECT_EQ(centre.distance, -contact_radius(GetParam().shape));
  EXPECT_EQ(centre.normal.norm(), 1);
  const SurfacePoint beside = nearest({1e-200, 1e-200, -1e-200});
  EXPECT_NEAR(beside.distance, centre.distance, 1e-15);
  EXPECT_EQ(beside.normal.norm(), 1);
}

TEST(Box, InteriorEdgesAndCorners) {
  const Shape box = Box{{2, 4, 6}};
  const auto expect = [&](const Vector3d& point, double distance, const Vector3d& normal) {
    const SurfacePoint found = nearest_surface_point(box, point);
    EXPECT_NEAR(found.distance, distance, 1e-15) << point.transpose();
    EXPECT_LT((found.normal - normal).norm(), 1e-15) << point.transpose();
  };
  expect({0.75, 0, 0}, -0.25, {1, 0, 0});
  expect({0, -1.75, 0}, -0.25, {0, -1, 0});
  expect({0.25, 0, -2.5}, -0.5, {0, 0, -1});
  expect({1, 0.5, 0.5}, 0, {1, 0, 0});              // on a face
  expect({4, 6, 0}, 5, Vector3d(3, 4, 0) / 5);      // beside an edge
  expect({-3, -4, 4}, 3, Vector3d(-2, -2, 1) / 3);  // beside a corner
  expect({1, 2, 3}, 0, {0, 1, 0});                  // at a corner: y first
  expect({0.5, 0, 2.5}, -0.5, {1, 0, 0});           // on the medial plane: x where x z > 0
  expect({0.5, 0, -2.5}, -0.5, {0, 0, -1});         //                      z where x z < 0
}

TEST(Box, TiesOnTheMedialPlaneTurnWithASquareBox) {
  const Shape box = Box{{2, 8, 2}};
  for (Vector3d point : {Vector3d(0.5, 0.1, 0.5), Vector3d(-0.25, 0.3, 0.25)}) {
    for (int turn = 0; turn < 4; ++turn) {
      const Vector3d next = quarter_turn(point);
      EXPECT_EQ(quarter_turn(nearest_surface_point(box, point).normal), nearest_surface_point(box, next).normal);
      point = next;
    }
  }
}

TEST(Cylinder, InteriorRimAndAxis) {
  const Shape cylinder = Cylinder{2, 6};
  const auto expect = [&](const Vector3d& point, double distance, const Vector3d& normal) {
    const SurfacePoint found = nearest_surface_point(cylinder, point);
    EXPECT_NEAR(found.distance, distance, 2e-15) << point.transpose();
    EXPECT_LT((found.normal - normal).norm(), 1e-15) << point.transpose();
  };
  expect({0.9, 0, 1.2}, -0.5, {0.6, 0, 0.8});
  expect({0.9, 2.75, 1.2}, -0.25, {0, 1, 0});
  expect({0, 0, 0}, -2, {1, 0, 0});
  expect({0, -5, 0}, 2, {0, -1, 0});
  expect({3, 7, 4}, 5, {0.36, 0.8, 0.48});  // beside the rim: (3, 4) from it in the plane of (0.6, 0.8)
}

TEST(ContactRadius, IsTheSmallestRadiusOfCurvature) {
  EXPECT_EQ(contact_radius(Sphere{4.5}), 4.5);
  EXPECT_EQ(contact_radius(Box{{1.6, 2.0, 6.0}}), 0.8);
  EXPECT_EQ(contact_radius(Cylinder{0.7, 3.0}), 0.7);
}

TEST(SolidInertia, TextbookValues) {
  const auto diagonal = [](const Shape& shape) { return Vector3d(solid_inertia(shape, 12).diagonal()); };
  EXPECT_LT((diagonal(Sphere{5}) - Vector3d(120, 120, 120)).norm(), 1e-13);  // 2/5 m r^2
  EXPECT_LT((diagonal(Box{{1, 2, 3}}) - Vector3d(13, 10, 5)).norm(), 1e-13);
  EXPECT_LT((diagonal(Cylinder{2, 3}) - Vector3d(21, 24, 21)).norm(), 1e-13);
  // The target of the paper, 200 kg and 1210 kg m^2: a solid sphere of 3.889 m.
  EXPECT_NEAR(solid_inertia(Sphere{3.889}, 200)(0, 0), 1210, 0.5);
}

}  // namespace
}  // namespace netpocket
