#pragma once
// Joins corners that are one. Files such as STL give every triangle its own corners, and programs that export them
// round each by itself. Any thread may call these functions.

#include "engine/bodies/mesh_data.h"

namespace netpocket {

// Corners that are this near are one; of the mesh's extent, the largest edge of the box round its triangles.
inline constexpr double kWeldTolerance = 1e-8;

struct WeldedMesh {
  MeshData mesh;           // without vertices that belong to no triangle
  double tolerance = 0;    // m
  std::size_t joined = 0;  // corners that differed from the one they were joined with
  std::size_t shrunk = 0;  // triangles left out, because this made a line or a point of them
};

// m; vertices of no triangle do not count.
double mesh_extent(const MeshData& data);

// Each vertex becomes the first one in the list that is within `tolerance` (m) of it. Coordinates must be finite and
// corners exist.
WeldedMesh weld(const MeshData& data, double tolerance);

}  // namespace netpocket
