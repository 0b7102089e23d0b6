#include "render/scene/mesh_builder.h"

#include <vtkPointData.h>
#include <vtkPoints.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <vector>

namespace netpocket {
namespace {

// The corner of a box on the sides given by signs.
Eigen::Vector3d corner(const Eigen::Vector3d& half, int x, int y, int z) {
  return half.cwiseProduct(Eigen::Vector3d(x, y, z));
}

}  // namespace

CrossAxes cross_axes(const Eigen::Vector3d& axis) {
  const Eigen::Vector3d first = axis.unitOrthogonal();
  return {first, axis.cross(first)};
}

MeshBuilder::MeshBuilder() {
  positions_->SetNumberOfComponents(3);
  normals_->SetNumberOfComponents(3);
  colors_->SetNumberOfComponents(3);
  colors_->SetName("color");
}

vtkIdType MeshBuilder::add_point(const Eigen::Vector3d& position, const Eigen::Vector3d& normal) {
  normals_->InsertNextTuple(normal.data());
  colors_->InsertNextTypedTuple(color_.data());
  return positions_->InsertNextTuple(position.data());
}

void MeshBuilder::add_patch(int columns, int rows, const std::function<SurfaceVertex(double, double)>& surface) {
  const vtkIdType first = positions_->GetNumberOfTuples();
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const auto vertex = surface(static_cast<double>(column) / columns, static_cast<double>(row) / rows);
      add_point(vertex.position, vertex.normal);
    }
  }
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const vtkIdType lower = first + row * (columns + 1) + column;
      const vtkIdType upper = lower + columns + 1;
      add_quad(lower, lower + 1, upper + 1, upper);
    }
  }
}

void MeshBuilder::add_quad(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d) {
  const auto vector = [](vtkFloatArray& array, vtkIdType id) {
    return Eigen::Vector3d(Eigen::Map<const Eigen::Vector3d>(array.GetTuple3(id)));
  };
  // By the diagonals: one side may have no length, at the pole of a sphere.
  const Eigen::Vector3d first = vector(*positions_, c) - vector(*positions_, a);
  const Eigen::Vector3d second = vector(*positions_, d) - vector(*positions_, b);
  if (first.cross(second).dot(vector(*normals_, a)) < 0) {
    polygons_->InsertNextCell({a, d, c, b});
  } else {
    polygons_->InsertNextCell({a, b, c, d});
  }
}

void MeshBuilder::add_polygon(std::span<const Eigen::Vector3d> corners, const Eigen::Vector3d& inside) {
  const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
  const double outwards = normal.dot(corners[0] - inside) < 0 ? -1 : 1;
  std::vector<vtkIdType> ids;
  for (const auto& position : corners) ids.push_back(add_point(position, outwards * normal));
  if (outwards < 0) std::ranges::reverse(ids);
  polygons_->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
}

void MeshBuilder::add_box(const Eigen::Vector3d& center, const Eigen::Vector3d& size) { add_box(center, size, 0, {}); }

void MeshBuilder::add_box(const Eigen::Vector3d& center, const Eigen::Vector3d& size, double bevel,
                          const Color& edge_color) {
  const Eigen::Vector3d half = size / 2;
  // The end of a face's corner: pulled in by the bevel along every axis but the face's own.
  const auto pulled = [&](int axis, int x, int y, int z) {
    Eigen::Vector3d inset = Eigen::Vector3d::Constant(bevel);
    inset[axis] = 0;
    return Eigen::Vector3d(center + corner(half - inset, x, y, z));
  };
  const auto add = [&](std::initializer_list<Eigen::Vector3d> corners) {
    add_polygon({corners.begin(), corners.end()}, center);
  };
  for (const int s : {-1, 1}) {
    add({pulled(0, s, -1, -1), pulled(0, s, 1, -1), pulled(0, s, 1, 1), pulled(0, s, -1, 1)});
    add({pulled(1, -1, s, -1), pulled(1, -1, s, 1), pulled(1, 1, s, 1), pulled(1, 1, s, -1)});
    add({pulled(2, -1, -1, s), pulled(2, 1, -1, s), pulled(2, 1, 1, s), pulled(2, -1, 1, s)});
  }
  if (bevel <= 0) return;
  const auto face_color = color_;
  set_color(edge_color);
  for (const int s : {-1, 1}) {
    for (const int t : {-1, 1}) {
      add({pulled(0, s, t, -1), pulled(0, s, t, 1), pulled(1, s, t, 1), pulled(1, s, t, -1)});
      add({pulled(1, -1, s, t), pulled(1, 1, s, t), pulled(2, 1, s, t), pulled(2, -1, s, t)});
      add({pulled(0, s, -1, t), pulled(0, s, 1, t), pulled(2, s, 1, t), pulled(2, s, -1, t)});
      for (const int u : {-1, 1}) add({pulled(0, s, t, u), pulled(1, s, t, u), pulled(2, s, t, u)});
    }
  }
  color_ = face_color;
}

void MeshBuilder::add_cylinder(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius_from,
                               double radius_to, int sides) {
  const Eigen::Vector3d along = to - from;
  const Eigen::Vector3d axis = along.normalized();
  const auto cross = cross_axes(axis);
  const auto radial = [&](double u) {
    return Eigen::Vector3d(std::cos(kTurn * u) * cross.first + std::sin(kTurn * u) * cross.second);
  };
  const double slope = (radius_from - radius_to) / along.norm();
  add_patch(sides, 1, [&](double u, double v) {
    const double radius = radius_from + v * (radius_to - radius_from);
    return SurfaceVertex{from + v * along + radius * radial(u), (radial(u) + slope * axis).normalized()};
  });
  for (const bool end : {false, true}) {
    std::vector<Eigen::Vector3d> rim;
    for (int i = 0; i < sides; ++i) {
      rim.push_back((end ? to : from) + (end ? radius_to : radius_from) * radial(static_cast<double>(i) / sides));
    }
    add_polygon(rim, (from + to) / 2);
  }
}

void MeshBuilder::add_sphere(const Eigen::Vector3d& center, double radius, int columns, int rows) {
  add_patch(columns, rows, [&](double u, double v) {
    const double polar = std::numbers::pi * v;
    const Eigen::Vector3d normal(std::sin(polar) * std::cos(kTurn * u), std::cos(polar),
                                 std::sin(polar) * std::sin(kTurn * u));
    return SurfaceVertex{center + radius * normal, normal};
  });
}

void MeshBuilder::add_torus(const Eigen::Vector3d& center, const Eigen::Vector3d& axis, double radius,
                            double tube_radius) {
  const auto cross = cross_axes(axis);
  add_patch(64, 12, [&](double u, double v) {
    const Eigen::Vector3d outward = std::cos(kTurn * u) * cross.first + std::sin(kTurn * u) * cross.second;
    const Eigen::Vector3d normal = std::cos(kTurn * v) * outward + std::sin(kTurn * v) * axis;
    return SurfaceVertex{center + radius * outward + tube_radius * normal, normal};
  });
}

void MeshBuilder::add_line(std::span<const Eigen::Vector3d> points) {
  std::vector<vtkIdType> ids;
  for (const auto& position : points) ids.push_back(add_point(position, Eigen::Vector3d::UnitY()));
  lines_->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
}

vtkSmartPointer<vtkPolyData> MeshBuilder::build() const {
  vtkNew<vtkPoints> points;
  points->SetData(positions_);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polygons_);
  mesh->SetLines(lines_);
  mesh->GetPointData()->SetNormals(normals_);
  mesh->GetPointData()->SetScalars(colors_);
  return mesh;
}

}  // namespace netpocket
