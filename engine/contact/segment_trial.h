#pragma once
// Places that the searches of segment_contact.h try, and what a search comes to. Internal to segment_contact and
// segment_batch.

#include <Eigen/Core>
#include <array>

#include "engine/contact/segment_contact.h"
#include "engine/math/symmetric_algebra.h"

namespace netpocket {

inline Eigen::Vector3d point_at(const Segment& segment, double t) {
  return segment.start + t * (segment.end - segment.start);
}

struct Trial {
  double t, distance, slope;  // slope of the distance, m per unit of t
  Eigen::Vector3d normal;
};

inline Trial trial_of(const SurfacePoint& found, const Segment& segment, double t) {
  return {t, found.distance, symmetric_dot(found.normal, segment.end - segment.start), found.normal};
}

inline SegmentPlace place_of(const Trial& trial) { return {trial.t, trial.distance, trial.normal}; }

// The nearest place is an end.
inline SegmentContact at_end(const Trial& start, const Trial& end, bool is_start, double reach) {
  const Trial& nearest = is_start ? start : end;
  return {.distance = nearest.distance,
          .is_near = nearest.distance <= reach,
          .nearest = place_of(nearest),
          .at_ends = {start.distance, end.distance},
          .slopes = {nearest.slope, nearest.slope}};
}

// What a search comes to that has enclosed the nearest place.
inline SegmentContact enclosed_between(const Trial& low, const Trial& high, const std::array<double, 2>& at_ends,
                                       double reach) {
  SegmentContact result;
  result.at_ends = at_ends;
  result.nearest = place_of(low.distance < high.distance ? low : high);
  if (low.slope < 0 && high.slope > 0) {
    const double part = low.slope / (low.slope - high.slope);
    result.nearest.normal = (1 - part) * low.normal + part * high.normal;
  }
  result.slopes = {low.slope, high.slope};
  result.distance = result.nearest.distance;
  result.is_near = result.distance <= reach;
  return result;
}

}  // namespace netpocket
