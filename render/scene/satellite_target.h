#pragma once
// What a satellite looks like that is to be caught.

#include "engine/bodies/satellite.h"
#include "render/scene/body_mesh.h"

namespace netpocket {

// With solar cells, dish, engine and radiators; all of it a little inside the surface that is touched.
BodyMesh satellite_target_mesh(const Satellite& satellite, const Palette& palette);

// The surface that is touched: boxes and cylinders.
vtkSmartPointer<vtkPolyData> plain_satellite_mesh(const Satellite& satellite);

}  // namespace netpocket
