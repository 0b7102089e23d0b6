#pragma once
// What is wrong with a mesh as the surface of a body: of its numbers, its edges, and each of its parts. A part is what
// is joined at edges. Parts may touch; each must enclose a volume, and either lie outside the others and face outwards,
// or lie in the solid of another one and face inwards: a hollow. Any thread may call these functions.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "engine/bodies/mesh_data.h"
#include "engine/bodies/mesh_edges.h"

namespace netpocket {

enum class MeshFaultKind {
  numbers,    // not finite, or a corner that does not exist: nothing else was looked at
  empty,      // no triangles
  too_many,   // triangles
  extent,     // too large or too small
  doubled,    // triangles that are there twice
  open,       // edges of one triangle, or of several that do not fit
  turned,     // neighbours that face opposite ways
  flat,       // parts that enclose no volume
  two_sided,  // parts whose triangles are all there twice, facing either way
  inward,     // parts that face inwards and are no hollows
  crossing,   // parts that go through each other
  nested,     // parts in the solid of another one that are no hollows
};

struct MeshFault {
  MeshFaultKind kind;
  std::string text;                          // the rest of a sentence that begins with the mesh's name
  std::vector<Eigen::Vector3d> places = {};  // m; the first of them, at most kMostFaultPlaces
};

// Of the extent: how far parts may reach into each other and still touch.
inline constexpr double kTouchingTolerance = 1e-7;
inline constexpr std::size_t kMostFaultPlaces = 1000;

struct MeshPart {
  std::size_t triangles = 0;
  Eigen::AlignedBox3d bounds;                       // m
  double area = 0;                                  // m^2
  double volume = 0;                                // m^3; negative where the triangles face inwards
  bool closed = false;                              // each of its edges joins two triangles that face the same way
  bool flat = false;                                // encloses no volume
  bool two_sided = false;                           // each of its triangles lies on one that faces the other way
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  // on it, m
};

struct MeshReview {
  MeshData mesh;              // welded; parts that touch have vertices of their own
  double weld_tolerance = 0;  // m
  std::size_t joined = 0;     // corners that differed from the one they were joined with
  MeshEdges edges;
  std::vector<std::int32_t> part_of;  // by triangle
  std::vector<std::int32_t>
      back_of;  // by triangle: the one that has the same corners and faces the other way; -1: none
  std::vector<MeshPart> parts;
  std::vector<MeshFault> faults;  // the worst first; empty: the surface of a body
};

// Welds within kWeldTolerance of the extent.
MeshReview review_mesh(const MeshData& data);

// The fault in the numbers alone, which makes a mesh impossible to work with; empty: none.
std::string number_fault(const MeshData& data);

// Whether a part is the surface of something.
inline bool is_solid(const MeshPart& part) { return part.closed && !part.flat && !part.two_sided; }

std::string place_text(const Eigen::Vector3d& place);  // "(1, 2, 3) m"

}  // namespace netpocket
