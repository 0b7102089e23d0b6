// Triangle meshes against closed forms, against FCL, and against a sum of solid angles.

#include "engine/bodies/triangle_mesh.h"

#include <fcl/fcl.h>
#include <gtest/gtest.h>

#include <memory>
#include <numbers>
#include <random>

#include "engine/bodies/shape.h"
#include "tests/engine/bodies/mesh_samples.h"

namespace netpocket {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using samples::checked_mesh;

constexpr double kPi = std::numbers::pi;

class RandomPoints {
 public:
  explicit RandomPoints(const TriangleMesh& mesh) : mesh_(mesh) {}

  // In a cube twice as large as the mesh, or close to its surface.
  Vector3d anywhere() {
    return 1.5 * mesh_.bounding_radius() * Vector3d(unit_(random_), unit_(random_), unit_(random_));
  }
  Vector3d near_surface(double distance) {
    const Triangle& t = mesh_.triangles()[random_() % mesh_.triangles().size()];
    const double u = std::abs(unit_(random_)), v = std::abs(unit_(random_)) * (1 - u);
    const Vector3d place = mesh_.vertices()[t[0]] + u * (mesh_.vertices()[t[1]] - mesh_.vertices()[t[0]]) +
                           v * (mesh_.vertices()[t[2]] - mesh_.vertices()[t[0]]);
    return place + distance * Vector3d(unit_(random_), unit_(random_), unit_(random_));
  }

 private:
  const TriangleMesh& mesh_;
  std::mt19937 random_{11};
  std::uniform_real_distribution<double> unit_{-1, 1};
};

// How often the surface winds round a point: 1 inside, 0 outside. Solid angles of triangles: van Oosterom & Strackee
// (1983), IEEE Trans. Biomed. Eng. 30(2), doi:10.1109/TBME.1983.325207.
double winding_number(const TriangleMesh& mesh, const Vector3d& p) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles()) {
    const Vector3d a = mesh.vertices()[t[0]] - p, b = mesh.vertices()[t[1]] - p, c = mesh.vertices()[t[2]] - p;
    const double na = a.norm(), nb = b.norm(), nc = c.norm();
    sum += 2 * std::atan2(a.dot(b.cross(c)), na * nb * nc + a.dot(b) * nc + b.dot(c) * na + c.dot(a) * nb);
  }
  return sum / (4 * kPi);
}

// ---- mass ----

TEST(MeshMass, BoxFarFromTheOrigin) {
  const Vector3d size(2, 3, 5), place(100, -50, 20);
  const auto mesh = checked_mesh(samples::moved(samples::box(size), place));
  EXPECT_NEAR(mesh->volume(), 30, 1e-12);
  EXPECT_LT((mesh->centre_in_file() - place).norm(), 1e-12);
  EXPECT_LT((mesh->unit_inertia() - solid_inertia(Box{size}, 1)).norm(), 1e-12);
  EXPECT_LT((mesh->bounds().max() - size / 2).norm(), 1e-12);
  EXPECT_NEAR(mesh->bounding_radius(), size.norm() / 2, 1e-12);
}

// A tetrahedron with corners on the axes: integrals in closed form, products of inertia included (Tonon 2004, J. Math.
// Stat. 1(1), gives the general formula; here by hand: int x^2 = 1/60, int x y = 1/120 of the unit tetrahedron).
TEST(MeshMass, UnitTetrahedron) {
  MeshData data;
  data.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  data.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const auto mesh = checked_mesh(data);
  EXPECT_NEAR(mesh->volume(), 1.0 / 6, 1e-15);
  EXPECT_LT((mesh->centre_in_file() - Vector3d::Constant(0.25)).norm(), 1e-15);
  // About the centre, per volume 1/6: int x^2 = 1/10 - 1/16, int x y = 1/20 - 1/16.
  const double square = 0.1 - 0.0625, product = 0.05 - 0.0625;
  Matrix3d inertia = Matrix3d::Constant(-product);
  inertia.diagonal().setConstant(2 * square);
  EXPECT_LT((mesh->unit_inertia() - inertia).norm(), 1e-15);
}

TEST(MeshMass, RoundBodiesConvergeWithTheSquareOfTheEdge) {
  const auto error = [](int n) {
    return std::abs(checked_mesh(samples::geodesic_sphere(2, n))->unit_inertia()(0, 0) - 0.4 * 4) / 1.6;
  };
  EXPECT_LT(error(32), 2e-3);
  EXPECT_NEAR(error(16) / error(32), 4, 0.1);
  const auto torus = checked_mesh(samples::torus(3, 1, 400, 200));
  EXPECT_NEAR(torus->volume(), 2 * kPi * kPi * 3, 2e-3 * 60);
}

