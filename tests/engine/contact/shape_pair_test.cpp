// Where two bodies touch: against closed forms, against FCL's yes or no, and under symmetry.

#include "engine/contact/shape_pair.h"

#include <fcl/narrowphase/collision.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/engine/bodies/mesh_samples.h"

namespace netpocket {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kSides = 64;  // of the prism that stands for a cylinder

Placement at(const Vector3d& position, const Matrix3d& rotation = Matrix3d::Identity()) { return {position, rotation}; }

std::vector<Touch> touches_of(const Shape& first, const Placement& first_at, const Shape& second,
                              const Placement& second_at) {
  const TouchableShape a(first), b(second);
  ShapePair pair(a, b);
  std::vector<Touch> touches;
  pair.find(first_at, second_at, touches);
  return touches;
}

double deepest(const std::vector<Touch>& touches) {
  double depth = 0;
  for (const Touch& touch : touches) depth = std::max(depth, touch.depth);
  return depth;
}

Shape mesh_shape(const MeshData& data) { return MeshShape{samples::checked_mesh(data)}; }

class RandomSolids {
 public:
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
  Vector3d vector() { return {number(-1, 1), number(-1, 1), number(-1, 1)}; }
  Matrix3d rotation() { return Eigen::AngleAxisd(number(0, 6), vector().normalized()).toRotationMatrix(); }
  // Not a sphere.
  Shape solid() {
    if (number(0, 1) < 0.5) return Box{Vector3d(number(0.1, 2), number(0.1, 2), number(0.1, 2))};
    return Cylinder{number(0.1, 1), number(0.1, 2)};
  }

