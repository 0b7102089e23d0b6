#pragma once
// Finds the point of a straight piece of a cord's axis that is nearest to a solid. t is 0 at one end of the piece and 1
// at the other. Body axes, m.
//
// The signed distance of a convex solid is a convex function along a straight line. Its slope is the outward normal
// times the line's direction. So two tangents bound the distance from below (Kelley 1960, doi:10.1137/0108053). The
// search ends with the nearest place, or with a bound that proves that there is no contact. For a mesh, the triangle
// nearest to the whole piece is found. So no contact between the sampled places is missed.
//
// Pure functions: any thread may call them.

#include <Eigen/Core>
#include <array>

#include "engine/bodies/segment_distance.h"
#include "engine/contact/contact_part.h"

namespace netpocket {

struct SegmentPlace {
  double t = 0;         // in [0, 1]
  double distance = 0;  // m, signed, of the axis from the surface
  // Gradient of the distance, outward. It has unit length, except inside the solid where two faces are equally near.
  // There it is the weighted mean of both faces' normals that is perpendicular to the piece, because it is the gradient
  // of the nearest distance.
  Eigen::Vector3d normal = Eigen::Vector3d::UnitY();
};

// Result of the search on a piece.
struct SegmentContact {
  // Signed distance (m) at the nearest place, or a lower bound of it that exceeds `reach`.
  double distance = 0;
  bool is_near = false;  // whether distance <= reach; only then all of the following members are set
  SegmentPlace nearest;
  std::array<double, 2> at_ends = {};  // m, signed distances
  std::array<double, 2> slopes = {};   // of the distance before and after the nearest place, m per unit of t
};

// Finds the nearest place of a piece to a part if it is within `reach` (m). `ends`: nearest surface points (body axes)
// of the start and the end of the piece; not null.
SegmentContact nearest_on_segment(const ContactPart& part, const Segment& segment,
                                  const std::array<const SurfacePoint*, 2>& ends, double reach);

// A weight that varies linearly along a piece.
struct PieceWeight {
  double at_start, at_end;
  double at(double t) const { return at_start + t * (at_end - at_start); }
};

// The place of a piece where weight * depth^2.5 is largest, with depth = radius - distance.
struct WeightedPlace {
  double t = 0;
  double weight = 0;
  double depth = 0;         // m
  bool is_nearest = false;  // whether it is the nearest place itself

  // Square of weight * depth^2.5, for comparisons.
  double score() const { return weight * weight * ((depth * depth) * (depth * depth) * depth); }
};

// Estimates that place. It approximates the depth by a parabola from the nearest place, where the depth must be
// positive, to the end with the larger weight. Nearly exact for a sphere much larger than the piece. Requires
// contact.is_near.
WeightedPlace estimate_deepest(const SegmentContact& contact, double radius, const PieceWeight& weight);

// Finds that place and the surface there. It fits the parabola to nearer and nearer places until the depth agrees with
// it. At an edge, where the depth is positive over a few millimetres only, the result is the nearest place, to within
// some micrometres. An error x of the place causes an error of the order x^2 of the value. Requires contact.is_near.
SegmentPlace find_deepest(const ContactPart& part, const Segment& segment, const SegmentContact& contact, double radius,
                          const PieceWeight& weight);

// The surface at a place of a piece.
SegmentPlace place_on_segment(const ContactPart& part, const Segment& segment, double t);

}  // namespace netpocket
