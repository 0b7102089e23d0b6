#pragma once
// What rigid bodies look like, in body axes: a surface, and lines on it.

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "engine/state/structure.h"
#include "render/scene/palette.h"

namespace netpocket {

struct BodyMesh {
  vtkSmartPointer<vtkPolyData> surface;
  vtkSmartPointer<vtkPolyData> lines;
};

// A shape in panels of two shades with seams, so that its rotation is seen; meshes and satellites as they are. The
// surface lies a little inside the true
// one: cords that touch it are chords of it between their points, and must not disappear in it.
BodyMesh shape_mesh(const Shape& shape, const Palette& palette);

// The shape's true surface, without pattern.
vtkSmartPointer<vtkPolyData> plain_shape_mesh(const Shape& shape);

// A bus of the shape's size with a ring of `root_radius` (m) for the rods on its +Y side, `root_height` (m) above the
// centre of mass, an engine on its -Y side, and two solar arrays along its x axis. Only the bus is touched by anything.
BodyMesh spacecraft_mesh(const Shape& shape, double root_radius, double root_height);

// How far a spacecraft with this shape reaches along +-x and +-z, m.
Eigen::Vector3d spacecraft_half_extent(const Shape& shape);

// Full edge lengths of the box around a shape, centred at its centre of mass, m.
Eigen::Vector3d shape_size(const Shape& shape);

}  // namespace netpocket
