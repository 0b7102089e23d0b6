#pragma once
// Where the net, its ropes and its mouth are in a snapshot. World frame, m. Pure functions: any thread may call them.

#include <Eigen/Core>
#include <vector>

#include "engine/state/snapshot.h"
#include "engine/state/structure.h"

namespace netpocket {

// Cords and ropes are what holds a target; tubes only carry them.
inline bool is_cord_or_rope(const Structure& structure, const StructureElement& element) {
  return structure.look_of(element) != CableLook::tube;
}

// A straight piece of a cable.
struct CordSegment {
  Eigen::Vector3d from, to;
  double radius;  // m
};

// Each element as `pieces` straight pieces between points of its curve, for the elements that `chosen` holds (indices).
std::vector<CordSegment> cord_segments(const Structure& structure, const Snapshot& snapshot,
                                       const std::vector<std::int32_t>& chosen, int pieces = 4);

// Elements of cords and ropes.
std::vector<std::int32_t> net_elements(const Structure& structure);
// Elements of ropes: the mouth's edge.
std::vector<std::int32_t> rope_elements(const Structure& structure);
// Nodes of cords and ropes, each once, in increasing order.
std::vector<std::int32_t> net_nodes(const Structure& structure);

// Mean length (m) of the sides of the net's meshes: the chains of cord elements between nodes at which anything else
// than one thread ends or passes. 0 without a net.
double mesh_size(const Structure& structure);

// The corners of the mouth in their order, or an empty matrix if the structure has none: the rods' tips.
Eigen::Matrix3Xd mouth_polygon(const Structure& structure, const Snapshot& snapshot);

// Vector area (m^2) of a closed polygon: its size is the area of the projection along it, its direction the normal.
// For plane polygons it is the area.
Eigen::Vector3d vector_area(const Eigen::Matrix3Xd& polygon);

}  // namespace netpocket
