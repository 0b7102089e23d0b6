#include "engine/contact/segment_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/bodies/triangle_mesh.h"
#include "engine/contact/search_limits.h"
#include "engine/contact/segment_trial.h"
#include "engine/math/symmetric_algebra.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;
using namespace search_limits;

using Ends = std::array<const SurfacePoint*, 2>;

Trial try_at(const ContactPart& part, const Segment& segment, double t) {
  return trial_of(part.nearest(point_at(segment, t)), segment, t);
}

// The nearest place of a segment to a convex solid whose distance falls at `low` and rises at `high`. It tries in turn
// the intersection of the tangents, which bounds the distance from below, and the zero of the secant of the slopes,
// which converges fast where the distance is smooth.
SegmentContact search_between(const ContactPart& part, const Segment& segment, double reach, Trial low, Trial high) {
  SegmentContact result;
  result.at_ends = {low.distance, high.distance};
  for (int i = 0; i < kMostTrials; ++i) {
    const double crossing =
        ((high.distance - low.distance) + (low.slope * low.t - high.slope * high.t)) / (low.slope - high.slope);
    const double bound = low.distance + low.slope * (crossing - low.t);
    if (bound > reach) {
      result.distance = bound;
      return result;
    }
    if (std::min(low.distance, high.distance) - bound < kTolerance) break;
    const double secant = low.t - low.slope * (high.t - low.t) / (high.slope - low.slope);
    double t = i % 2 == 0 ? crossing : secant;
    if (!(t > low.t && t < high.t)) t = 0.5 * (low.t + high.t);
    const Trial next = try_at(part, segment, t);
    (next.slope < 0 ? low : high) = next;
    if (next.slope == 0) {
      low = high;
      break;
    }
  }
  return enclosed_between(low, high, result.at_ends, reach);
}

SegmentContact nearest_to_convex(const ContactPart& part, const Segment& segment, const Ends& ends, double reach) {
  const Trial start = trial_of(*ends[0], segment, 0), end = trial_of(*ends[1], segment, 1);
  if (start.slope >= 0) return at_end(start, end, true, reach);
  if (end.slope <= 0) return at_end(start, end, false, reach);
  return search_between(part, segment, reach, start, end);
}

SegmentContact nearest_to_sphere(const ContactPart& part, double radius, const Segment& segment, const Ends& ends,
                                 double reach) {
  const Vector3d start = segment.start - part.centre, along = segment.end - segment.start;
  const double square = symmetric_squared_norm(along);
  const double t = square > 0 ? std::clamp(-symmetric_dot(start, along) / square, 0.0, 1.0) : 0.0;
  const Vector3d arm = start + t * along;
  const double from_centre = symmetric_norm(arm);
  SegmentContact result;
  result.distance = from_centre - radius;
  if (result.distance > reach) return result;
  result.is_near = true;
  result.nearest = {t, result.distance, from_centre > 0 ? Vector3d(arm / from_centre) : Vector3d::UnitY()};
  result.at_ends = {ends[0]->distance, ends[1]->distance};
  if (t <= 0 || t >= 1) result.slopes.fill(symmetric_dot(result.nearest.normal, along));
  return result;
}

// Outside the mesh, the triangle nearest to the piece gives the nearest place. If the axis has entered the mesh, the
// deepest of a few places is taken. The distances of the ends bound the search.
SegmentContact nearest_to_mesh(const ContactPart& part, const TriangleMesh& mesh, const Segment& segment,
                               const Ends& ends, double reach) {
  constexpr int kPieces = 8;
  const Segment local{segment.start - part.centre, segment.end - part.centre};
  const Trial start = trial_of(*ends[0], segment, 0), end = trial_of(*ends[1], segment, 1);
  const double of_ends = std::min(std::abs(start.distance), std::abs(end.distance));
  const SegmentHit hit = mesh.tree().nearest_to_segment(local, of_ends + kTolerance);
  SegmentContact result;
  if (start.distance > 0 && hit.distance > reach) {
    result.distance = std::min(hit.distance, start.distance);
    return result;
  }
  Trial nearest = start.distance < end.distance ? start : end;
  const auto consider = [&](double t) {
    const Trial trial = try_at(part, segment, t);
    if (trial.distance < nearest.distance) nearest = trial;
  };
  consider(hit.t);
  if (nearest.distance <= 0) {
    for (int i = 1; i < kPieces; ++i) consider(static_cast<double>(i) / kPieces);
  }
  result.distance = nearest.distance;
  result.is_near = nearest.distance <= reach;
  result.nearest = place_of(nearest);
  result.at_ends = {start.distance, end.distance};
  if (nearest.t <= 0 || nearest.t >= 1) result.slopes.fill(nearest.slope);
  return result;
}

}  // namespace

