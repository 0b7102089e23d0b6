// What is mended, and what is left as it is.

#include "engine/bodies/mesh_mend.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/bodies/mesh_file.h"
#include "engine/bodies/mesh_output.h"
#include "engine/bodies/mesh_review.h"
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

double volume(const MeshData& data) {
  const auto mesh = TriangleMesh::make(data);
  if (const auto* problem = std::get_if<std::string>(&mesh)) {
    ADD_FAILURE() << *problem;
    return NAN;
  }
  return std::get<std::shared_ptr<const TriangleMesh>>(mesh)->volume();
}

using Changes = std::vector<std::string>;

TEST(Mend, SoundMeshesStay) {
  const MeshData hollow = joined(box({4, 4, 4}), turned_inside_out(box({2, 2, 2})));
  const MendedMesh mended = mend_mesh(hollow, {});
  EXPECT_EQ(mended.changes, Changes());
  EXPECT_EQ(mended.mesh.triangles, weld(hollow, 0).mesh.triangles);
}

TEST(Mend, Winding) {
  MeshData some = box({2, 2, 2});
  for (const int t : {1, 4, 7}) std::swap(some.triangles[t][0], some.triangles[t][1]);
  MendedMesh mended = mend_mesh(some, {});
  EXPECT_EQ(mended.changes, Changes{"3 triangles turned to face as the neighbours do"});
  EXPECT_NEAR(volume(mended.mesh), 8, 1e-14);

  mended = mend_mesh(joined(box({2, 2, 2}), moved(turned_inside_out(box({1, 1, 1})), {3, 0, 0})), {});
  EXPECT_EQ(mended.changes, Changes{"1 closed part turned to face outwards"});
  EXPECT_NEAR(volume(mended.mesh), 9, 1e-14);

  // All of a hollow body inside out: the hollow stays one.
  mended = mend_mesh(turned_inside_out(joined(box({4, 4, 4}), turned_inside_out(box({2, 2, 2})))), {});
  EXPECT_NEAR(volume(mended.mesh), 56, 1e-13);

  // Whether this is a hollow or a body in another one nobody knows.
  const MeshData nested = joined(box({4, 4, 4}), box({2, 2, 2}));
  EXPECT_EQ(mend_mesh(nested, {}).changes, Changes());
}

TEST(Mend, Doubles) {
  MeshData doubled = joined(box({2, 2, 2}), box({2, 2, 2}));
  MendedMesh mended = mend_mesh(doubled, {});
  EXPECT_EQ(mended.changes, Changes{"12 triangles left out, being there twice"});
  EXPECT_NEAR(volume(mended.mesh), 8, 1e-14);
  mended = mend_mesh(joined(turned_inside_out(box({2, 2, 2})), box({2, 2, 2})), {});
  EXPECT_EQ(mended.changes, Changes{"12 triangles left out, being the inner side of another"});
  EXPECT_NEAR(volume(mended.mesh), 8, 1e-14);
}

TEST(Mend, TJunctions) {
  // The top of a cube in four triangles about a corner on one of its edges, which the flank does not have.
  MeshData data = box({2, 2, 2});
  data.vertices.push_back({0, -1, 1});  // on the edge from vertex 4 to 5
  data.triangles[2] = {4, 8, 6};
  data.triangles[3] = {8, 5, 7};
  data.triangles.push_back({8, 7, 6});
  EXPECT_TRUE(verdict(data).starts_with("is not watertight: 3 of its edges"));
  const MendedMesh mended = mend_mesh(data, {});
  EXPECT_EQ(mended.changes, Changes{"1 corner joined with an edge of another triangle on which it lies"});
  EXPECT_NEAR(volume(mended.mesh), 8, 1e-14);
}

TEST(Mend, WiderWelding) {
  MeshData data = samples::box({2, 2, 2});
  data.vertices.push_back(data.vertices[7] + Vector3d(1e-4, 0, 0));
  data.triangles[2][2] = 8;
  EXPECT_TRUE(verdict(mend_mesh(data, {}).mesh).starts_with("is not watertight"));
  const MendedMesh mended = mend_mesh(data, {.weld_tolerance = 1e-3});
  EXPECT_EQ(mended.changes, Changes{"1 corner joined with others within 0.001 m"});
  EXPECT_NEAR(volume(mended.mesh), 8, 1e-3);
}

