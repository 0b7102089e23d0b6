#pragma once
// Closest points of two segments, for contact between capsules (cords approximated by straight pieces). Method: Ericson
// (2005), Real-Time Collision Detection, 5.1.9, but with the crossing found from the common normal. (Lumelsky 1985,
// doi:10.1016/0020-0190(85)90032-8, uses only dot products, which lose half the digits for nearly parallel segments.)

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>

#include "engine/math/symmetric_algebra.h"

namespace netpocket {

struct Segment {
  Eigen::Vector3d start;  // m
  Eigen::Vector3d end;    // m; may equal start
};

struct SegmentDistance {
  double distance;         // m, >= 0
  double first_fraction;   // of the way from start to end of the first segment, in [0, 1]
  double second_fraction;  // the same for the second
  Eigen::Vector3d first_point;
  Eigen::Vector3d second_point;
};

namespace detail {

// The f in [0, 1] for which origin + f direction is nearest to a point.
inline double nearest_fraction(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                               const Eigen::Vector3d& point) {
  const double square = symmetric_squared_norm(direction);
  return square > 0 ? std::clamp(symmetric_dot(direction, point - origin) / square, 0.0, 1.0) : 0.0;
}

// Fraction of the first segment nearest to the line of the second. For parallel segments, the middle of their overlap.
inline double crossing_fraction(const Segment& first, const Segment& second) {
  const Eigen::Vector3d u = first.end - first.start;
  const Eigen::Vector3d v = second.end - second.start;
  const Eigen::Vector3d normal = u.cross(v);
  const double square = symmetric_squared_norm(normal);
  const double parallel = 1e-28 * symmetric_squared_norm(u) * symmetric_squared_norm(v);  // angles below 1e-14 rad
  if (square > parallel) {
    const double fraction = symmetric_dot((second.start - first.start).cross(v), normal) / square;
    return std::clamp(fraction, 0.0, 1.0);
  }
  return 0.5 * (nearest_fraction(first.start, u, second.start) + nearest_fraction(first.start, u, second.end));
}

}  // namespace detail

// Segments may touch, cross, be parallel or be points. Coordinates must be finite. If several pairs of points are
// equally near, a fixed rule chooses one: for parallel segments the middle of their overlap.
inline SegmentDistance closest_points(const Segment& first, const Segment& second) {
  const Eigen::Vector3d u = first.end - first.start;
  const Eigen::Vector3d v = second.end - second.start;
  SegmentDistance result;
  // First the point of the second segment nearest to the crossing, then the point of the first nearest to that.
  result.first_fraction = detail::crossing_fraction(first, second);
  result.second_fraction = detail::nearest_fraction(second.start, v, first.start + result.first_fraction * u);
  result.second_point = second.start + result.second_fraction * v;
  result.first_fraction = detail::nearest_fraction(first.start, u, result.second_point);
  result.first_point = first.start + result.first_fraction * u;
  result.distance = symmetric_norm(result.second_point - result.first_point);
  return result;
}

}  // namespace netpocket
