#pragma once
// Where a straight piece of a cord's axis meets a solid, from one end (t = 0) to the other (t = 1). Body axes, m.
//
// The signed distance of a convex solid is a convex function along a straight line, and its slope is the outward normal
// times the line's direction. So two tangents bound it from below (Kelley 1960, doi:10.1137/0108053): the search ends
// with the nearest place, or with a bound that proves that there is no contact. A mesh is asked for the triangle that
// is nearest to the whole piece. Nothing that lies between two places can be missed.
//
// Pure functions; answers do not depend on what was asked before.

#include <Eigen/Core>
#include <array>

#include "engine/bodies/segment_distance.h"
#include "engine/contact/contact_part.h"

namespace netpocket {

struct SegmentPlace {
  double t = 0;         // in [0, 1]
  double distance = 0;  // m, signed, of the axis from the surface
  // The gradient of the distance: outward, of unit length but where two faces are equally near to an axis inside the
  // solid. There it is that mean of both which is across the piece, as the gradient of the nearest distance is.
  Eigen::Vector3d normal = Eigen::Vector3d::UnitY();
};

// A piece and what is known of it.
struct SegmentContact {
  // The signed distance at the nearest place (m), or a lower bound of it where that is more than `reach`.
  double distance = 0;
  bool is_near = false;  // whether the following is known
  SegmentPlace nearest;
  std::array<double, 2> at_ends = {};  // m, signed distances
  std::array<double, 2> slopes = {};   // of the distance before and behind the nearest place, m per unit of t
};

// The nearest place of a piece to a part, if it is nearer than `reach` (m). `ends`: the surface nearest to its ends.
SegmentContact nearest_on_segment(const ContactPart& part, const Segment& segment,
                                  const std::array<const SurfacePoint*, 2>& ends, double reach);

// A weight that goes linearly from one end of a piece to the other.
struct PieceWeight {
  double at_start, at_end;
  double at(double t) const { return at_start + t * (at_end - at_start); }
};

// The place in a piece where weight * depth^2.5 is largest, depth = radius - distance.
struct WeightedPlace {
  double t = 0;
  double weight = 0;
  double depth = 0;         // m
  bool is_nearest = false;  // whether that is the nearest place itself

  // Grows with weight * depth^2.5.
  double score() const { return weight * weight * ((depth * depth) * (depth * depth) * depth); }
};

// An estimate of it: from the nearest place, where the depth must be positive, the depth is followed as a parabola to
// the end with the larger weight. Nearly exact for a sphere much larger than the piece.
WeightedPlace estimate_deepest(const SegmentContact& contact, double radius, const PieceWeight& weight);

// That place, and the surface there: the parabola goes through ever nearer places until the depth is what it says.
// For an edge, where the depth is positive in a few millimetres, it is the nearest place but for some micrometres. Off
// the best place by x, the value is off by x^2.
SegmentPlace find_deepest(const ContactPart& part, const Segment& segment, const SegmentContact& contact, double radius,
                          const PieceWeight& weight);

// The surface at a place of a piece.
SegmentPlace place_on_segment(const ContactPart& part, const Segment& segment, double t);

}  // namespace netpocket
