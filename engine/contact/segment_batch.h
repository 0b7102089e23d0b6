#pragma once
// The searches of segment_contact.h for many points and pieces of cords and one solid. On boxes, cylinders and
// spheres eight of them are computed at once, where they need a search. Results are those of single searches to the
// last bit.
//
// Any thread may call these functions.

#include <span>

#include "engine/contact/segment_contact.h"

namespace netpocket {

struct PointTask {
  const Eigen::Vector3d* point;  // m, body axes
  SurfacePoint* nearest;         // result
};
void find_nearest_points(const ContactPart& part, std::span<const PointTask> tasks);

// See nearest_on_segment.
struct NearestTask {
  Segment segment;
  std::array<const SurfacePoint*, 2> ends;
  double reach;            // m
  SegmentContact* result;  // not null
};
void find_nearest(const ContactPart& part, std::span<const NearestTask> tasks);

// See find_deepest.
struct DeepestTask {
  Segment segment;
  const SegmentContact* contact;  // is near
  double radius;                  // m
  PieceWeight weight;
  SegmentPlace* result;  // not null
};
void find_deepest(const ContactPart& part, std::span<const DeepestTask> tasks);

}  // namespace netpocket
