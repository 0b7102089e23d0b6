#include "render/scene/satellite_target.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "render/scene/mesh_builder.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

constexpr double kInset = 0.985;  // drawn a little inside the surface that is touched
constexpr int kPanelSegments = 3;      // of a solar panel
constexpr int kCellsAcross = 8;
constexpr Color kDishFront = {0.93, 0.93, 0.90};

const Box& box_of(const Satellite::Part& part) { return std::get<Box>(part.solid); }
const Cylinder& cylinder_of(const Satellite::Part& part) { return std::get<Cylinder>(part.solid); }

class SatellitePainter {
 public:
  SatellitePainter(const Satellite& satellite, const Palette& palette) : satellite_(satellite), palette_(palette) {}

  BodyMesh paint() {
    add_bus();
    for (const auto arm : {Satellite::kLeftArm, Satellite::kRightArm}) add_arm(satellite_.part(arm));
    for (const auto panel : {Satellite::kLeftPanel, Satellite::kRightPanel}) add_panel(satellite_.part(panel));
    add_mast();
    add_dish();
    add_nozzle();
    return {surface_.build(), lines_.build()};
  }

 private:
  void add_bus() {
    const Vector3d size = box_of(satellite_.part(Satellite::kBus)).size,
                   centre = satellite_.part(Satellite::kBus).centre;
    surface_.set_color(palette_.target);
    surface_.add_box(centre, kInset * size, 0.04 * size.minCoeff(), palette_.target_seams);
    // Radiators on the z sides and equipment panels on the x sides, up to the surface that is touched.
    surface_.set_color(palette_.target_panels);
    surface_.add_box(centre + Vector3d(0, 0.14 * size.y(), 0), size.cwiseProduct(Vector3d(0.70, 0.48, 1)));
    surface_.add_box(centre - Vector3d(0, 0.24 * size.y(), 0), size.cwiseProduct(Vector3d(1, 0.30, 0.70)));
    surface_.set_color(kDarkMetal);
    surface_.add_box(centre + Vector3d(0.17 * size.x(), -0.29 * size.y(), 0),
                     size.cwiseProduct(Vector3d(0.30, 0.2, 1)));
    lines_.set_color(palette_.target_seams);
    for (const int side : {-1, 1}) {
      for (int i = 0; i <= 4; ++i) {  // the radiators' tubes
        const double x = 0.70 * size.x() * (i / 4.0 - 0.5), z = side * 0.502 * size.z();
        add_line(centre + Vector3d(x, -0.10 * size.y(), z), centre + Vector3d(x, 0.38 * size.y(), z));
      }
    }
  }

  void add_arm(const Satellite::Part& part) {
    const Vector3d size = box_of(part).size;
    const Vector3d along = 0.5 * size.x() * Vector3d::UnitX();
    const double width = 0.5 * size.y();
    surface_.set_color(kMetal);
    surface_.add_cylinder(part.centre - along, part.centre + along, 0.7 * width, 0.7 * width, 20);
    for (const double end : {-0.42, 0.42}) {
      const Vector3d ring = part.centre + end * size.x() * Vector3d::UnitX();
      surface_.add_cylinder(ring - 0.06 * along, ring + 0.06 * along, width, width, 20);
    }
  }

  void add_panel(const Satellite::Part& part) {
    const Vector3d size = box_of(part).size;
    const double gap = 0.02 * size.x(), length = (size.x() - (kPanelSegments - 1) * gap) / kPanelSegments;
    for (int i = 0; i < kPanelSegments; ++i) {
      const double x = -0.5 * size.x() + 0.5 * length + i * (length + gap);
      const Vector3d centre = part.centre + x * Vector3d::UnitX();
      surface_.set_color(kSolarCell);
      surface_.add_box(centre, {length, kInset * size.y(), 0.9 * size.z()}, 0.1 * size.z(), kMetal);
      add_cells(centre, {length, kInset * size.y(), size.z()});
      if (i == 0) continue;
      surface_.set_color(kMetal);
      for (const double y : {-0.3, 0.3}) {
        surface_.add_box(centre + Vector3d(-0.5 * (length + gap), y * size.y(), 0),
                         {1.2 * gap, 0.05 * size.y(), 0.8 * size.z()});
      }
    }
  }