TEST(MeshMass, AHollowIsLeftOut) {
  const auto shell =
      checked_mesh(samples::joined(samples::box({4, 4, 4}), samples::turned_inside_out(samples::box({2, 2, 2}))));
  EXPECT_NEAR(shell->volume(), 64 - 8, 1e-12);
  EXPECT_NEAR(shell->unit_inertia()(0, 0), (64 * 32 / 12.0 - 8 * 8 / 12.0) / 56, 1e-12);
  EXPECT_NEAR(shell->nearest({0, 0, 0}).distance, 1, 1e-15);  // outside the material
  EXPECT_NEAR(shell->nearest({1.5, 0.1, 0}).distance, -0.5, 1e-15);
}

// ---- distance ----

TEST(MeshDistance, BoxIsThatOfTheBox) {
  const Vector3d size(1.6, 2, 6);
  const auto mesh = checked_mesh(samples::box(size));
  const Shape box = Box{size};
  RandomPoints points(*mesh);
  double distance = 0, normal = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vector3d point = i % 2 ? points.anywhere() : points.near_surface(0.1);
    const SurfacePoint ours = mesh->nearest(point), exact = nearest_surface_point(box, point);
    distance = std::max(distance, std::abs(ours.distance - exact.distance));
    normal = std::max(normal, (ours.normal - exact.normal).norm());
  }
  EXPECT_LT(distance, 1e-14);
  EXPECT_LT(normal, 1e-9);  // beside edges: round-off over the distance
}

TEST(MeshDistance, SphereAndCylinderApproachTheClosedForm) {
  const auto largest_error = [](const MeshData& data, const Shape& shape) {
    const auto mesh = checked_mesh(data);
    RandomPoints points(*mesh);
    double largest = 0;
    for (int i = 0; i < 1000; ++i) {
      const Vector3d point = points.near_surface(0.3);
      largest =
          std::max(largest, std::abs(mesh->nearest(point).distance - nearest_surface_point(shape, point).distance));
    }
    return largest;
  };
  // The sagitta of an edge of length h on a sphere: h^2/(8 R) and a third more at a triangle's middle.
  const double coarse = largest_error(samples::geodesic_sphere(4.5, 16), Sphere{4.5});
  const double fine = largest_error(samples::geodesic_sphere(4.5, 50), Sphere{4.5});  // 50,000 triangles
  EXPECT_LT(coarse, 0.02);
  EXPECT_LT(fine, 0.002);
  EXPECT_NEAR(coarse / fine, std::pow(50.0 / 16, 2), 2.5);
  const double cylinder = largest_error(samples::cylinder(0.7, 3, 200), Cylinder{0.7, 3});
  EXPECT_LT(cylinder, 1.01 * 0.7 * (1 - std::cos(kPi / 200)));
}

class MeshTest : public testing::TestWithParam<std::pair<const char*, MeshData>> {
 protected:
  std::shared_ptr<const TriangleMesh> mesh_ = checked_mesh(GetParam().second);
  RandomPoints points_{*mesh_};
};

INSTANTIATE_TEST_SUITE_P(Meshes, MeshTest,
                         testing::Values(std::pair("torus", samples::torus(3, 1, 40, 20)),
                                         std::pair("wedge", samples::wedge()),
                                         std::pair("sphere", samples::geodesic_sphere(2, 10)),
                                         std::pair("two", samples::joined(samples::moved(samples::wedge(), {5, 0, 0}),
                                                                          samples::box({2, 3, 4})))),
                         [](const auto& info) { return info.param.first; });

TEST_P(MeshTest, DistanceOutsideIsThatOfFcl) {
  const double probe_radius = 1e-3;
  auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  model->beginModel();
  for (const Triangle& t : mesh_->triangles())
    model->addTriangle(mesh_->vertices()[t[0]], mesh_->vertices()[t[1]], mesh_->vertices()[t[2]]);
  model->endModel();
  fcl::CollisionObjectd body(model), probe(std::make_shared<fcl::Sphered>(probe_radius));
  double largest = 0;
  for (int tested = 0; tested < 300;) {
    const Vector3d point = points_.anywhere();
    const double ours = mesh_->nearest(point).distance;
    if (ours < 2 * probe_radius) continue;
    ++tested;
    probe.setTranslation(point);
    probe.computeAABB();
    fcl::DistanceResultd result;
    largest = std::max(largest,
                       std::abs(fcl::distance(&body, &probe, fcl::DistanceRequestd(), result) + probe_radius - ours));
  }
  EXPECT_LT(largest, 1e-9);
}

TEST_P(MeshTest, IsThatOfTheNearestOfAllTriangles) {
  for (int i = 0; i < 500; ++i) {
    const Vector3d point = i % 2 ? points_.anywhere() : points_.near_surface(0.05);
    double least = HUGE_VAL;
    for (const Triangle& t : mesh_->triangles()) {
      least = std::min(
          least, nearest_on_triangle(point, mesh_->vertices()[t[0]], mesh_->vertices()[t[1]], mesh_->vertices()[t[2]])
                     .squared_distance);
    }
    EXPECT_EQ(std::abs(mesh_->nearest(point).distance), std::sqrt(least));
  }
}

