#pragma once
// Convex solids as polytopes, and where two of them overlap: boxes exactly, cylinders as prisms inscribed in them.
//
// Overlap by separating axes (Gottschalk, Lin & Manocha 1996, OBBTree, SIGGRAPH; Ericson 2005, Real-Time Collision
// Detection, 5.2.1): the normals of both solids' faces and the products of their edges. Where no axis separates them,
// the one of least overlap d is the normal of contact. Along a face's normal the opposite face of the other solid is
// clipped to that face, and each corner that is left below it touches: so level faces are held at their corners. Along
// a product of edges the two edges touch where they are nearest to each other. Among axes whose overlaps are nearly
// equal a face's is taken, its plane shifted so that d is the greatest depth: faces that are all but level touch as
// faces, and what touches for the first time does so at depth 0.
//
// Both solids are symmetric about their centres, which gives every axis one sign. Results turn with the solids in
// quarter turns about y to the last bit (symmetric_algebra.h). Lengths in m.

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
    double offset;                      // m, of its plane from the centre
    std::vector<std::int32_t> corners;  // counter-clockwise seen from outside
    bool curved;                        // stands for a part of a curved surface
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
  const Eigen::Vector3d& centre() const { return centre_; }  // of symmetry
  // Half the width across planes with this unit normal, m.
  double half_width(const Eigen::Vector3d& normal) const;
  double radius() const { return radius_; }  // of the smallest sphere about the centre, m
  // Share of the contact stiffness that one corner has: 1 of a box, 8/n of the n corners of a prism, so that its end
  // is no stiffer than a box's face.
  double weight() const { return weight_; }

 private:
  void add_face(const std::vector<std::int32_t>& corners, bool curved);
  void add_edge(std::int32_t begin, std::int32_t end);

  std::vector<Eigen::Vector3d> vertices_;
  std::vector<Eigen::Vector3d> half_vertices_;  // one of each two opposite ones, from the centre
  std::vector<Face> faces_;
  std::vector<EdgeClass> edge_classes_;
  Eigen::Vector3d centre_;
  double radius_ = 0;
  double weight_ = 1;
};

// Appends where `first` touches `second`, in the second's axes, and returns a lower bound of their distance (m), which
// is the least overlap, negative, where they touch. `place`: the first one's axes in the second's.
double find_touches(const Polytope& first, const Placement& place, const Polytope& second, std::vector<Touch>& touches);

}  // namespace netpocket
