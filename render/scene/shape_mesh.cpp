#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "render/scene/body_mesh.h"
#include "render/scene/mesh_builder.h"
#include "render/scene/satellite_target.h"
#include "render/scene/triangle_surface.h"

namespace netpocket {
namespace {

constexpr double kSurfaceInset = 0.997;
constexpr double kSeamInset = 0.998;

using SurfaceMap = std::function<SurfaceVertex(double u, double v)>;

// Panels over (u, v) in [0, 1]^2, alternating in shade, and the seams between them.
class PanelPainter {
 public:
  PanelPainter(MeshBuilder& surface, MeshBuilder& lines, const Palette& palette)
      : surface_(surface), lines_(lines), palette_(palette) {
    lines_.set_color(palette.target_seams);
  }

  void add(int columns, int rows, int quads, const SurfaceMap& map) {
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        surface_.set_color((row + column) % 2 ? palette_.target_panels : palette_.target);
        surface_.add_patch(quads, quads, [&](double u, double v) {
          auto vertex = map((column + u) / columns, (row + v) / rows);
          vertex.position *= kSurfaceInset;
          return vertex;
        });
      }
    }
    const int steps = 16;
    for (int row = 0; row <= rows; ++row) {
      add_seam(columns * steps, [&](double s) { return map(s, static_cast<double>(row) / rows); });
    }
    for (int column = 0; column <= columns; ++column) {
      add_seam(rows * steps, [&](double s) { return map(static_cast<double>(column) / columns, s); });
    }
  }

 private:
  void add_seam(int steps, const std::function<SurfaceVertex(double)>& curve) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i <= steps; ++i) points.push_back(kSeamInset * curve(static_cast<double>(i) / steps).position);
    lines_.add_line(points);
  }

  MeshBuilder& surface_;
  MeshBuilder& lines_;
  const Palette& palette_;
};

void paint(PanelPainter& painter, const Sphere& sphere) {
  painter.add(12, 6, 6, [&](double u, double v) {
    const double polar = std::numbers::pi * v;
    const Eigen::Vector3d normal(std::sin(polar) * std::cos(kTurn * u), std::cos(polar),
                                 std::sin(polar) * std::sin(kTurn * u));
    return SurfaceVertex{sphere.radius * normal, normal};
  });
}

void paint(PanelPainter& painter, const Box& box) {
  for (int axis = 0; axis < 3; ++axis) {
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    for (const double side : {-0.5, 0.5}) {
      painter.add(4, 4, 1, [&](double u, double v) {
        Eigen::Vector3d place, normal = Eigen::Vector3d::Zero();
        place[axis] = side;
        place[next] = u - 0.5;
        place[last] = v - 0.5;
        normal[axis] = 2 * side;
        return SurfaceVertex{box.size.cwiseProduct(place), normal};
      });
    }
  }
}

void paint(PanelPainter& painter, const Cylinder& cylinder) {
  const auto radial = [](double u) { return Eigen::Vector3d(std::cos(kTurn * u), 0, std::sin(kTurn * u)); };
  const Eigen::Vector3d up = Eigen::Vector3d::UnitY();
  painter.add(12, 4, 6, [&](double u, double v) {
    return SurfaceVertex{cylinder.radius * radial(u) + (v - 0.5) * cylinder.length * up, radial(u)};
  });
  for (const double side : {-0.5, 0.5}) {
    painter.add(12, 2, 6, [&](double u, double v) {
      return SurfaceVertex{v * cylinder.radius * radial(u) + side * cylinder.length * up, 2 * side * up};
    });
  }
}

struct ShapePainter {
  const Palette& palette;

  BodyMesh operator()(const Satellite& satellite) const { return satellite_target_mesh(satellite, palette); }
  BodyMesh operator()(const MeshShape& shape) const { return triangle_surface(*shape.mesh, palette); }
  template <typename Solid>
  BodyMesh operator()(const Solid& solid) const {
    MeshBuilder surface, lines;
    PanelPainter painter(surface, lines, palette);
    paint(painter, solid);
    return {surface.build(), lines.build()};
  }
};

struct PlainPainter {
  vtkSmartPointer<vtkPolyData> operator()(const Satellite& satellite) const { return plain_satellite_mesh(satellite); }
  vtkSmartPointer<vtkPolyData> operator()(const MeshShape& shape) const { return plain_triangle_surface(*shape.mesh); }
  vtkSmartPointer<vtkPolyData> operator()(const Sphere& sphere) const {
    MeshBuilder mesh;
    mesh.add_sphere({0, 0, 0}, sphere.radius, 48, 24);
    return mesh.build();
  }
  vtkSmartPointer<vtkPolyData> operator()(const Box& box) const {
    MeshBuilder mesh;
    mesh.add_box({0, 0, 0}, box.size);
    return mesh.build();
  }
  vtkSmartPointer<vtkPolyData> operator()(const Cylinder& cylinder) const {
    MeshBuilder mesh;
    const Eigen::Vector3d end = Eigen::Vector3d::UnitY() * cylinder.length / 2;
    mesh.add_cylinder(-end, end, cylinder.radius, cylinder.radius, 48);
    return mesh.build();
  }
};

}  // namespace

BodyMesh shape_mesh(const Shape& shape, const Palette& palette) { return std::visit(ShapePainter{palette}, shape); }

vtkSmartPointer<vtkPolyData> plain_shape_mesh(const Shape& shape) { return std::visit(PlainPainter{}, shape); }

Eigen::Vector3d shape_size(const Shape& shape) {
  const Eigen::AlignedBox3d box = extents(shape);
  return 2 * box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs());
}

}  // namespace netpocket
