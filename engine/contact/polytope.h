#pragma once
// Convex solids as polytopes, and the contact points of two that overlap. A box is represented exactly, a cylinder by
// an inscribed prism.
//
// Overlap is tested by separating axes (Gottschalk, Lin & Manocha 1996, OBBTree, SIGGRAPH; Ericson 2005, Real-Time
// Collision Detection, 5.2.1): the normals of both solids' faces and the cross products of their edges. If no axis
// separates the solids, the axis of least overlap d is the contact normal.
// - Normal of a face: the opposite face of the other solid is clipped to that face, and each remaining corner below it
//   is a contact point. So parallel faces touch at their corners.
// - Product of edges: the two edges touch where they are nearest to each other.
// If the overlaps of several axes are nearly equal, a face's normal is taken, and its plane is shifted so that d is the
// greatest depth. So nearly parallel faces touch as faces, and a new contact begins at depth 0.
//
// Both solids are symmetric about their centres, so only one sign of every axis needs a test. If the solids are rotated
// by a quarter turn about y, the results are rotated with them to the last bit (symmetric_algebra.h). Lengths in m.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "engine/bodies/primitives.h"
#include "engine/contact/touch.h"

namespace netpocket {

class Polytope {
 public:
  struct Face {
    Eigen::Vector3d normal;             // unit, outward
    double offset;                      // m, distance of its plane from the centre
    std::vector<std::int32_t> corners;  // counter-clockwise seen from outside
    bool curved;                        // whether it represents a part of a curved surface
  };
  // Parallel edges.
  struct EdgeClass {
    Eigen::Vector3d direction;  // unit
    std::vector<std::array<std::int32_t, 2>> edges;
  };

  Polytope(const Box& box, const Eigen::Vector3d& centre);
  Polytope(const Cylinder& cylinder, const Eigen::Vector3d& centre);

  const std::vector<Eigen::Vector3d>& vertices() const { return vertices_; }
  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<EdgeClass>& edge_classes() const { return edge_classes_; }
  const Eigen::Vector3d& centre() const { return centre_; }  // centre of symmetry
  // Half the width (m) of the solid along this unit normal.
  double half_width(const Eigen::Vector3d& normal) const;
  double radius() const { return radius_; }  // m, of the smallest sphere about the centre
  // Share of the contact stiffness of one corner. It is 1 for a box and 8/n for a prism with n corners, so that the end
  // of a prism is no stiffer than a face of a box.
  double weight() const { return weight_; }

 private:
  void add_face(const std::vector<std::int32_t>& corners, bool curved);
  void add_edge(std::int32_t begin, std::int32_t end);

  std::vector<Eigen::Vector3d> vertices_;
  std::vector<Eigen::Vector3d> half_vertices_;  // one of each opposite pair, relative to the centre
  std::vector<Face> faces_;
  std::vector<EdgeClass> edge_classes_;
  Eigen::Vector3d centre_;
  double radius_ = 0;
  double weight_ = 1;
};

// Appends the contact points of `first` and `second`, in the axes of `second`. Returns a lower bound of their distance
// (m); if they overlap, minus the least overlap. `place`: the axes of `first` in those of `second`.
double find_touches(const Polytope& first, const Placement& place, const Polytope& second, std::vector<Touch>& touches);

}  // namespace netpocket
