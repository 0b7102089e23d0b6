#pragma once
// Pictures of triangle meshes.

#include "engine/bodies/triangle_mesh.h"
#include "render/scene/body_mesh.h"

namespace netpocket {

// Shaded smoothly, but flat across edges sharper than 30 degrees, which are drawn as lines. The surface lies a little
// inside the true one.
BodyMesh triangle_surface(const TriangleMesh& mesh, const Palette& palette);

// The true surface, with normals likewise.
vtkSmartPointer<vtkPolyData> plain_triangle_surface(const TriangleMesh& mesh);

}  // namespace netpocket
