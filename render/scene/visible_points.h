#pragma once

#include <Eigen/Core>

#include "engine/state/snapshot.h"
#include "engine/state/structure.h"

namespace netpocket {

// What must be in the picture of a snapshot: nodes and the outlines of the bodies; m, world. For frame_view; join those
// of several snapshots to frame a run.
Eigen::Matrix3Xd visible_points(const Structure& structure, const Snapshot& snapshot);

}  // namespace netpocket
