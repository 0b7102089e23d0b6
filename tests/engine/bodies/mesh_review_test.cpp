// Each part of a mesh is judged: what encloses no volume, faces inwards, overlaps, or lies in another one.

#include "engine/bodies/mesh_review.h"

#include <gtest/gtest.h>

#include "engine/bodies/mesh_crossings.h"
#include "engine/bodies/mesh_weld.h"
#include "tests/engine/bodies/mesh_samples.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;
using samples::box;
using samples::joined;
using samples::moved;
using samples::turned_inside_out;
using samples::verdict;

MeshData panel() {
  MeshData data;
  data.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  data.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 3, 2}};
  return data;
}

TEST(MeshReview, HollowsAndIslandsAreBodies) {
  const MeshData outer = box({4, 4, 4}), hollow = turned_inside_out(box({2, 2, 2})), island = box({1, 1, 1});
  const MeshData data = joined(joined(outer, hollow), island);
  EXPECT_EQ(verdict(data), "");
  const auto mesh = samples::checked_mesh(data);
  EXPECT_NEAR(mesh->volume(), 64 - 8 + 1, 1e-12);
  const double second = 64 * 16 / 6.0 - 8 * 4 / 6.0 + 1 / 6.0;  // of y^2 + z^2
  EXPECT_NEAR(mesh->unit_inertia()(0, 0), second / 57, 1e-12);
  EXPECT_NEAR(mesh->nearest({0, 0, 0}).distance, -0.5, 1e-14);
  EXPECT_NEAR(mesh->nearest({0.75, 0, 0}).distance, 0.25, 1e-14);
  EXPECT_NEAR(mesh->nearest({1.25, 0, 0}).distance, -0.25, 1e-14);
}

TEST(MeshReview, FlatTwoSidedPanels) {
  EXPECT_EQ(verdict(panel()), "encloses no volume");
  EXPECT_EQ(verdict(joined(moved(panel(), {5, 0, 0}), box({2, 2, 2}))),
            "has 1 part that encloses no volume, such as a panel without thickness: one of 2 parts, at (6, 0.5, 0) m");
}

TEST(MeshReview, InvertedParts) {
  EXPECT_EQ(verdict(joined(box({2, 2, 2}), moved(turned_inside_out(box({1, 1, 1})), {3, 0, 0}))),
            "has 1 part of 2 whose triangles face inwards without being a hollow of another one, one of them at (3, 0, "
            "0) m");
  EXPECT_EQ(verdict(turned_inside_out(joined(box({2, 2, 2}), moved(box({1, 1, 1}), {3, 0, 0})))),
            "is inverted: its triangles face inwards (volume -9 m^3)");
  // A hollow in a hollow.
  EXPECT_EQ(
      verdict(joined(joined(box({4, 4, 4}), turned_inside_out(box({2, 2, 2}))), turned_inside_out(box({1, 1, 1})))),
      "has 1 part of 3 whose triangles face inwards without being a hollow of another one, one of them at (0, 0, "
      "0) m");
}

TEST(MeshReview, NestedParts) {
  const MeshData data = joined(box({4, 4, 4}), moved(box({1, 1, 1}), {1, 0, 0}));  // 65 m^3 for 64
  EXPECT_EQ(verdict(data),
            "has 1 part in the solid of another one that faces outwards, one of them at (1, 0, 0) m: a hollow faces "
            "inwards");
}

TEST(MeshReview, OverlappingParts) {
  const std::string crossing = "has parts that go through each other, one of the places is ";
  const MeshData cube = box({2, 2, 2});
  EXPECT_TRUE(verdict(joined(cube, moved(cube, {1, 0.5, 0.3}))).starts_with(crossing));
  // Faces in the same planes: no triangle goes through another one.
  EXPECT_TRUE(verdict(joined(cube, moved(cube, {1, 0, 0}))).starts_with(crossing));
  EXPECT_TRUE(verdict(joined(cube, moved(cube, {1, 1, 0}))).starts_with(crossing));
  // Long triangles, whose centres lie outside.
  EXPECT_TRUE(verdict(joined(box({20, 2, 2}), box({2, 2, 50}))).starts_with(crossing));
  EXPECT_TRUE(verdict(joined(box({20, 0.1, 0.1}), box({2, 2, 2}))).starts_with(crossing));
  // A sphere through a wall.
  EXPECT_TRUE(verdict(joined(box({4, 0.2, 4}), samples::geodesic_sphere(1, 6))).starts_with(crossing));
}

