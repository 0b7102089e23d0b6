#pragma once
// How the triangles of a mesh join at their edges. Any thread may call these functions.

#include <vector>

#include "engine/bodies/mesh_data.h"

namespace netpocket {

// The side of a triangle from its corner `edge` to the next one.
struct TriangleSide {
  std::int32_t triangle;
  int edge;  // 0 to 2
};

struct MeshEdges {
  // By triangle and edge: the triangle that goes on beyond it, as 3 * triangle + edge; -1: none. Where four triangles
  // or more meet, each is joined with the one that bounds the same wedge of the solid: parts that touch stay apart.
  std::vector<std::array<std::int32_t, 3>> strain_partners;
  // One side of each edge, by the order of the vertices.
  std::vector<TriangleSide> open;    // of a single triangle
  std::vector<TriangleSide> forked;  // of three or more that bound no wedges
  std::vector<TriangleSide> turned;  // of two that run along it the same way: one of them faces the wrong way
};

MeshEdges find_edges(const MeshData& mesh);

Eigen::Vector3d middle(const MeshData& mesh, const TriangleSide& side);

// The part that each triangle belongs to, 0, 1, ... by the order of their first triangles: what is joined at edges.
std::vector<std::int32_t> part_numbers(const MeshEdges& edges);

// Gives parts that share a vertex, and fans of triangles that have only a vertex in common, vertices of their own.
void split_vertices(MeshData& mesh, const MeshEdges& edges);

}  // namespace netpocket