SegmentContact nearest_on_segment(const ContactPart& part, const Segment& segment, const Ends& ends, double reach) {
  if (const auto* sphere = std::get_if<Sphere>(&part.solid)) {
    return nearest_to_sphere(part, sphere->radius, segment, ends, reach);
  }
  if (const auto* mesh = std::get_if<MeshShape>(&part.solid)) {
    return nearest_to_mesh(part, *mesh->mesh, segment, ends, reach);
  }
  return nearest_to_convex(part, segment, ends, reach);
}

namespace {

// A place other than the nearest one, and the depth there.
struct DepthAt {
  double t, depth;
};

// Let x be measured from the nearest place, the depth be d = a + s x + c x^2 and the weight m + b x. Then
// weight * d^2.5 is largest where b d + 2.5 (m + b x) d' = 0. The parabola passes through `known`, which is on the side
// of the larger weight.
WeightedPlace deepest_of_parabola(const SegmentContact& contact, double radius, const PieceWeight& weight,
                                  const DepthAt& known) {
  const double from = contact.nearest.t, depth = radius - contact.nearest.distance;
  const double rise = weight.at_end - weight.at_start, here = weight.at(from);
  const bool is_inside = from > 0 && from < 1;
  const double slope = is_inside ? 0 : -contact.slopes[rise > 0 ? 1 : 0], way = known.t - from;
  if (way == 0) return {from, here, depth, true};
  const double bend = std::min((known.depth - depth - slope * way) / (way * way), 0.0);
  const double square = 6 * rise * bend, linear = 3.5 * rise * slope + 5 * here * bend;
  const double constant = rise * depth + 2.5 * here * slope;
  const double root = std::sqrt(std::max(linear * linear - 4 * square * constant, 0.0));
  const double largest = 2 * constant / (root - linear);  // infinite if the depth is constant
  const double end = (rise > 0 ? 1 : 0) - from;
  const double x = std::isnan(largest) ? 0 : std::clamp(largest, std::min(end, 0.0), std::max(end, 0.0));
  return {std::clamp(from + x, 0.0, 1.0), here + rise * x, depth + slope * x + bend * x * x, x == 0};
}

DepthAt at_heavier_end(const SegmentContact& contact, double radius, const PieceWeight& weight) {
  const bool is_end = weight.at_end > weight.at_start;
  return {is_end ? 1.0 : 0.0, radius - contact.at_ends[is_end ? 1 : 0]};
}

}  // namespace

WeightedPlace estimate_deepest(const SegmentContact& contact, double radius, const PieceWeight& weight) {
  return deepest_of_parabola(contact, radius, weight, at_heavier_end(contact, radius, weight));
}

namespace {

// Distance of the places of a piece from a part, with its slope along the piece.
class DistanceAlong {
 public:
  struct Found {
    double distance, slope;  // m, m per unit of t
    Vector3d normal;
  };
  DistanceAlong(const ContactPart& part, const Segment& segment) : part_(part), segment_(segment) {}

  Found at(double t) const {
    const SurfacePoint found = part_.nearest(point_at(segment_, t));
    return {found.distance, symmetric_dot(found.normal, segment_.end - segment_.start), found.normal};
  }
  SegmentPlace place(double t, const Found& found) const { return {t, found.distance, found.normal}; }

 private:
  const ContactPart& part_;
  const Segment& segment_;
};

// The same from a sphere, by Pythagoras about the foot of the perpendicular from its centre.
class DistanceFromSphere {
 public:
  struct Found {
    double distance, slope;
  };
  DistanceFromSphere(const ContactPart& part, double radius, const Segment& segment)
      : start_(segment.start - part.centre), along_(segment.end - segment.start), radius_(radius) {
    square_ = symmetric_squared_norm(along_);
    foot_ = square_ > 0 ? -symmetric_dot(start_, along_) / square_ : 0;
    apart_ = symmetric_squared_norm(Vector3d(start_ + foot_ * along_));
  }

