#include "render/scene/surface_props.h"

#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>

#include "render/scene/soft_shading.h"

namespace netpocket {
namespace {

vtkSmartPointer<vtkActor> make_actor(vtkPolyData* mesh, const Color& color) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->SetColorModeToDirectScalars();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->PickableOff();
  return actor;
}

}  // namespace

vtkSmartPointer<vtkActor> make_surface(vtkPolyData* mesh, Background background, const Color& color) {
  auto actor = make_actor(mesh, color);
  actor->GetProperty()->BackfaceCullingOn();
  add_soft_shading(*actor, background);
  return actor;
}

vtkSmartPointer<vtkActor> make_lines(vtkPolyData* mesh, const Color& color) {
  auto actor = make_actor(mesh, color);
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkSmartPointer<vtkActor> make_dots(vtkPolyData* mesh, const Color& color) {
  auto actor = make_lines(mesh, color);
  // Points are squares otherwise.
  actor->GetShaderProperty()->AddFragmentShaderReplacement(
      "//VTK::Light::Impl", true, "  if (length(gl_PointCoord - vec2(0.5)) > 0.5) discard;\n//VTK::Light::Impl\n",
      false);
  return actor;
}

}  // namespace netpocket
