#pragma once
// Joins corners that belong together. Files such as STL give every triangle its own corners, and programs round each of
// them separately. Any thread may call these functions.

#include "engine/bodies/mesh_data.h"

namespace netpocket {

// Default tolerance of welding, as a fraction of the mesh's extent (mesh_extent).
inline constexpr double kWeldTolerance = 1e-8;

struct WeldedMesh {
  MeshData mesh;           // without vertices that belong to no triangle
  double tolerance = 0;    // m
  std::size_t joined = 0;  // number of corners that differed from the one they were joined with
  std::size_t shrunk = 0;  // number of triangles removed because welding reduced them to a line or a point
};

// Extent of a mesh: largest edge (m) of the bounding box of its triangles. Unused vertices do not count.
double mesh_extent(const MeshData& data);

// Replaces each vertex by the first one in the list that is within `tolerance` (m) of it. With a tolerance of 0 only
// equal vertices are joined. Coordinates must be finite, and corners must exist.
WeldedMesh weld(const MeshData& data, double tolerance);

}  // namespace netpocket