  Found at(double t) const {
    const double way = t - foot_, from_centre = std::sqrt(apart_ + way * way * square_);
    return {from_centre - radius_, from_centre > 0 ? way * square_ / from_centre : 0};
  }
  SegmentPlace place(double t, const Found& found) const {
    const Vector3d arm = start_ + t * along_;
    const double from_centre = found.distance + radius_;
    return {t, found.distance, from_centre > 0 ? Vector3d(arm / from_centre) : Vector3d::UnitY()};
  }

 private:
  Vector3d start_, along_;
  double radius_, square_, foot_, apart_;
};

// Looks for the zero of the slope of weight * depth^2.5 between the nearest place and the end of the larger weight. The
// slope, over 2/5 of weight * depth^1.5, is weight' depth + 2.5 weight depth'. It falls all along where the solid is
// convex.
template <typename Distance>
class DeepestSearch {
 public:
  DeepestSearch(const Distance& distance, const SegmentContact& contact, double length, double radius,
                const PieceWeight& weight)
      : distance_(distance), contact_(contact), length_(length), radius_(radius), weight_(weight) {}

  SegmentPlace find() {
    const DepthAt end = at_heavier_end(contact_, radius_, weight_);
    const double from = contact_.nearest.t;
    if (from == end.t) return contact_.nearest;
    const double steepest = std::abs(rise()) * (radius_ - contact_.nearest.distance);
    Bound low{from, steepest}, high{end.t, kUnknown};
    // The depth at the end is known, but not its slope. So the first place is the parabola's.
    double t = deepest_of_parabola(contact_, radius_, weight_, end).t;
    for (int i = 0; i < kMostDeepTrials && std::abs(high.t - low.t) * length_ > kClose; ++i) {
      const Found found = distance_.at(t);
      const double slope = slope_at(t, found);
      if (std::abs(slope) <= kFlat * steepest || (t == end.t && slope >= 0)) return distance_.place(t, found);
      (slope > 0 ? low : high) = {t, slope};
      t = high.slope == kUnknown ? end.t : guess(low, high, radius_ - found.distance, i);
    }
    return low.t == from ? contact_.nearest : distance_.place(low.t, distance_.at(low.t));
  }

 private:
  using Found = typename Distance::Found;
  static constexpr double kUnknown = -std::numeric_limits<double>::infinity();
  struct Bound {
    double t, slope;  // towards the end of the larger weight
  };
  double rise() const { return weight_.at_end - weight_.at_start; }

  double slope_at(double t, const Found& found) const {
    const double slope = rise() * (radius_ - found.distance) - 2.5 * weight_.at(t) * found.slope;
    return rise() > 0 ? slope : -slope;
  }

  // In turn the secant of the slopes, and the parabola through the nearest place and `high`, where the depth is
  // `depth`.
  double guess(const Bound& low, const Bound& high, double depth, int number) const {
    double t = low.t + (high.t - low.t) * low.slope / (low.slope - high.slope);
    if (number % 2 == 1 && low.t == contact_.nearest.t) {
      t = deepest_of_parabola(contact_, radius_, weight_, {high.t, depth}).t;
    }
    const double margin = kInside * (high.t - low.t);
    return std::clamp(t, std::min(low.t + margin, high.t - margin), std::max(low.t + margin, high.t - margin));
  }

  const Distance& distance_;
  const SegmentContact& contact_;
  double length_, radius_;
  PieceWeight weight_;
};

}  // namespace

SegmentPlace find_deepest(const ContactPart& part, const Segment& segment, const SegmentContact& contact, double radius,
                          const PieceWeight& weight) {
  const double length = symmetric_norm(segment.end - segment.start);
  if (const auto* sphere = std::get_if<Sphere>(&part.solid)) {
    return DeepestSearch(DistanceFromSphere(part, sphere->radius, segment), contact, length, radius, weight).find();
  }
  return DeepestSearch(DistanceAlong(part, segment), contact, length, radius, weight).find();
}

SegmentPlace place_on_segment(const ContactPart& part, const Segment& segment, double t) {
  const SurfacePoint found = part.nearest(point_at(segment, t));
  return {t, found.distance, found.normal};
}

}  // namespace netpocket
