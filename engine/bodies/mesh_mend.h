#pragma once
// A mended copy of a mesh: of what is wrong with it, that which can be put right in one way only. Any thread may call
// these functions.

#include <string>
#include <vector>

#include "engine/bodies/mesh_data.h"

namespace netpocket {

struct MendOptions {
  // In the mesh's unit.
  double weld_tolerance = 0;  // corners that are this near are joined; 0: kWeldTolerance of the extent
  double thickness = 0;       // that open surfaces and panels without thickness get; 0: they stay as they are
  double unit = 1;            // m: the changes tell of lengths in metres
};

struct MendedMesh {
  MeshData mesh;
  std::vector<std::string> changes;  // what was done, one sentence each, without a full stop; empty: nothing
};

// Joins corners; leaves out triangles that are there twice and the inner side of two-sided closed surfaces; divides
// edges where corners of other triangles lie on them; lets neighbours face the same way, closed parts outwards. The
// numbers must be sound (number_fault). What is left, review_mesh() tells.
MendedMesh mend_mesh(const MeshData& data, const MendOptions& options);

}  // namespace netpocket
