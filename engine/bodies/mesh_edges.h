#pragma once
// Topology of a mesh: which triangles join at which edges. Any thread may call these functions.

#include <vector>

#include "engine/bodies/mesh_data.h"

namespace netpocket {

// The side of a triangle from its corner `edge` to the next one.
struct TriangleSide {
  std::int32_t triangle;
  int edge;  // 0 to 2
};

struct MeshEdges {
  // By triangle and edge: the neighbour across the edge, as 3 * triangle + edge; -1: none. Where four or more triangles
  // meet, each is joined with the one that bounds the same wedge of the solid. So parts that touch stay separate.
  std::vector<std::array<std::int32_t, 3>> neighbours;
  // Faulty edges, by one side of each, in the order of the vertices.
  std::vector<TriangleSide> open;    // edges of a single triangle
  std::vector<TriangleSide> forked;  // edges of three or more triangles that do not bound wedges
  std::vector<TriangleSide> turned;  // edges along which two triangles run the same way: one faces the wrong way
};

// The corners of the triangles must exist.
MeshEdges find_edges(const MeshData& mesh);

// Middle of a side.
Eigen::Vector3d middle(const MeshData& mesh, const TriangleSide& side);

// The part of each triangle. A part is a set of triangles that are joined at edges. Parts are numbered 0, 1, ... in the
// order of their first triangles.
std::vector<std::int32_t> part_numbers(const MeshEdges& edges);

// Copies vertices so that parts share none, and that fans of triangles which meet only at a vertex share none.
void split_vertices(MeshData& mesh, const MeshEdges& edges);

}  // namespace netpocket
