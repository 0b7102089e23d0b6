#pragma once
// Builds the target's shape from its scenario.

#include <Eigen/Core>
#include <variant>

#include "engine/base/diagnostics.h"
#include "engine/bodies/shape.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

// The shape, or one sentence on what is wrong with it. A mesh is read from its file. The file must lie in the
// scenario's folder or below it, with links followed, unless scenario.files allows an absolute path. The latest mesh is
// cached: another call only compares the file's size and date. A kept mesh (KeptMesh) is used without access to its
// file. Thread contract: any thread may call it.
std::variant<Shape, Diagnostic> target_shape(const Scenario& scenario);

// Makes the scenario use this mesh as long as it names the same file: see KeptMesh. Does nothing for other shapes.
void keep_mesh(Scenario& scenario, const Shape& shape);

// kg m^2, about the centre of mass, body axes: as given, or that of the shape filled evenly with the mass.
Eigen::Matrix3d target_inertia(const TargetParameters& target, const Shape& shape);

}  // namespace netpocket
