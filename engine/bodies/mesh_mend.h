#pragma once
// Makes a mended copy of a mesh. It corrects the faults that can be corrected in one way only. Any thread may call
// these functions.

#include <string>
#include <vector>

#include "engine/bodies/mesh_data.h"

namespace netpocket {

struct MendOptions {
  double weld_tolerance = 0;  // mesh's unit; nearer corners are joined; 0: kWeldTolerance times the extent
  double thickness = 0;       // mesh's unit; given to open surfaces and panels without thickness; 0: not changed
  double unit = 1;            // m, the mesh's unit; `changes` state lengths in metres
};

struct MendedMesh {
  MeshData mesh;
  std::vector<std::string> changes;  // one sentence for each kind of change, without a full stop
};

// - Joins corners.
// - Removes duplicate triangles and the inner side of two-sided closed surfaces.
// - Divides edges where corners of other triangles lie on them.
// - Turns neighbours to face the same way, and closed parts to face outwards.
// - If options.thickness > 0, gives open surfaces and panels without thickness that thickness.
// number_fault(data) must be empty. review_mesh() finds the faults that remain.
MendedMesh mend_mesh(const MeshData& data, const MendOptions& options);

}  // namespace netpocket