  void add_cells(const Vector3d& centre, const Vector3d& size) {
    lines_.set_color(kSolarGrid);
    const int along = std::max(2, static_cast<int>(std::lround(kCellsAcross * size.x() / size.y())));
    for (const int side : {-1, 1}) {
      const double z = 0.5 * side * size.z();
      for (int i = 0; i <= along; ++i) {
        const double x = size.x() * (static_cast<double>(i) / along - 0.5);
        add_line(centre + Vector3d(x, -size.y() / 2, z), centre + Vector3d(x, size.y() / 2, z));
      }
      for (int i = 0; i <= kCellsAcross; ++i) {
        const double y = size.y() * (static_cast<double>(i) / kCellsAcross - 0.5);
        add_line(centre + Vector3d(-size.x() / 2, y, z), centre + Vector3d(size.x() / 2, y, z));
      }
    }
  }

  void add_mast() {
    const Satellite::Part& part = satellite_.part(Satellite::kMast);
    const Vector3d half = cylinder_of(part).length / 2 * Vector3d::UnitY();
    surface_.set_color(kMetal);
    surface_.add_cylinder(part.centre - half, part.centre + half, 0.9 * cylinder_of(part).radius,
                          0.9 * cylinder_of(part).radius);
  }

  // A paraboloid inside the drum that is touched, open to +y, with a feed at the level of the rim.
  void add_dish() {
    const Satellite::Part& part = satellite_.part(Satellite::kDish);
    const double radius = kInset * cylinder_of(part).radius, depth = kInset * cylinder_of(part).length;
    const double thickness = 0.08 * depth;
    const auto side = [&](double bottom, double height, double facing) {
      surface_.add_patch(48, 10, [&](double u, double v) {
        const double r = v * radius, slope = 2 * height * v / radius;
        const Vector3d out(std::cos(kTurn * u), 0, std::sin(kTurn * u));
        return SurfaceVertex{part.centre + r * out + (bottom + height * v * v) * Vector3d::UnitY(),
                             facing * (Vector3d::UnitY() - slope * out).normalized()};
      });
    };
    surface_.set_color(kDishFront);
    side(-depth / 2 + thickness, depth - thickness, 1);
    surface_.set_color(kMetal);
    side(-depth / 2, depth, -1);
    const Vector3d rim = part.centre + depth / 2 * Vector3d::UnitY();
    surface_.add_torus(rim - 0.03 * depth * Vector3d::UnitY(), Vector3d::UnitY(), radius, 0.03 * depth);
    surface_.set_color(kDarkMetal);
    surface_.add_cylinder(rim - 0.25 * depth * Vector3d::UnitY(), rim, 0.05 * radius, 0.10 * radius, 20);
    for (int i = 0; i < 3; ++i) {
      const Vector3d out(std::cos(kTurn * i / 3), 0, std::sin(kTurn * i / 3));
      surface_.add_cylinder(rim - 0.05 * depth * Vector3d::UnitY() + 0.08 * radius * out,
                            rim - 0.05 * depth * Vector3d::UnitY() + radius * out, 0.015 * radius, 0.015 * radius, 8);
    }
  }

  // A bell inside the cylinder that is touched.
  void add_nozzle() {
    const Satellite::Part& part = satellite_.part(Satellite::kNozzle);
    const double radius = kInset * cylinder_of(part).radius, length = kInset * cylinder_of(part).length;
    const auto bell = [&](double scale, double facing) {
      surface_.add_patch(32, 10, [&](double u, double v) {
        const double r = scale * radius * (0.35 + 0.65 * std::sqrt(v));
        const Vector3d out(std::cos(kTurn * u), 0, std::sin(kTurn * u));
        return SurfaceVertex{part.centre + r * out + length * (0.5 - v) * Vector3d::UnitY(),
                             facing * (out + 0.3 * Vector3d::UnitY()).normalized()};
      });
    };
    surface_.set_color(kMetal);
    bell(1, 1);
    surface_.set_color(kDarkMetal);
    bell(0.96, -1);
  }

  void add_line(const Vector3d& from, const Vector3d& to) { lines_.add_line(std::array{from, to}); }

  const Satellite& satellite_;
  const Palette& palette_;
  MeshBuilder surface_, lines_;
};

}  // namespace

BodyMesh satellite_target_mesh(const Satellite& satellite, const Palette& palette) {
  return SatellitePainter(satellite, palette).paint();
}

vtkSmartPointer<vtkPolyData> plain_satellite_mesh(const Satellite& satellite) {
  MeshBuilder mesh;
  for (const Satellite::Part& part : satellite.parts()) {
    if (const auto* box = std::get_if<Box>(&part.solid)) {
      mesh.add_box(part.centre, box->size);
    } else {
      const Cylinder& cylinder = cylinder_of(part);
      const Vector3d end = cylinder.length / 2 * Vector3d::UnitY();
      mesh.add_cylinder(part.centre - end, part.centre + end, cylinder.radius, cylinder.radius, 48);
    }
  }
  return mesh.build();
}

}  // namespace netpocket
