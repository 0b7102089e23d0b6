#pragma once
// Several rigid copies of one mesh, drawn together.

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <Eigen/Core>

namespace netpocket {

class RepeatedMesh {
 public:
  // `pattern` has points and normals.
  RepeatedMesh(vtkPolyData* pattern, std::size_t copies);

  // Pose of a copy: its axes (columns) and origin in the world.
  void place(std::size_t copy, const Eigen::Matrix3d& axes, const Eigen::Vector3d& origin);
  // Call once after placing.
  void modified();

  vtkPolyData* mesh() const { return mesh_; }

 private:
  Eigen::Matrix3Xf pattern_positions_;
  Eigen::Matrix3Xf pattern_normals_;
  vtkSmartPointer<vtkPolyData> mesh_;
};

}  // namespace netpocket
