#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkIdList.h>
#include <vtkPolyData.h>

#include <Eigen/Geometry>
#include <numbers>

#include "render/render_error.h"
#include "render/scene/body_mesh.h"
#include "render/scene/camera.h"
#include "render/scene/color_map.h"
#include "render/scene/color_scale.h"
#include "render/scene/element_curve.h"
#include "render/scene/mesh_builder.h"
#include "render/scene/time_label.h"
#include "render/scene/visible_points.h"
#include "tests/engine/bodies/mesh_samples.h"
#include "tests/render/synthetic_pocket.h"

namespace netpocket {
namespace {

// Relative luminance of an sRGB colour (IEC 61966-2-1 with the weights of Rec. 709).
double luminance(const Color& color) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]);
}

// Signed volume inside a closed mesh, positive when its faces look outwards (divergence theorem).
double enclosed_volume(vtkPolyData* mesh) {
  double volume = 0;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell) {
    const auto* ids = mesh->GetCell(cell)->GetPointIds();
    const auto point = [&](vtkIdType i) {
      return Eigen::Vector3d(mesh->GetPoint(const_cast<vtkIdList*>(ids)->GetId(i)));
    };
    for (vtkIdType i = 1; i + 1 < ids->GetNumberOfIds(); ++i) {
      volume += point(0).dot(point(i).cross(point(i + 1))) / 6;
    }
  }
  return volume;
}

TEST(ColorMap, LuminanceRisesAllTheWay) {
  for (const auto map : {ColorMap::viridis, ColorMap::cividis, ColorMap::plasma}) {
    double previous = -1;
    for (int i = 0; i <= 100; ++i) {
      const double now = luminance(map_color(map, i / 100.0));
      EXPECT_GT(now, previous) << static_cast<int>(map) << " at " << i;
      previous = now;
    }
  }
}

TEST(ColorMap, ClampsAndSurvivesNan) {
  EXPECT_EQ(map_color(ColorMap::viridis, -3), map_color(ColorMap::viridis, 0));
  EXPECT_EQ(map_color(ColorMap::viridis, 7), map_color(ColorMap::viridis, 1));
  EXPECT_EQ(map_color(ColorMap::viridis, std::nan("")), map_color(ColorMap::viridis, 0));
  EXPECT_EQ(color_map_from_name("cividis"), ColorMap::cividis);
  EXPECT_THROW(color_map_from_name("jet"), RenderError);
}

TEST(ColorScale, RoundsUp) {
  EXPECT_DOUBLE_EQ(round_up(37), 50);
  EXPECT_DOUBLE_EQ(round_up(50), 50);
  EXPECT_DOUBLE_EQ(round_up(0.0021), 0.0025);
  EXPECT_DOUBLE_EQ(round_up(7e5), 1e6);
  EXPECT_DOUBLE_EQ(round_up(0), 1);
  EXPECT_DOUBLE_EQ(round_up(std::nan("")), 1);
}

TEST(ColorScale, GrowsUnlessFixed) {
  const auto structure = synthetic::make_structure();
  auto snapshot = synthetic::make_snapshot(structure, 0, 0);
  SceneOptions options;
  options.color_by = ColorBy::tension;
  ColorScale scale(structure, options);
  scale.update(snapshot);
  EXPECT_DOUBLE_EQ(scale.range().high, 50);  // tensions reach 40 N
  snapshot.tension *= 10;
  scale.update(snapshot);
  EXPECT_DOUBLE_EQ(scale.range().high, 500);
  snapshot.tension /= 10;
  scale.update(snapshot);
  EXPECT_DOUBLE_EQ(scale.range().high, 500);

  options.color_range = ValueRange{0, 12};
  ColorScale fixed(structure, options);
  fixed.update(snapshot);
  EXPECT_DOUBLE_EQ(fixed.range().high, 12);
}