 private:
  std::mt19937 generator_{7};
};

// `shrink`: of cylinders' radii.
std::shared_ptr<fcl::CollisionGeometryd> geometry(const Shape& shape, double shrink) {
  if (const Box* box = std::get_if<Box>(&shape)) return std::make_shared<fcl::Boxd>(box->size);
  const Cylinder& cylinder = std::get<Cylinder>(shape);
  return std::make_shared<fcl::Cylinderd>(shrink * cylinder.radius, cylinder.length);
}

bool fcl_overlap(const Shape& first, const Placement& first_at, const Shape& second, const Placement& second_at,
                 double shrink) {
  const auto object = [shrink](const Shape& shape, const Placement& place) {
    Matrix3d rotation = place.rotation;
    if (std::holds_alternative<Cylinder>(shape)) {  // FCL's cylinders stand along z
      rotation = place.rotation * Eigen::AngleAxisd(-std::numbers::pi / 2, Vector3d::UnitX()).toRotationMatrix();
    }
    return fcl::CollisionObjectd(geometry(shape, shrink), rotation, place.position);
  };
  const fcl::CollisionObjectd a = object(first, first_at), b = object(second, second_at);
  fcl::CollisionResultd result;
  return fcl::collide(&a, &b, fcl::CollisionRequestd(1, false), result) > 0;
}

TEST(ShapePair, FindsWhateverFclSaysOverlaps) {
  RandomSolids random;
  int together = 0, apart = 0;
  for (int i = 0; i < 4000; ++i) {
    const Shape first = random.solid(), second = random.solid();
    const Placement one = at(random.number(0.2, 1) * random.vector(), random.rotation());
    const Placement two = at(random.number(0.2, 1) * random.vector(), random.rotation());
    const std::vector<Touch> touches = touches_of(first, one, second, two);
    // The prism lies between the cylinder and one that is thinner by its sagitta.
    if (fcl_overlap(first, one, second, two, std::cos(std::numbers::pi / kSides))) {
      EXPECT_FALSE(touches.empty()) << i;
      ++together;
    }
    if (!fcl_overlap(first, one, second, two, 1)) {
      EXPECT_TRUE(touches.empty()) << i;
      ++apart;
    }
  }
  EXPECT_GT(together, 500);
  EXPECT_GT(apart, 500);
}

// The greatest depth is the least way along the normal that parts the two.
TEST(ShapePair, DepthPartsThem) {
  RandomSolids random;
  int tried = 0;
  for (int i = 0; i < 2000; ++i) {
    const Shape first = random.solid(), second = random.solid();
    const Placement one = at(random.number(0.2, 1) * random.vector(), random.rotation());
    const Placement two = at(random.number(0.2, 1) * random.vector(), random.rotation());
    const std::vector<Touch> touches = touches_of(first, one, second, two);
    if (touches.empty()) continue;
    ++tried;
    // A face that is taken instead of edges that are nearly as good is off by one hundredth of the smaller radius.
    const double tolerance = 0.011 * std::min(bounding_radius(first), bounding_radius(second));
    Placement moved = one;
    moved.position += (deepest(touches) + tolerance) * touches.front().normal;
    EXPECT_TRUE(touches_of(first, moved, second, two).empty()) << i;
    moved.position = one.position + 0.9 * deepest(touches) * touches.front().normal;
    EXPECT_FALSE(touches_of(first, moved, second, two).empty()) << i;
  }
  EXPECT_GT(tried, 500);
}

// First touches are shallow, whichever feature they are of: no jump when an axis takes over, down to a hundredth of the
// smaller radius. A corner that clipping makes may move a little faster than the solids.
TEST(ShapePair, DepthIsContinuous) {
  RandomSolids random;
  for (int i = 0; i < 100; ++i) {
    const Shape first = random.solid(), second = random.solid();
    const Matrix3d rotation = random.rotation();
    const Vector3d way = random.vector().normalized();
    const double deep = 0.01 * std::min(bounding_radius(first), bounding_radius(second));
    const double way_of_step = 0.1 * deep;
    double before = 0;
    for (double distance = bounding_radius(first) + bounding_radius(second); before < deep; distance -= way_of_step) {
      const double depth = deepest(touches_of(first, at(distance * way, rotation), second, at(Vector3d::Zero())));
      EXPECT_LT(std::abs(depth - before), 1.5 * way_of_step) << i << " at " << distance;
      before = depth;
    }
  }
}

TEST(ShapePair, Spheres) {
  const auto touches = touches_of(Sphere{1}, at({0, 2.4, 0}), Sphere{1.5}, at({0, 0, 0}));
  ASSERT_EQ(touches.size(), 1);
  EXPECT_NEAR(touches[0].depth, 0.1, 1e-15);
  EXPECT_EQ(touches[0].normal, Vector3d::UnitY());
  EXPECT_NEAR(touches[0].point.y(), 1.45, 1e-15);
}

TEST(ShapePair, SphereOnEverythingElse) {
  const Shape sphere = Sphere{1};
  const std::vector<std::pair<Shape, double>> others = {
      {Box{{2, 3, 2}}, 1.5},
      {Cylinder{1, 3}, 1.5},
      {Satellite({{2, 2, 2}, 6, 1, 1}), Satellite({{2, 2, 2}, 6, 1, 1}).part(Satellite::kDish).centre.y() + 0.1},
      {mesh_shape(samples::box({2, 3, 2})), 1.5}};
  for (const auto& [shape, top] : others) {
    for (const bool swapped : {false, true}) {
      const Placement above = at({0.1, top + 1 - 1e-3, 0.05}), origin = at({0, 0, 0});
      const auto touches =
          swapped ? touches_of(shape, origin, sphere, above) : touches_of(sphere, above, shape, origin);
      ASSERT_EQ(touches.size(), 1);
      EXPECT_NEAR(touches[0].depth, 1e-3, 1e-12);
      EXPECT_NEAR(touches[0].normal.y(), swapped ? -1 : 1, 1e-12);
      EXPECT_NEAR(touches[0].point.y(), top - 0.5e-3, 1e-12);
    }
  }
}

// Level faces touch at the corners of what they share, all equally deep, whether aligned or not.
TEST(ShapePair, LevelFaces) {
  const Shape box = Box{{2, 2, 2}}, small = Box{{1, 1, 1}}, bar = Box{{6, 1, 1}};
  const Matrix3d turned = Eigen::AngleAxisd(0.3, Vector3d::UnitY()).toRotationMatrix();
  const Matrix3d crossed = (Matrix3d() << 0, 0, 1, 0, 1, 0, -1, 0, 0).finished();
  struct Case {
    Shape upper;
    double height;
    Vector3d place;
    Matrix3d rotation;
    Shape lower;
    std::size_t corners;
  };
  const std::vector<Case> cases = {{box, 2, {0, 0, 0}, Matrix3d::Identity(), box, 4},
                                   {box, 2, {0.3, 0, 0.4}, Matrix3d::Identity(), box, 4},
                                   {small, 1.5, {0.2, 0, 0}, turned, box, 4},
                                   {box, 1.5, {0.2, 0, 0}, turned, small, 4},
                                   {small, 1.5, {1, 0, 1}, turned, box, 4},
                                   {bar, 1, {0, 0, 0}, crossed, bar, 4},
                                   {Cylinder{0.5, 1}, 1.5, {0, 0, 0}, turned, box, 64},
                                   {box, 1.5, {0, 0, 0}, turned, Cylinder{0.5, 1}, 64},
                                   {Cylinder{1, 2}, 1.5, {0, 0, 0}, turned, small, 4}};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Case& c = cases[i];
    const auto touches =
        touches_of(c.upper, at(c.place + Vector3d(0, c.height - 1e-3, 0), c.rotation), c.lower, at({0, 0, 0}));
    EXPECT_EQ(touches.size(), c.corners) << i;
    for (const Touch& touch : touches) {
      EXPECT_NEAR(touch.depth, 1e-3, 1e-12) << i;
      EXPECT_NEAR(touch.normal.y(), 1, 1e-12) << i;
    }
  }
}

