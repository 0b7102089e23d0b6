#pragma once
// Finds the faults of a mesh as the surface of a body: in its numbers, its edges and its parts. A part is a set of
// triangles joined at edges. Parts may touch. Each must enclose a volume. Each must either lie outside the others and
// face outwards, or lie in the solid of another part and face inwards (a hollow). Any thread may call these functions.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "engine/bodies/mesh_data.h"
#include "engine/bodies/mesh_edges.h"

namespace netpocket {

enum class MeshFaultKind {
  numbers,    // a coordinate is not finite, or a corner does not exist; nothing else was checked
  empty,      // no triangles
  too_many,   // too many triangles
  extent,     // too large or too small
  doubled,    // duplicate triangles
  open,       // edges of one triangle, or of several that do not fit
  turned,     // neighbours that face opposite ways
  flat,       // parts that enclose no volume
  two_sided,  // parts in which each triangle exists twice, with opposite orientations
  inward,     // parts that face inwards and are no hollows
  crossing,   // parts that go through each other
  nested,     // parts that face outwards in the solid of another part
};

struct MeshFault {
  MeshFaultKind kind;
  std::string text;                          // the rest of a sentence that begins with the mesh's name
  std::vector<Eigen::Vector3d> places = {};  // m, at most the first kMostFaultPlaces
};

// Parts that overlap by at most this fraction of the extent count as touching.
inline constexpr double kTouchingTolerance = 1e-7;
inline constexpr std::size_t kMostFaultPlaces = 1000;

struct MeshPart {
  std::size_t triangles = 0;
  Eigen::AlignedBox3d bounds;                       // m
  double area = 0;                                  // m^2
  double volume = 0;                                // m^3, negative if the triangles face inwards
  bool closed = false;                              // each of its edges joins two triangles that face the same way
  bool flat = false;                                // encloses no volume
  bool two_sided = false;                           // each triangle has a twin with opposite orientation
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  // m, a point on it
};

struct MeshReview {
  MeshData mesh;              // welded; parts that touch have vertices of their own
  double weld_tolerance = 0;  // m
  std::size_t joined = 0;     // number of corners that differed from the one they were joined with
  MeshEdges edges;
  std::vector<std::int32_t> part_of;  // by triangle
  std::vector<std::int32_t>
      back_of;  // by triangle: the one with the same corners and the opposite orientation; -1: none
  std::vector<MeshPart> parts;
  std::vector<MeshFault> faults;  // by MeshFaultKind, the worst first; empty: the mesh is the surface of a body
};

// Welds corners within kWeldTolerance times the extent and checks the result. Coordinates in m.
MeshReview review_mesh(const MeshData& data);

// The fault in the numbers (MeshFaultKind::numbers), as in MeshFault::text; empty: none. No other function accepts a
// mesh with such a fault.
std::string number_fault(const MeshData& data);

// Whether a part is the surface of a solid.
inline bool is_solid(const MeshPart& part) { return part.closed && !part.flat && !part.two_sided; }

std::string place_text(const Eigen::Vector3d& place);  // "(1, 2, 3) m"

}  // namespace netpocket
