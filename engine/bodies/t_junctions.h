#pragma once
// Corners that lie on the open edge of another triangle: the surfaces meet there, but no edge joins them.

#include <Eigen/Core>
#include <vector>

#include "engine/bodies/mesh_data.h"

namespace netpocket {

// Of the extent: how near to an edge a corner lies on it.
inline constexpr double kTJunctionTolerance = 1e-6;

// Divides the triangles at such corners, so that their edges join. Corners off the edge by `tolerance` (m) are taken
// along. The places of the corners.
std::vector<Eigen::Vector3d> split_t_junctions(MeshData& mesh, double tolerance);

}  // namespace netpocket
