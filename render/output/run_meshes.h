#pragma once
// A moment of a run as VTK meshes, for files that ParaView reads.

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "engine/state/snapshot.h"
#include "engine/state/structure.h"
#include "render/scene/element_curve.h"

namespace netpocket {

// Cords and rods, a line for each element: tension (N), strain (Green), group (index into Structure::element_groups,
// whose names are the field data "groups") and thread by line, velocity (m/s) by point. Positions in m, world frame.
vtkSmartPointer<vtkPolyData> line_mesh(const Structure& structure, const Snapshot& snapshot, const ElementCurve& curve);

// The bodies' true surfaces at their poses: their index in `body` by polygon, outward `Normals` by point.
vtkSmartPointer<vtkPolyData> body_meshes(const Structure& structure, const Snapshot& snapshot);

}  // namespace netpocket
