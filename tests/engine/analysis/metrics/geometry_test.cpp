// Hulls, samples, cover, indices and loads with known values.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/analysis/metrics/convex_hull.h"
#include "engine/analysis/metrics/cord_utilisation.h"
#include "engine/analysis/metrics/net_cover.h"
#include "engine/analysis/metrics/net_geometry.h"
#include "engine/analysis/metrics/quality_index.h"
#include "engine/analysis/metrics/target_loads.h"
#include "engine/analysis/metrics/target_samples.h"
#include "tests/engine/analysis/metrics/hand_made_net.h"
#include "tests/engine/bodies/mesh_samples.h"

namespace netpocket {
namespace {

Eigen::Matrix3Xd box_corners(const Eigen::Vector3d& size, const Eigen::Vector3d& centre) {
  Eigen::Matrix3Xd corners(3, 8);
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d sign((i & 1) != 0 ? 0.5 : -0.5, (i & 2) != 0 ? 0.5 : -0.5, (i & 4) != 0 ? 0.5 : -0.5);
    corners.col(i) = centre + sign.cwiseProduct(size);
  }
  return corners;
}

TEST(ConvexHull, OfABoxIsTheBox) {
  Eigen::Matrix3Xd points = box_corners({1, 2, 3}, {5, 0, 0});
  points.conservativeResize(3, 10);
  points.col(8) << 5, 0, 0;        // inside
  points.col(9) << 5.5, 0.2, 0.3;  // on a face
  const auto hull = convex_hull(points);
  ASSERT_TRUE(hull);
  EXPECT_NEAR(hull->volume, 6, 1e-12);
  EXPECT_NEAR(hull->area, 22, 1e-12);
  EXPECT_NEAR(hull->signed_distance({5, 0, 0}), -0.5, 1e-12);
  EXPECT_NEAR(hull->signed_distance({6, 0, 0}), 0.5, 1e-12);
  EXPECT_TRUE(hull->contains({5.4, 0.9, 1.4}));
  EXPECT_FALSE(hull->contains({5.4, 1.1, 0}));
}

TEST(ConvexHull, OfATetrahedron) {
  Eigen::Matrix3Xd points(3, 4);
  points << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
  const auto hull = convex_hull(points);
  ASSERT_TRUE(hull);
  EXPECT_NEAR(hull->volume, 1.0 / 6, 1e-15);
  EXPECT_NEAR(hull->area, 1.5 + std::sqrt(3) / 2, 1e-14);
}

TEST(ConvexHull, IsNothingForFlatOrBrokenPoints) {
  EXPECT_FALSE(convex_hull(Eigen::Matrix3Xd::Zero(3, 3)));
  EXPECT_FALSE(convex_hull(Eigen::Matrix3Xd::Ones(3, 20)));
  Eigen::Matrix3Xd points = box_corners({1, 0, 3}, {0, 0, 0});
  EXPECT_FALSE(convex_hull(points));
  points = box_corners({1, 1, 1}, {0, 0, 0});
  points(1, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(convex_hull(points));
}

TEST(NetGeometry, KnowsMeshesAndMouth) {
  const HandMadeNet net = hand_made_bag(1.5);
  EXPECT_NEAR(mesh_size(net.structure), 1, 1e-15);
  EXPECT_EQ(net_nodes(net.structure).size(), 13u);
  EXPECT_EQ(rope_elements(net.structure).size(), 4u);
  const Eigen::Vector3d area = vector_area(mouth_polygon(net.structure, net.snapshot()));
  EXPECT_NEAR(area.norm(), 2.25, 1e-15);
  EXPECT_NEAR(std::abs(area.y()), 2.25, 1e-15);
  const auto segments = cord_segments(net.structure, net.snapshot(), rope_elements(net.structure));
  ASSERT_EQ(segments.size(), 16u);
  EXPECT_TRUE(segments[1].from.isApprox(Eigen::Vector3d(-0.375, 2, -0.75)));
}

// A side of a mesh of two elements counts once.
TEST(NetGeometry, JoinsTheElementsOfASide) {
  HandMadeNet net;
  const auto a = net.add_node({0, 0, 0}), middle = net.add_node({0.5, 0, 0}), b = net.add_node({1, 0, 0});
  net.add_cord(a, middle, PocketGroup::net, 0);
  net.add_cord(middle, b, PocketGroup::net, 0);
  EXPECT_NEAR(mesh_size(net.structure), 1, 1e-15);
  net.add_cord(middle, net.add_node({0.5, 1, 0}), PocketGroup::net, 1);
  EXPECT_NEAR(mesh_size(net.structure), 2.0 / 3, 1e-15);
  EXPECT_EQ(mesh_size(Structure{}), 0);
}

TEST(NetGeometry, FollowsBentCords) {
  HandMadeNet net;
  net.add_cord(net.add_node({0, 0, 0}), net.add_node({1, 0, 0}), PocketGroup::net);
  Snapshot snapshot = net.snapshot();
  snapshot.gradients.col(0) << 1, 1, 0;
  snapshot.gradients.col(1) << 1, -1, 0;
  // Cubic Hermite curve with end slopes 1 and -1: height 1/4 in the middle.
  const auto segments = cord_segments(net.structure, snapshot, {0}, 2);
  EXPECT_TRUE(segments[0].to.isApprox(Eigen::Vector3d(0.5, 0.25, 0)));
}

TEST(SurfaceSamples, LieEvenlyOnTheSurface) {
  const Shape shape = Box{{2, 1, 0.5}};
  const auto samples = surface_samples(shape, 4000);
  ASSERT_EQ(samples.size(), 4000u);
  int on_large_faces = 0;
  for (const SurfaceSample& sample : samples) {
    EXPECT_NEAR(nearest_surface_point(shape, sample.point).distance, 0, 1e-12);
    EXPECT_NEAR(sample.normal.norm(), 1, 1e-12);
    if (std::abs(sample.normal.z()) > 0.999) ++on_large_faces;
  }
  // Two faces of 2 m^2 of 7 m^2. The layer above the edges, 28 m long, takes about 2.5 %.
  EXPECT_NEAR(on_large_faces / 4000.0, 4.0 / 7, 0.025);
}

TEST(VolumeSamples, LieInside) {
  const auto samples = volume_samples(Sphere{2}, 2000);
  ASSERT_EQ(samples.size(), 2000u);
  double mean_square = 0;
  for (const Eigen::Vector3d& point : samples) {
    EXPECT_LE(point.norm(), 2);
    mean_square += point.squaredNorm() / 2000;
  }
  EXPECT_NEAR(mean_square, 0.6 * 4, 0.02);  // 3/5 R^2
}

TEST(SurfaceArea, IsThatOfEachShape) {
  EXPECT_NEAR(surface_area(Sphere{2}), 16 * std::numbers::pi, 1e-12);
  EXPECT_EQ(surface_area(Box{{1, 2, 3}}), 22);
  EXPECT_NEAR(surface_area(Cylinder{1, 3}), 8 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(surface_area(MeshShape{samples::checked_mesh(samples::box({1, 2, 3}))}), 22, 1e-12);
  EXPECT_EQ(characteristic_length(Box{{1, 2, 6}}), 3);
}

// One long cord 0.1 m above a line across a face of 2 m covers a strip of it.
TEST(CoveredShare, OfAStrip) {
  const double reach = 0.5, height = 0.1;
  const std::vector<CordSegment> cord = {{{-9, 1 + height, 0}, {9, 1 + height, 0}, 0.002}};
  std::vector<SurfaceSample> samples;
  for (double z = -0.995; z < 1; z += 0.01) samples.push_back({{0, 1, z}, {0, 1, 0}});
  const double strip = 2 * std::sqrt(reach * reach - height * height) / 2;
  EXPECT_NEAR(covered_share(samples, BodyState{}, cord, reach), strip, 0.01);
  // The same turned and moved.
  BodyState body;
  body.position = {3, -1, 2};
  body.attitude = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  const std::vector<CordSegment> moved = {
      {body.position + body.attitude * cord[0].from, body.position + body.attitude * cord[0].to, 0.002}};
  EXPECT_NEAR(covered_share(samples, body, moved, reach), strip, 0.01);
}

TEST(CoveredShare, NeedsACordOnTheOuterSide) {
  const std::vector<SurfaceSample> top = {{{0, 1, 0}, {0, 1, 0}}};
  EXPECT_EQ(covered_share(top, BodyState{}, {{{-1, 0.7, 0}, {1, 0.7, 0}, 0.002}}, 0.5), 0) << "below the surface";
  EXPECT_EQ(covered_share(top, BodyState{}, {{{-1, 1.3, 0}, {1, 1.3, 0}, 0.002}}, 0.5), 1);
  EXPECT_EQ(covered_share(top, BodyState{}, {{{-1, 1.6, 0}, {1, 1.6, 0}, 0.002}}, 0.5), 0) << "too far";
  EXPECT_TRUE(std::isnan(covered_share({}, BodyState{}, {}, 0.5)));
}

// A sphere of 1 m in the hull of a cube of 4 m, and one that is half outside.
TEST(QualityIndex, OfASphereInACube) {
  const TargetGeometry target(Sphere{1});
  const auto hull = convex_hull(box_corners({4, 4, 4}, {0, 0, 0}));
  BodyState body;
  const double volume = 4 * std::numbers::pi / 3, area = 4 * std::numbers::pi;
  QualityIndex index = quality_index(target, body, *hull, {0.5, 0, 0});
  EXPECT_NEAR(index.volume, (64 - volume) / volume, 1e-12);
  EXPECT_NEAR(index.surface, (96 - area) / area, 1e-12);
  EXPECT_NEAR(index.centre, 0.25, 1e-15);
  EXPECT_NEAR(index.value(), 0.1 * index.volume + 0.1 * index.surface + 0.2, 1e-12);
  ModifiedQualityIndex modified = modified_quality_index(target, body, *hull, 0.5);
  EXPECT_EQ(modified.outside, 0);
  // Distance of the sphere's points from the nearest face: 2 - E max(|x|, |y|, |z|). The mean follows from the view
  // factor of a square seen from above its middle.
  const double mean_largest = 3 * std::numbers::sqrt2 * std::atan(1 / std::numbers::sqrt2) / std::numbers::pi;
  EXPECT_NEAR(modified.distance, (2 - mean_largest) / 2, 0.003);
  EXPECT_NEAR(modified.value(), (modified.distance + 0.5) / 3, 1e-15);
  body.position = {2, 0, 0};
  modified = modified_quality_index(target, body, *hull, 0);
  EXPECT_NEAR(modified.outside, 0.5, 0.01);
}

TEST(TargetLoads, AreSummedByPart) {
  Structure structure;
  const Satellite satellite({.bus = {2, 2, 2}, .span = 10, .panel_width = 1, .dish_diameter = 1});
  structure.bodies = {{"target", BodyRole::target, satellite, 100}};
  Snapshot snapshot;
  snapshot.time = 3;
  BodyState body;
  body.position = {0, 5, 0};
  body.attitude = Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitZ());  // body x is world y
  snapshot.bodies = {body};
  const auto on = [&](Satellite::PartIndex part) {
    return Eigen::Vector3d(body.position + body.attitude * satellite.part(part).centre);
  };
  snapshot.contacts = {{on(Satellite::kRightPanel), {1, 0, 0}, 0, 0},
                       {on(Satellite::kRightPanel), {3, 3, 0}, 1, 0},
                       {on(Satellite::kLeftPanel), {0, 0, 2}, 1, 0},
                       {on(Satellite::kLeftPanel), {0, 0, 50}, 1, 7}};  // on another body
  TargetLoads loads;
  loads.add(structure, snapshot, 0);
  ASSERT_EQ(loads.largest().size(), 2u);
  EXPECT_EQ(loads.largest().at("right panel").force, 5);
  EXPECT_EQ(loads.largest().at("left panel").force, 2);
  snapshot.time = 4;
  snapshot.contacts = {{on(Satellite::kLeftPanel), {0, 7, 0}, 0, 0}};
  loads.add(structure, snapshot, 0);
  EXPECT_EQ(loads.largest().at("left panel").force, 7);
  EXPECT_EQ(loads.largest().at("left panel").time, 4);
  EXPECT_EQ(loads.largest().at("right panel").time, 3);
  EXPECT_EQ(part_name(Sphere{1}, {0, 1, 0}), "body");
}

TEST(CordUtilisation, HasPeakAndMostElements) {
  HandMadeNet net;
  for (int i = 0; i < 200; ++i)
    net.add_cord(net.add_node({0, i * 1.0, 0}), net.add_node({1, i * 1.0, 0}), PocketGroup::net);
  net.add_cord(0, 1, PocketGroup::rods);
  CordUtilisation utilisation(net.structure, {100, 0, 50});
  Snapshot snapshot = net.snapshot();
  for (int i = 0; i < 200; ++i) snapshot.tension[i] = i + 1;
  snapshot.tension[200] = 1e6;  // a rod has no strength
  utilisation.add(snapshot);
  snapshot.tension.setConstant(-5);
  utilisation.add(snapshot);
  EXPECT_EQ(utilisation.peak(), 2);
  EXPECT_EQ(utilisation.most_elements(), 1.98);
  EXPECT_TRUE(std::isnan(CordUtilisation(net.structure, {}).peak()));
  EXPECT_TRUE(std::isnan(CordUtilisation(net.structure, {}).most_elements()));
}

}  // namespace
}  // namespace netpocket
