#pragma once
// VTK props with the scene's materials.

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "render/scene/color.h"
#include "render/scene/scene_options.h"

namespace netpocket {

// A closed surface in soft light; colours from the mesh when it has any.
vtkSmartPointer<vtkActor> make_surface(vtkPolyData* mesh, Background background, const Color& color = {1, 1, 1});

// Unlit lines; colours from the mesh when it has any.
vtkSmartPointer<vtkActor> make_lines(vtkPolyData* mesh, const Color& color = {1, 1, 1});

// Unlit round points, for meshes of nothing else; colours from the mesh when it has any.
vtkSmartPointer<vtkActor> make_dots(vtkPolyData* mesh, const Color& color = {1, 1, 1});

}  // namespace netpocket
