#pragma once
// T-junctions: corners that lie on an open edge of another triangle. The surfaces meet there, but no edge joins them.

#include <Eigen/Core>
#include <vector>

#include "engine/bodies/mesh_data.h"

namespace netpocket {

// A corner within this fraction of the extent from an edge lies on it.
inline constexpr double kTJunctionTolerance = 1e-6;

// Divides triangles at such corners, so that the edges join. A corner up to `tolerance` off the edge counts; the edge
// then bends to the corner. Returns the places of the corners. All in the unit of the mesh.
std::vector<Eigen::Vector3d> split_t_junctions(MeshData& mesh, double tolerance);

}  // namespace netpocket