TEST(ShapePair, RidgesThatCross) {
  const Shape box = Box{{2, 2, 2}};
  const double ridge = std::sqrt(2.0);
  const Matrix3d about_x = Eigen::AngleAxisd(std::numbers::pi / 4, Vector3d::UnitX()).toRotationMatrix();
  const Matrix3d about_z = Eigen::AngleAxisd(std::numbers::pi / 4, Vector3d::UnitZ()).toRotationMatrix();
  for (const bool meshes : {false, true}) {
    const Shape shape = meshes ? mesh_shape(samples::box({2, 2, 2})) : box;
    const auto touches = touches_of(shape, at({0.1, 2 * ridge - 1e-3, 0.2}, about_x), shape, at({0, 0, 0}, about_z));
    ASSERT_EQ(touches.size(), 1);
    EXPECT_NEAR(touches[0].depth, 1e-3, 1e-12);
    EXPECT_NEAR((touches[0].normal - Vector3d::UnitY()).norm(), 0, 1e-12);
    EXPECT_NEAR((touches[0].point - Vector3d(0, ridge - 0.5e-3, 0.2)).norm(), 0, 1e-2);
  }
}

TEST(ShapePair, MeshesAreHeldLikeTheSolidsTheyStandFor) {
  const Shape ground = Box{{8, 2, 8}};
  for (const MeshData& data : {samples::box({2, 2, 2}), samples::cylinder(1, 2, 32)}) {
    const auto touches = touches_of(mesh_shape(data), at({0, 2 - 1e-3, 0}), ground, at({0, 0, 0}));
    double weight = 0;
    for (const Touch& touch : touches) {
      EXPECT_NEAR(touch.depth, 1e-3, 1e-9);
      EXPECT_NEAR(touch.normal.y(), 1, 1e-9);
      weight += touch.weight;
    }
    EXPECT_GT(weight, 1);
    EXPECT_LT(weight, 5);
  }
  // From below, too: corners of the box in the mesh.
  const auto touches = touches_of(mesh_shape(samples::box({8, 2, 8})), at({0, -2 + 1e-3, 0}), Box{{2, 2, 2}},
                                  at({0, 0, 0}, Eigen::AngleAxisd(0.2, Vector3d::UnitY()).toRotationMatrix()));
  ASSERT_EQ(touches.size(), 4);
  for (const Touch& touch : touches) EXPECT_NEAR(touch.normal.y(), -1, 1e-9);
}

