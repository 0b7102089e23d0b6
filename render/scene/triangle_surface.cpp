#include "render/scene/triangle_surface.h"

#include <vtkCellArray.h>
#include <vtkFeatureEdges.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataNormals.h>
#include <vtkUnsignedCharArray.h>

namespace netpocket {
namespace {

constexpr double kFeatureAngle = 30;  // degrees
constexpr double kInset = 1e-3;       // of the bounding radius, along the normals

// `inset` in m.
vtkSmartPointer<vtkPolyData> poly_data(const TriangleMesh& mesh, double inset) {
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.vertices().size()));
  for (std::size_t i = 0; i < mesh.vertices().size(); ++i) {
    const Eigen::Vector3d point = mesh.vertices()[i] - inset * mesh.vertex_normal(i);
    points->SetPoint(static_cast<vtkIdType>(i), point.data());
  }
  vtkNew<vtkCellArray> polygons;
  for (const Triangle& t : mesh.triangles()) polygons->InsertNextCell({t[0], t[1], t[2]});
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(polygons);
  return surface;
}

vtkSmartPointer<vtkPolyData> with_normals(vtkPolyData* surface) {
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->SetFeatureAngle(kFeatureAngle);
  normals->SplittingOn();
  normals->ConsistencyOff();
  normals->AutoOrientNormalsOff();
  normals->Update();
  return normals->GetOutput();
}

vtkSmartPointer<vtkPolyData> sharp_edges(vtkPolyData* surface) {
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->SetFeatureAngle(kFeatureAngle);
  edges->BoundaryEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->FeatureEdgesOn();
  edges->ColoringOff();
  edges->Update();
  return edges->GetOutput();
}

void paint(vtkPolyData* mesh, const Color& color) {
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("color");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(mesh->GetNumberOfPoints());
  const ByteColor bytes = to_bytes(color);
  for (int i = 0; i < 3; ++i) colors->FillComponent(i, bytes[i]);
  mesh->GetPointData()->SetScalars(colors);
}

}  // namespace

BodyMesh triangle_surface(const TriangleMesh& mesh, const Palette& palette) {
  const double inset = kInset * mesh.bounding_radius();
  const auto surface = with_normals(poly_data(mesh, inset));
  const auto lines = sharp_edges(poly_data(mesh, 0.5 * inset));
  paint(surface, palette.target);
  paint(lines, palette.target_seams);
  return {surface, lines};
}

vtkSmartPointer<vtkPolyData> plain_triangle_surface(const TriangleMesh& mesh) {
  return with_normals(poly_data(mesh, 0));
}

}  // namespace netpocket
