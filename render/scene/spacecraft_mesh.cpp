#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "render/scene/body_mesh.h"
#include "render/scene/mesh_builder.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

// Sizes of the solar arrays in widths of the bus.
constexpr double kBoomLength = 0.45;
constexpr int kPanelCount = 3;
constexpr double kPanelLength = 1.15;
constexpr double kPanelGap = 0.06;
constexpr double kPanelChord = 1.1;
constexpr int kCellColumns = 6;
constexpr int kCellRows = 6;

double array_end(double bus_width) {
  return bus_width * (0.5 + kBoomLength + kPanelCount * (kPanelLength + kPanelGap));
}

struct SpacecraftBuilder {
  Vector3d size;
  MeshBuilder surface;
  MeshBuilder lines;

  void add_bus() {
    surface.set_color(kFoil);
    surface.add_box(Vector3d::Zero(), size, 0.05 * size.minCoeff(), kBusEdge);
    // Radiators on two sides and instruments on the other two, a little proud of the foil.
    const double proud = 0.01 * size.x();
    surface.set_color(kBusPanel);
    for (const int side : {-1, 1}) {
      const Vector3d face(0, 0, side * size.z() / 2);
      surface.add_box(face + Vector3d(0, 0.12 * size.y(), 0), Vector3d(0.66 * size.x(), 0.48 * size.y(), 2 * proud));
    }
    surface.set_color(kDarkMetal);
    for (const int side : {-1, 1}) {
      const Vector3d face(0, 0, side * size.z() / 2);
      surface.add_box(face + Vector3d(-0.18 * size.x(), -0.30 * size.y(), 0),
                      Vector3d(0.26 * size.x(), 0.16 * size.y(), 6 * proud));
      surface.add_cylinder(face + Vector3d(0.2 * size.x(), -0.30 * size.y(), 0),
                           face + Vector3d(0.2 * size.x(), -0.30 * size.y(), side * 0.12 * size.z()), 0.10 * size.x(),
                           0.10 * size.x(), 20);
    }
  }

  void add_engine() {
    const double bottom = -size.y() / 2;
    const double width = std::min(size.x(), size.z());
    surface.set_color(kMetal);
    surface.add_cylinder({0, bottom, 0}, {0, bottom - 0.06 * width, 0}, 0.30 * width, 0.30 * width);
    surface.set_color(kDarkMetal);
    surface.add_cylinder({0, bottom - 0.06 * width, 0}, {0, bottom - 0.34 * width, 0}, 0.09 * width, 0.22 * width);
  }

  void add_root_ring(double radius, double height) {
    const double thickness = 0.04 * size.x();
    const double top = size.y() / 2;
    surface.set_color(kMetal);
    if (height > top) surface.add_cylinder({0, top, 0}, {0, height, 0}, radius, radius);
    surface.add_torus({0, height, 0}, Vector3d::UnitY(), radius, 1.5 * thickness);
  }

  void add_panel(const Vector3d& center, double length, double chord) {
    surface.set_color(kSolarCell);
    const double thickness = 0.02 * size.x();
    surface.add_box(center, {length, chord, thickness});
    lines.set_color(kSolarGrid);
    for (const int side : {-1, 1}) {
      const Vector3d face = center + Vector3d(0, 0, side * 0.55 * thickness);
      for (int i = 0; i <= kCellColumns; ++i) {
        const double x = length * (static_cast<double>(i) / kCellColumns - 0.5);
        lines.add_line(
            std::array{Vector3d(face + Vector3d(x, -chord / 2, 0)), Vector3d(face + Vector3d(x, chord / 2, 0))});
      }
      for (int i = 0; i <= kCellRows; ++i) {
        const double y = chord * (static_cast<double>(i) / kCellRows - 0.5);
        lines.add_line(
            std::array{Vector3d(face + Vector3d(-length / 2, y, 0)), Vector3d(face + Vector3d(length / 2, y, 0))});
      }
    }
  }

  void add_solar_array(int side) {
    const double width = size.x();
    const double length = kPanelLength * width, chord = kPanelChord * width;
    const double hinge = width * (0.5 + kBoomLength);
    surface.set_color(kMetal);
    const double strut = 0.025 * width;
    surface.add_cylinder({side * width / 2, 0, 0}, {side * (width * 0.5 + 0.2 * width), 0, 0}, 2 * strut, 2 * strut,
                         16);
    for (const double end : {-0.5, 0.5}) {
      surface.add_cylinder({side * (width * 0.7), 0, 0}, {side * hinge, end * 0.8 * chord, 0}, strut, strut, 12);
    }
    for (int i = 0; i < kPanelCount; ++i) {
      const double inner = hinge + i * (length + kPanelGap * width);
      add_panel({side * (inner + length / 2), 0, 0}, length, chord);
      if (i == 0) continue;
      for (const double end : {-0.3, 0.3}) {
        const double y = end * chord;
        surface.set_color(kMetal);
        surface.add_cylinder({side * (inner - kPanelGap * width), y, 0}, {side * inner, y, 0}, strut, strut, 8);
      }
    }
  }
};

}  // namespace

BodyMesh spacecraft_mesh(const Shape& shape, double root_radius, double root_height) {
  SpacecraftBuilder builder{shape_size(shape), {}, {}};
  builder.add_bus();
  builder.add_engine();
  builder.add_root_ring(root_radius, root_height);
  builder.add_solar_array(-1);
  builder.add_solar_array(1);
  return {builder.surface.build(), builder.lines.build()};
}

Eigen::Vector3d spacecraft_half_extent(const Shape& shape) {
  const Vector3d size = shape_size(shape);
  return {array_end(size.x()), std::max(size.y() / 2 + 0.4 * size.x(), kPanelChord * size.x() / 2), size.z() / 2};
}

}  // namespace netpocket