TEST(Mend, PanelsGetAThickness) {
  MeshData panel;
  panel.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  panel.triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_NEAR(volume(mend_mesh(panel, {.thickness = 0.1}).mesh), 0.2, 1e-14);
  MeshData two_sided = panel;
  two_sided.triangles.insert(two_sided.triangles.end(), {{0, 2, 1}, {0, 3, 2}});
  EXPECT_EQ(mend_mesh(two_sided, {}).changes, Changes());
  const MendedMesh mended = mend_mesh(two_sided, {.thickness = 0.1});
  EXPECT_EQ(mended.changes,
            (Changes{"2 triangles left out, being the back of another", "1 open surface given a thickness of 0.1 m"}));
  EXPECT_NEAR(volume(mended.mesh), 0.2, 1e-14);
  // Beside a body, which stays as it is.
  EXPECT_NEAR(volume(mend_mesh(joined(two_sided, moved(box({1, 1, 1}), {4, 0, 0})), {.thickness = 0.1}).mesh), 1.2,
              1e-13);
}

TEST(Mend, FoldsKeepTheirThickness) {
  // Half a square tube of 2 x 1 x 5: three sides, whose middle surface is given. Corners become mitres.
  MeshData gutter;
  gutter.vertices = {{0, 1, 0}, {0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 5}, {0, 0, 5}, {2, 0, 5}, {2, 1, 5}};
  for (std::int32_t i = 0; i < 3; ++i) {
    gutter.triangles.push_back({i, i + 1, i + 5});
    gutter.triangles.push_back({i, i + 5, i + 4});
  }
  const double t = 0.1;
  EXPECT_NEAR(volume(mend_mesh(gutter, {.thickness = t}).mesh), 5 * t * (1 + 2 + 1), 1e-13);
  // An open box: five sides of 1 x 1.
  MeshData open = box({1, 1, 1});
  open.triangles.erase(open.triangles.begin() + 2, open.triangles.begin() + 4);  // its +z side
  const double outer = (1 + t) * (1 + t) * (1 + t / 2), inner = (1 - t) * (1 - t) * (1 - t / 2);
  EXPECT_NEAR(volume(mend_mesh(open, {.thickness = t}).mesh), outer - inner, 1e-13);
}

TEST(Mend, MoebiusStripsCannotBeGivenSides) {
  MeshData strip;
  const int count = 24;
  for (int i = 0; i < count; ++i) {
    const double u = 2 * M_PI * i / count;
    for (const double s : {-0.3, 0.3}) {
      strip.vertices.emplace_back((2 + s * std::cos(u / 2)) * std::cos(u), (2 + s * std::cos(u / 2)) * std::sin(u),
                                  s * std::sin(u / 2));
    }
  }
  for (std::int32_t i = 0; i < count; ++i) {
    const std::int32_t a = 2 * i, b = 2 * i + 1, last = 2 * (count - 1);
    const std::int32_t c = a == last ? 1 : a + 2, d = a == last ? 0 : a + 3;
    strip.triangles.push_back({a, c, b});
    strip.triangles.push_back({b, c, d});
  }
  EXPECT_NE(verdict(mend_mesh(strip, {}).mesh), "");
}

TEST(MeshOutput, ReadsBack) {
  const MeshData sphere = samples::geodesic_sphere(1 / 3.0, 4);
  const auto obj = read_obj(obj_text(sphere), 1);
  EXPECT_EQ(std::get<MeshData>(obj).vertices, sphere.vertices);
  EXPECT_EQ(std::get<MeshData>(obj).triangles, sphere.triangles);
  EXPECT_NEAR(volume(std::get<MeshData>(read_stl(binary_stl(sphere), 1))), volume(sphere), 1e-7);
}

}  // namespace
}  // namespace netpocket