TEST_P(MeshTest, SignIsThatOfTheWindingNumber) {
  for (int i = 0; i < 2000; ++i) {
    const Vector3d point = i % 2 ? points_.anywhere() : points_.near_surface(0.02);
    const double distance = mesh_->nearest(point).distance;
    if (std::abs(distance) < 1e-9) continue;
    EXPECT_EQ(distance<0, winding_number(*mesh_, point)> 0.5) << point.transpose() << ": " << distance;
  }
}

TEST_P(MeshTest, NormalsAreUnitAndLeadToTheSurface) {
  for (int i = 0; i < 1000; ++i) {
    const Vector3d point = i % 2 ? points_.anywhere() : points_.near_surface(0.1);
    const SurfacePoint found = mesh_->nearest(point);
    EXPECT_NEAR(found.normal.norm(), 1, 1e-14);
    EXPECT_NEAR(mesh_->nearest(point - found.distance * found.normal).distance, 0, 1e-13);
  }
}

TEST_P(MeshTest, NearerAgreesWithTheDistance) {
  for (int i = 0; i < 1000; ++i) {
    const Vector3d point = points_.anywhere();
    const double distance = mesh_->nearest(point).distance;
    for (const double reach : {0.0, 0.1, 1.0}) EXPECT_EQ(mesh_->is_nearer(point, reach), distance <= reach);
  }
  EXPECT_TRUE(mesh_->is_nearer({NAN, 0, 0}, 1));
}

TEST(Mesh, NotANumberHasNoDistance) {
  const auto mesh = checked_mesh(samples::wedge());
  EXPECT_TRUE(std::isnan(mesh->nearest({NAN, 0, 0}).distance));
}

// ---- what is refused ----

std::string refusal(const MeshData& data) {
  const auto mesh = TriangleMesh::make(data);
  const auto* problem = std::get_if<std::string>(&mesh);
  return problem ? *problem : "";
}

TEST(BadMesh, EachFaultHasItsSentence) {
  const MeshData box = samples::box({2, 2, 2});
  EXPECT_EQ(refusal(box), "");
  EXPECT_EQ(refusal({}), "has no triangles");

  MeshData open = box;
  open.triangles.pop_back();
  EXPECT_EQ(refusal(open),
            "is not watertight: 3 of its edges do not join exactly two triangles, one of them at (1, -1, 0) m");
  MeshData turned = box;
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  EXPECT_EQ(refusal(turned),
            "has neighbouring triangles that face opposite ways, at 3 edges, one of them at (-1, 0, -1) m");
  EXPECT_EQ(refusal(samples::turned_inside_out(box)), "is inverted: its triangles face inwards (volume -8 m^3)");
  MeshData doubled = box;  // a fin: three triangles at an edge
  doubled.vertices.push_back({5, 5, 5});
  doubled.triangles.push_back({0, 1, 8});
  EXPECT_TRUE(refusal(doubled).starts_with("is not watertight: ")) << refusal(doubled);

  for (const double bad : {std::nan(""), HUGE_VAL}) {
    MeshData broken = box;
    broken.vertices[3].y() = bad;
    EXPECT_EQ(refusal(broken), "has a corner whose coordinates are not finite numbers");
  }
  MeshData stray = box;
  stray.triangles[2][1] = 8;
  EXPECT_EQ(refusal(stray), "has a triangle with a corner that does not exist");
  stray.triangles[2][1] = -1;
  EXPECT_EQ(refusal(stray), "has a triangle with a corner that does not exist");

  EXPECT_EQ(refusal(samples::box({2000, 2, 2})),
            "is 2000 m large, not 0.01 m to 1000 m as is allowed: is its unit right?");
  EXPECT_EQ(refusal(samples::box({1e-3, 1e-3, 1e-3})),
            "is 0.001 m large, not 0.01 m to 1000 m as is allowed: is its unit right?");
  MeshData flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  flat.triangles = {{0, 1, 2}, {0, 2, 1}};
  EXPECT_EQ(refusal(flat), "encloses no volume");
  MeshData many;
  many.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  many.triangles.assign(kLargestTriangleCount + 1, {0, 1, 2});
  EXPECT_EQ(refusal(many), "has 2000001 triangles; 2000000 are allowed");
}

TEST(BadMesh, CornersAreWeldedAndNeedlesLeftOut) {
  MeshData data = samples::box({2, 2, 2});
  data.vertices.push_back(data.vertices[0]);  // a twin of a corner, and a triangle that shrinks to an edge with it
  data.vertices.push_back({9, 9, 9});         // belongs to nothing
  data.triangles.push_back({0, 8, 1});
  const auto mesh = checked_mesh(data);
  EXPECT_EQ(mesh->vertices().size(), 8u);
  EXPECT_EQ(mesh->triangles().size(), 12u);
}

}  // namespace
}  // namespace netpocket
