#include "render/output/run_meshes.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <iterator>

#include "render/scene/body_mesh.h"

namespace netpocket {
namespace {

template <typename Array>
vtkSmartPointer<Array> make_array(const char* name, int components, vtkIdType tuples) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

void set_column(vtkFloatArray& array, vtkIdType tuple, const Eigen::Vector3d& value) {
  array.SetTuple(tuple, value.data());
}

// The names of groups as field data.
template <typename Groups>
void add_names(const char* name, const Groups& groups, vtkPolyData& mesh) {
  const auto names = vtkSmartPointer<vtkStringArray>::New();
  names->SetName(name);
  for (const auto& group : groups) names->InsertNextValue(group.name);
  mesh.GetFieldData()->AddArray(names);
}

// Positions and velocities along the elements, a line for each.
void add_curves(const Structure& structure, const Snapshot& snapshot, const ElementCurve& curve, vtkPolyData& mesh) {
  const int points_each = curve.point_count();
  const auto point_count = static_cast<vtkIdType>(structure.elements.size()) * points_each;
  const auto positions = make_array<vtkFloatArray>("Points", 3, point_count);
  const auto velocities = make_array<vtkFloatArray>("velocity", 3, point_count);
  vtkNew<vtkCellArray> lines;
  vtkIdType point = 0;
  for (const auto& element : structure.elements) {
    lines->InsertNextCell(points_each);
    for (int i = 0; i < points_each; ++i, ++point) {
      const double s = curve.fraction(i);
      lines->InsertCellPoint(point);
      set_column(*positions, point, curve.position(snapshot, element, i));
      set_column(*velocities, point,
                 (1 - s) * snapshot.velocities.col(element.node[0]) + s * snapshot.velocities.col(element.node[1]));
    }
  }
  vtkNew<vtkPoints> points;
  points->SetData(positions);
  mesh.SetPoints(points);
  mesh.SetLines(lines);
  mesh.GetPointData()->AddArray(velocities);
}

void add_element_data(const Structure& structure, const Snapshot& snapshot, vtkPolyData& mesh) {
  const auto count = static_cast<vtkIdType>(structure.elements.size());
  const auto tension = make_array<vtkFloatArray>("tension", 1, count);
  const auto strain = make_array<vtkFloatArray>("strain", 1, count);
  const auto group = make_array<vtkIntArray>("group", 1, count);
  const auto thread = make_array<vtkIntArray>("thread", 1, count);
  for (vtkIdType i = 0; i < count; ++i) {
    tension->SetValue(i, static_cast<float>(snapshot.tension[i]));
    strain->SetValue(i, static_cast<float>(snapshot.strain[i]));
    group->SetValue(i, structure.elements[i].group);
    thread->SetValue(i, structure.elements[i].thread);
  }
  for (vtkDataArray* array : {static_cast<vtkDataArray*>(tension), static_cast<vtkDataArray*>(strain),
                              static_cast<vtkDataArray*>(group), static_cast<vtkDataArray*>(thread)}) {
    mesh.GetCellData()->AddArray(array);
  }
  add_names("groups", structure.element_groups, mesh);
}

// A surface in body axes, brought to a pose: points and normals. Its colours are for our own pictures.
vtkSmartPointer<vtkPolyData> placed(vtkPolyData& surface, const BodyState& state) {
  const vtkIdType count = surface.GetNumberOfPoints();
  const auto positions = make_array<vtkFloatArray>("Points", 3, count);
  const auto normals = make_array<vtkFloatArray>("Normals", 3, count);
  auto* in_body = surface.GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < count; ++i) {
    const Eigen::Vector3d position = Eigen::Map<const Eigen::Vector3d>(surface.GetPoint(i));
    const Eigen::Vector3d normal = Eigen::Map<const Eigen::Vector3d>(in_body->GetTuple3(i));
    set_column(*positions, i, state.position + state.attitude * position);
    set_column(*normals, i, state.attitude * normal);
  }
  vtkNew<vtkPoints> points;
  points->SetData(positions);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(surface.GetPolys());
  mesh->GetPointData()->SetNormals(normals);
  return mesh;
}

}  // namespace

