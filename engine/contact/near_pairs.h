#pragma once
// Finds the pairs of boxes that are near each other. World frame, m.

#include <Eigen/Geometry>
#include <span>
#include <utility>
#include <vector>

#include "engine/base/divided_loop.h"

namespace netpocket {

// Pairs of boxes that are within `margin` (m) of each other along every axis. Each pair has its smaller index first;
// the pairs are in ascending order. Neighbours in a net are always among them. Threads may share the loops; the result
// does not depend on them. Boxes must be finite.
std::vector<std::pair<int, int>> near_pairs(std::span<const Eigen::AlignedBox3d> boxes, double margin,
                                            const DividedLoop& loop = undivided_loop);

}  // namespace netpocket