// A pair that has watched its shapes move finds what one that sees them for the first time does.
TEST(ShapePair, MemoryChangesNothing) {
  RandomSolids random;
  const std::vector<Shape> shapes = {Box{{1, 2, 1}},
                                     Cylinder{0.5, 2},
                                     Sphere{1},
                                     mesh_shape(samples::box({1, 1, 2})),
                                     mesh_shape(samples::geodesic_sphere(1, 2)),
                                     Satellite({{1, 1, 1}, 4, 0.6, 0.8})};
  int met = 0;
  for (const Shape& first : shapes) {
    for (const Shape& second : shapes) {
      const TouchableShape a(first), b(second);
      ShapePair pair(a, b);
      Vector3d place(4, 0.3, 0.2);
      std::vector<Touch> touches;
      for (int i = 0; i < 300; ++i) {
        place.x() -= 0.01 + 0.02 * random.number(-1, 1);
        const Matrix3d turn = Eigen::AngleAxisd(0.01 * i, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
        const Placement one = at(place, turn), two = at({0, 0, 0.1});
        pair.find(one, two, touches);
        const auto fresh = touches_of(first, one, second, two);
        ASSERT_EQ(touches.size(), fresh.size());
        met += touches.empty() ? 0 : 1;
        for (std::size_t k = 0; k < touches.size(); ++k) {
          EXPECT_EQ(touches[k].depth, fresh[k].depth);
          EXPECT_EQ(touches[k].point, fresh[k].point);
        }
      }
    }
  }
  EXPECT_GT(met, 1000);
}

Vector3d quarter_turn(const Vector3d& v) { return {-v.z(), v.y(), v.x()}; }
Matrix3d quarter_turn(const Matrix3d& m) {
  Matrix3d turned;
  for (int i = 0; i < 3; ++i) turned.col(i) = quarter_turn(Vector3d(m.col(i)));
  return turned;
}

// What touches turns with the two bodies, to the last bit.
TEST(ShapePair, TurnsWithTheBodies) {
  RandomSolids random;
  int tried = 0;
  for (int i = 0; i < 500; ++i) {
    const Shape first = random.solid(), second = random.solid();
    const Placement one = at(0.5 * random.vector(), random.rotation());
    const Placement two = at(0.5 * random.vector(), random.rotation());
    const auto touches = touches_of(first, one, second, two);
    const auto turned = touches_of(first, at(quarter_turn(one.position), quarter_turn(one.rotation)), second,
                                   at(quarter_turn(two.position), quarter_turn(two.rotation)));
    ASSERT_EQ(touches.size(), turned.size()) << i;
    for (std::size_t k = 0; k < touches.size(); ++k) {
      ++tried;
      EXPECT_EQ(quarter_turn(touches[k].point), turned[k].point) << i;
      EXPECT_EQ(quarter_turn(touches[k].normal), turned[k].normal) << i;
      EXPECT_EQ(touches[k].depth, turned[k].depth) << i;
    }
  }
  EXPECT_GT(tried, 300);
}

TEST(ShapePair, LostStatesTouchNothing) {
  const double nan = std::nan("");
  EXPECT_TRUE(touches_of(Box{{1, 1, 1}}, at({nan, 0, 0}), Box{{1, 1, 1}}, at({0, 0, 0})).empty());
  EXPECT_TRUE(
      touches_of(Box{{1, 1, 1}}, at({0.1, 0, 0}, nan * Matrix3d::Ones()), Box{{1, 1, 1}}, at({0, 0, 0})).empty());
}

}  // namespace
}  // namespace netpocket