TEST(ElementCurve, IsTheCubicThroughItsEnds) {
  Snapshot snapshot;
  snapshot.positions.resize(3, 2);
  snapshot.positions << 0, 2, 0, 1, 0, 0;
  snapshot.gradients.resize(3, 2);
  snapshot.gradients << 1, 1, 0.5, -0.5, 0, 0;
  StructureElement element{{0, 1}, {0, 1}, 0, 0, -1, 2.5, 0.002};
  const ElementCurve curve(4);
  // Hermite at the middle: mean of the ends + L/8 (g0 - g1).
  const auto middle = curve.at(snapshot, element, 2);
  EXPECT_NEAR(middle.position.x(), 1, 1e-14);
  EXPECT_NEAR(middle.position.y(), 0.5 + 2.5 / 8 * (0.5 + 0.5), 1e-14);
  EXPECT_TRUE(curve.position(snapshot, element, 0).isApprox(snapshot.positions.col(0)) ||
              curve.position(snapshot, element, 0).norm() < 1e-14);
  EXPECT_TRUE(curve.at(snapshot, element, 4).tangent.isApprox(snapshot.gradients.col(1), 1e-12));
  // A variable-length element uses its length now.
  element.rope = 0;
  snapshot.rope_element_length = {1.0};
  EXPECT_NEAR(curve.position(snapshot, element, 2).y(), 0.5 + 1.0 / 8 * (0.5 + 0.5), 1e-14);
}

TEST(Mesh, FacesLookOutwards) {
  MeshBuilder box;
  box.add_box({1, 2, 3}, {2, 3, 4}, 0, {});
  EXPECT_NEAR(enclosed_volume(box.build()), 24, 1e-5);
  MeshBuilder bevelled;
  bevelled.add_box({0, 0, 0}, {2, 2, 2}, 0.1, {});
  // 8 minus 12 edge prisms of cross-section b^2/2 and length 2 - 2b, minus 8 corners of (5/6) b^3.
  EXPECT_NEAR(enclosed_volume(bevelled.build()), 8 - 12 * 0.005 * 1.8 - 8 * 5.0 / 6 * 0.001, 1e-5);
  MeshBuilder cylinder;
  cylinder.add_cylinder({0, 0, 0}, {0, 0, 2}, 1, 1, 200);
  EXPECT_NEAR(enclosed_volume(cylinder.build()), 2 * std::numbers::pi, 2e-3);
  MeshBuilder sphere;
  sphere.add_sphere({1, 0, 0}, 1, 200, 100);
  EXPECT_NEAR(enclosed_volume(sphere.build()), 4 * std::numbers::pi / 3, 2e-3);
  MeshBuilder torus;
  torus.add_torus({0, 0, 0}, Eigen::Vector3d::UnitY(), 2, 0.2);
  EXPECT_NEAR(enclosed_volume(torus.build()), 2 * std::numbers::pi * std::numbers::pi * 2 * 0.04, 0.08);
}

TEST(Mesh, TargetsHaveTheirVolume) {
  const auto& colors = palette(Background::white);
  // The surface is drawn 0.3 % inside: volumes shrink by 0.9 %, and by the facets of round shapes.
  EXPECT_NEAR(enclosed_volume(shape_mesh(Sphere{2}, colors).surface) / (4 * std::numbers::pi / 3 * 8), 0.989, 0.006);
  EXPECT_NEAR(enclosed_volume(shape_mesh(Box{{2, 3, 4}}, colors).surface) / 24, 0.991, 1e-3);
  EXPECT_NEAR(enclosed_volume(shape_mesh(Cylinder{1, 3}, colors).surface) / (3 * std::numbers::pi), 0.99, 0.004);
}

