#pragma once
// Which of many boxes are near each other. World frame, m.

#include <Eigen/Geometry>
#include <span>
#include <utility>
#include <vector>

#include "engine/base/divided_loop.h"

namespace netpocket {

// Pairs of boxes that are within `margin` of each other along every axis, smaller index first, ascending. Neighbours in
// a net always are. Threads may share the loops; the answer does not depend on them. Boxes must be finite.
std::vector<std::pair<int, int>> near_pairs(std::span<const Eigen::AlignedBox3d> boxes, double margin,
                                            const DividedLoop& loop = undivided_loop);

}  // namespace netpocket
