#pragma once
// The target's shape as its scenario describes it.

#include <Eigen/Core>
#include <variant>

#include "engine/base/diagnostics.h"
#include "engine/bodies/shape.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

// The shape, or what is wrong with it in one sentence. A mesh is read from its file, which must lie in the folder of
// the scenario or below, wherever links lead, unless scenario.files allows an absolute path. The latest mesh is kept,
// so that asking again costs a look at the file's date. Any thread may call it. A kept
// mesh is taken without a look at its file.
std::variant<Shape, Diagnostic> target_shape(const Scenario& scenario);

// From now on the target is built with this mesh as long as the scenario names the same file: see KeptMesh. Does
// nothing for other shapes.
void keep_mesh(Scenario& scenario, const Shape& shape);

// kg m^2, about the centre of mass, body axes: as given, or that of the evenly filled shape.
Eigen::Matrix3d target_inertia(const TargetParameters& target, const Shape& shape);

}  // namespace netpocket