TEST(MeshReview, PartsThatTouchAreBodies) {
  const MeshData cube = box({2, 2, 2});
  for (const Vector3d& by : {Vector3d(2, 0, 0), Vector3d(2, 2, 0), Vector3d(2, 2, 2), Vector3d(2, 1, 0.5)}) {
    const MeshData data = joined(cube, moved(cube, by));
    EXPECT_EQ(verdict(data), "") << by.transpose();
    EXPECT_EQ(review_mesh(data).parts.size(), 2u);
    EXPECT_NEAR(samples::checked_mesh(data)->volume(), 16, 1e-12);
  }
  EXPECT_EQ(verdict(joined(cube, moved(box({0.5, 0.5, 0.5}), {1.25, 0, 0}))), "");
  // One that fills a hollow.
  EXPECT_EQ(
      verdict(joined(joined(box({4, 4, 4}), turned_inside_out(cube)), cube)),
      "has 2 of 3 parts that are two-sided: each triangle is there twice, once facing each way, one of them at (0, "
      "0, 0) m");
}

TEST(MeshReview, DoubledAndTwoSidedSurfaces) {
  const MeshData cube = box({2, 2, 2});
  EXPECT_EQ(verdict(joined(cube, cube)),
            "has 12 triangles that are there twice, one of them at (-0.3333, 0.3333, -1) m");
  EXPECT_EQ(verdict(joined(cube, turned_inside_out(cube))),
            "is two-sided: each triangle is there twice, once facing each way");
}

TEST(MeshReview, CornersThatDifferByRoundOffAreJoined) {
  MeshData data;
  const MeshData sphere = samples::geodesic_sphere(3, 8);
  for (std::size_t t = 0; t < sphere.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      Vector3d corner = sphere.vertices[sphere.triangles[t][i]];
      if (t % 3 == 0) corner.x() += 2e-9;
      data.vertices.push_back(corner);
    }
    const auto first = static_cast<std::int32_t>(3 * t);
    data.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_FALSE(find_edges(weld(data, 0).mesh).open.empty());
  const auto mesh = samples::checked_mesh(data);
  EXPECT_EQ(mesh->vertices().size(), sphere.vertices.size());
  EXPECT_GT(mesh->joined_corners(), 100u);
  EXPECT_NEAR(mesh->weld_tolerance(), 6e-8, 1e-10);
  // Farther apart they are two.
  for (Vector3d& v : data.vertices) v.x() += v.x() > 0 ? 0 : 1e-6;
  EXPECT_TRUE(verdict(data).starts_with("is not watertight: "));
}

TEST(Weld, FindsTheFirstCornerWithinTheTolerance) {
  MeshData data;
  data.vertices = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1e-9, 0, 0}, {1, 1, 0}, {0, 1, 3e-9}, {1, 0, -0.0}};
  data.triangles = {{1, 2, 3}, {4, 5, 6}, {7, 5, 6}};
  const WeldedMesh welded = weld(data, 2e-9);
  EXPECT_EQ(welded.mesh.vertices.size(), 5u);
  EXPECT_EQ(welded.joined, 1u);
  EXPECT_EQ(welded.mesh.triangles[1][0], 0);
  EXPECT_EQ(welded.mesh.triangles[2][0], welded.mesh.triangles[0][1]);
}

TEST(Crossing, NeedsTheInsideOfBoth) {
  const Corners flat = {Vector3d(0, 0, 0), Vector3d(3, 0, 0), Vector3d(0, 3, 0)};
  const auto crosses = [&](const Corners& other) { return crossing(flat, other, 1e-7).has_value(); };
  EXPECT_TRUE(crosses({Vector3d(0.5, 0.5, -1), Vector3d(1, 0.5, -1), Vector3d(0.7, 0.6, 1)}));
  EXPECT_FALSE(crosses({Vector3d(0.5, 0.5, 0), Vector3d(1, 0.5, 0), Vector3d(0.7, 0.6, 1)}));      // stands on it
  EXPECT_FALSE(crosses({Vector3d(0.5, 0.5, 0.1), Vector3d(1, 0.5, 0.1), Vector3d(0.7, 0.6, 1)}));  // above it
  EXPECT_FALSE(crosses({Vector3d(0, 0, -1), Vector3d(3, 0, -1), Vector3d(1, 0, 1)}));              // along its edge
  EXPECT_FALSE(crosses({Vector3d(1, 1, 0), Vector3d(2, 1, 0), Vector3d(1, 2, 0)}));                // in its plane
  EXPECT_FALSE(crosses({Vector3d(4, 4, -1), Vector3d(5, 4, -1), Vector3d(4, 5, 1)}));              // beside it
}

}  // namespace
}  // namespace netpocket
