#include "render/scene/repeated_mesh.h"

#include <vtkAppendPolyData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

namespace netpocket {
namespace {

float* values(vtkDataArray* array) { return vtkFloatArray::SafeDownCast(array)->GetPointer(0); }

Eigen::Map<Eigen::Matrix3Xf> columns(vtkDataArray* array) {
  return {values(array), 3, static_cast<Eigen::Index>(array->GetNumberOfTuples())};
}

}  // namespace

RepeatedMesh::RepeatedMesh(vtkPolyData* pattern, std::size_t copies)
    : pattern_positions_(columns(pattern->GetPoints()->GetData())),
      pattern_normals_(columns(pattern->GetPointData()->GetNormals())),
      mesh_(vtkSmartPointer<vtkPolyData>::New()) {
  vtkNew<vtkAppendPolyData> append;
  for (std::size_t i = 0; i < copies; ++i) append->AddInputData(pattern);
  if (copies == 0) return;
  append->Update();
  mesh_->ShallowCopy(append->GetOutput());
}

void RepeatedMesh::place(std::size_t copy, const Eigen::Matrix3d& axes, const Eigen::Vector3d& origin) {
  const auto count = pattern_positions_.cols();
  const auto first = static_cast<Eigen::Index>(copy) * count;
  const Eigen::Matrix3f rotation = axes.cast<float>();
  columns(mesh_->GetPoints()->GetData()).middleCols(first, count) =
      (rotation * pattern_positions_).colwise() + origin.cast<float>();
  columns(mesh_->GetPointData()->GetNormals()).middleCols(first, count) = rotation * pattern_normals_;
}

void RepeatedMesh::modified() {
  if (mesh_->GetNumberOfPoints() == 0) return;
  mesh_->GetPoints()->GetData()->Modified();
  mesh_->GetPoints()->Modified();
  mesh_->GetPointData()->GetNormals()->Modified();
  mesh_->Modified();
}

}  // namespace netpocket