std::string run_part_name(RunPart part) {
  switch (part) {
    case RunPart::bodies:
      return "bodies";
    case RunPart::ropes:
      return "ropes";
    case RunPart::lines:
      break;
  }
  return "lines";
}

std::vector<RunPart> run_parts(const Structure& structure) {
  std::vector<RunPart> parts = {RunPart::lines};
  if (!structure.bodies.empty()) parts.push_back(RunPart::bodies);
  if (!rope_groups(structure).empty()) parts.push_back(RunPart::ropes);
  return parts;
}

vtkSmartPointer<vtkPolyData> line_mesh(const Structure& structure, const Snapshot& snapshot,
                                       const ElementCurve& curve) {
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  add_curves(structure, snapshot, curve, *mesh);
  add_element_data(structure, snapshot, *mesh);
  return mesh;
}

std::vector<NodeGroup> rope_groups(const Structure& structure) {
  std::vector<NodeGroup> groups;
  std::ranges::copy_if(structure.node_groups, std::back_inserter(groups),
                       [](const NodeGroup& group) { return group.look == NodeLook::rope && group.nodes.size() > 1; });
  return groups;
}

vtkSmartPointer<vtkPolyData> rope_mesh(const Structure& structure, const Snapshot& snapshot) {
  const std::vector<NodeGroup> ropes = rope_groups(structure);
  vtkIdType point_count = 0;
  for (const NodeGroup& rope : ropes) point_count += static_cast<vtkIdType>(rope.nodes.size());
  const auto positions = make_array<vtkFloatArray>("Points", 3, point_count);
  const auto velocities = make_array<vtkFloatArray>("velocity", 3, point_count);
  const auto index = make_array<vtkIntArray>("rope", 1, static_cast<vtkIdType>(ropes.size()));
  vtkNew<vtkCellArray> lines;
  vtkIdType point = 0;
  for (std::size_t i = 0; i < ropes.size(); ++i) {
    index->SetValue(static_cast<vtkIdType>(i), static_cast<int>(i));
    lines->InsertNextCell(static_cast<int>(ropes[i].nodes.size()));
    for (const std::int32_t node : ropes[i].nodes) {
      set_column(*positions, point, snapshot.positions.col(node));
      set_column(*velocities, point, snapshot.velocities.col(node));
      lines->InsertCellPoint(point++);
    }
  }
  vtkNew<vtkPoints> points;
  points->SetData(positions);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetLines(lines);
  mesh->GetPointData()->AddArray(velocities);
  mesh->GetCellData()->AddArray(index);
  add_names("ropes", ropes, *mesh);
  return mesh;
}

vtkSmartPointer<vtkPolyData> body_meshes(const Structure& structure, const Snapshot& snapshot) {
  vtkNew<vtkAppendPolyData> append;
  for (std::size_t i = 0; i < structure.bodies.size(); ++i) {
    const auto mesh = placed(*plain_shape_mesh(structure.bodies[i].shape), snapshot.bodies[i]);
    const auto index = make_array<vtkIntArray>("body", 1, mesh->GetNumberOfCells());
    index->FillValue(static_cast<int>(i));
    mesh->GetCellData()->AddArray(index);
    append->AddInputData(mesh);
  }
  append->Update();
  return append->GetOutput();
}

vtkSmartPointer<vtkPolyData> part_mesh(RunPart part, const Structure& structure, const Snapshot& snapshot,
                                       const ElementCurve& curve) {
  switch (part) {
    case RunPart::bodies:
      return body_meshes(structure, snapshot);
    case RunPart::ropes:
      return rope_mesh(structure, snapshot);
    case RunPart::lines:
      break;
  }
  return line_mesh(structure, snapshot, curve);
}

}  // namespace netpocket