TEST(Mesh, TriangleMeshesAndSatellitesHaveTheirVolume) {
  const auto& colors = palette(Background::white);
  const Shape torus = MeshShape{samples::checked_mesh(samples::torus(3, 1, 40, 20))};
  EXPECT_NEAR(enclosed_volume(plain_shape_mesh(torus)) / volume(torus), 1, 1e-5);
  EXPECT_NEAR(enclosed_volume(shape_mesh(torus, colors).surface) / volume(torus), 0.99, 0.005);
  const Shape box = MeshShape{samples::checked_mesh(samples::box({2, 3, 4}))};
  const auto drawn = shape_mesh(box, colors);
  EXPECT_EQ(drawn.surface->GetNumberOfPoints(), 24);  // each corner once for each of its three flat faces
  EXPECT_EQ(drawn.lines->GetNumberOfCells(), 12);     // the sharp edges, without the faces' diagonals
  const Shape satellite = Satellite({.bus = {2, 2.4, 2}, .span = 8.4, .panel_width = 1.7, .dish_diameter = 1.6});
  EXPECT_NEAR(enclosed_volume(plain_shape_mesh(satellite)) / volume(satellite), 1, 0.01);
  double bounds[6];
  shape_mesh(satellite, colors).surface->GetBounds(bounds);
  const Eigen::AlignedBox3d extent = extents(satellite);
  for (int axis = 0; axis < 3; ++axis) {  // what is drawn lies in what is touched, to the wire on a panel
    EXPECT_GE(bounds[2 * axis], extent.min()[axis] - 1e-3);
    EXPECT_LE(bounds[2 * axis + 1], extent.max()[axis] + 1e-3);
  }
}

TEST(Camera, FramesAllPointsWithinThePicture) {
  const auto structure = synthetic::make_structure();
  const auto points = visible_points(structure, synthetic::make_snapshot(structure, 0, 0));
  for (const auto preset :
       {CameraPreset::iso, CameraPreset::side, CameraPreset::front, CameraPreset::mouth, CameraPreset::follow}) {
    for (const double aspect : {1.0, 16.0 / 9, 0.6}) {
      const auto view = frame_view(preset, points, aspect);
      const Eigen::Vector3d forward = (view.focal_point - view.position).normalized();
      const Eigen::Vector3d right = forward.cross(view.view_up).normalized(), up = right.cross(forward);
      double widest = 0, highest = 0;
      for (const auto& point : points.colwise()) {
        const Eigen::Vector3d arm = point - view.position;
        const double half = view.half_height > 0
                                ? view.half_height
                                : arm.dot(forward) * std::tan(view.view_angle / 2 * std::numbers::pi / 180);
        ASSERT_GT(arm.dot(forward), 0);
        widest = std::max(widest, std::abs(arm.dot(right)) / half / aspect);
        highest = std::max(highest, std::abs(arm.dot(up)) / half);
      }
      EXPECT_LE(widest, 0.81);
      EXPECT_LE(highest, 0.89);
      // The larger of the two fills its share: the picture is not wasted.
      EXPECT_GT(std::max(widest / 0.80, highest / 0.88), 0.98);
    }
  }
}

TEST(Camera, ThePocketsAxisRisesToTheRight) {
  const auto structure = synthetic::make_structure();
  const auto points = visible_points(structure, synthetic::make_snapshot(structure, 0, 0));
  const auto view = frame_view(CameraPreset::iso, points, 16.0 / 9);
  const Eigen::Vector3d forward = (view.focal_point - view.position).normalized();
  const Eigen::Vector3d right = forward.cross(view.view_up).normalized();
  EXPECT_GT(right.y(), 0.5);
  EXPECT_GT(view.view_up.y(), 0.2);
}

TEST(Camera, UnknownNamesAreRefused) {
  EXPECT_EQ(camera_from_name("mouth"), CameraPreset::mouth);
  EXPECT_THROW(camera_from_name("back"), RenderError);
  EXPECT_THROW(color_by_from_name("stress"), RenderError);
  EXPECT_THROW(background_from_name("black"), RenderError);
}

TEST(TimeLabel, NamesThePhases) {
  const std::vector<Phase> phases = pocket_phases(1, 7.5, 10);
  EXPECT_EQ(phase_name(phases, 0.5), "open");
  EXPECT_EQ(phase_name(phases, 1), "closing");
  EXPECT_EQ(phase_name(phases, 8), "closed");
  EXPECT_EQ(phase_name(phases, 10), "towing");
  EXPECT_EQ(phase_name({}, 10), "");
}

}  // namespace
}  // namespace netpocket
