#pragma once
// Builds coloured surfaces and lines from simple solids. Lengths in m, in any frame.

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Core>
#include <functional>
#include <numbers>
#include <span>

#include "render/scene/color.h"

namespace netpocket {

inline constexpr double kTurn = 2 * std::numbers::pi;

struct SurfaceVertex {
  Eigen::Vector3d position;
  Eigen::Vector3d normal;  // outward
};

class MeshBuilder {
 public:
  MeshBuilder();

  // Of everything added from now on.
  void set_color(const Color& color) { color_ = to_bytes(color); }

  // A curved piece: a grid of columns x rows quads over (u, v) in [0, 1]^2.
  void add_patch(int columns, int rows, const std::function<SurfaceVertex(double u, double v)>& surface);
  // A flat convex piece that faces away from `inside`.
  void add_polygon(std::span<const Eigen::Vector3d> corners, const Eigen::Vector3d& inside);
  // A box with edge lengths `size` along the axes, its edges cut off by `bevel` in `edge_color`.
  void add_box(const Eigen::Vector3d& center, const Eigen::Vector3d& size, double bevel, const Color& edge_color);
  void add_box(const Eigen::Vector3d& center, const Eigen::Vector3d& size);
  // A cylinder, or the frustum of a cone, with flat ends.
  void add_cylinder(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius_from, double radius_to,
                    int sides = 32);
  void add_sphere(const Eigen::Vector3d& center, double radius, int columns = 24, int rows = 12);
  void add_torus(const Eigen::Vector3d& center, const Eigen::Vector3d& axis, double radius, double tube_radius);
  void add_line(std::span<const Eigen::Vector3d> points);

  // With normals and colours at the points.
  vtkSmartPointer<vtkPolyData> build() const;

 private:
  vtkIdType add_point(const Eigen::Vector3d& position, const Eigen::Vector3d& normal);
  // Counter-clockwise seen from the side that the first corner's normal points to.
  void add_quad(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d);

  ByteColor color_{255, 255, 255};
  vtkNew<vtkFloatArray> positions_;
  vtkNew<vtkFloatArray> normals_;
  vtkNew<vtkUnsignedCharArray> colors_;
  vtkNew<vtkCellArray> polygons_;
  vtkNew<vtkCellArray> lines_;
};

// Two unit vectors that make a right-handed frame with a unit `axis`: {first, second, axis}.
struct CrossAxes {
  Eigen::Vector3d first;
  Eigen::Vector3d second;
};
CrossAxes cross_axes(const Eigen::Vector3d& axis);

}  // namespace netpocket
