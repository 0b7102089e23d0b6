// Compiled once per instruction set; NETPOCKET_ISA_NAME is the variant's namespace. The formulas are those of shape.cpp
// and segment_contact.cpp, in the same order.

#include "engine/contact/segment_kernel.h"

#include <cstdint>
#include <limits>

#include "engine/contact/search_limits.h"
#include "engine/math/simd.h"

namespace netpocket::segment_kernel::NETPOCKET_ISA_NAME {
namespace {

using namespace simd;
using namespace search_limits;

using Mask = decltype(SimdDouble{} < SimdDouble{});

NETPOCKET_INLINE SimdDouble absolute(const SimdDouble& value) {
  return SimdDouble(Mask(value) & (Mask{} + std::numeric_limits<std::int64_t>::max()));
}
// 1 with the sign of the value, also of zero.
NETPOCKET_INLINE SimdDouble sign(const SimdDouble& value) {
  return SimdDouble((Mask(value) & (Mask{} + std::numeric_limits<std::int64_t>::min())) | Mask(broadcast(1)));
}
// As std::min and std::clamp.
NETPOCKET_INLINE SimdDouble smaller(const SimdDouble& a, const SimdDouble& b) { return b < a ? b : a; }
NETPOCKET_INLINE SimdDouble clamp(const SimdDouble& value, const SimdDouble& low, const SimdDouble& high) {
  return value < low ? low : (high < value ? high : value);
}
NETPOCKET_INLINE bool is_any(const Mask& mask) { return is_any_positive(mask ? broadcast(1) : broadcast(0)); }
NETPOCKET_INLINE SimdVector select(const Mask& mask, const SimdVector& a, const SimdVector& b) {
  return {mask ? a.x : b.x, mask ? a.y : b.y, mask ? a.z : b.z};
}
NETPOCKET_INLINE SimdVector load3(const double (*rows)[kBlock], int part) {
  return {load(rows[0], part), load(rows[1], part), load(rows[2], part)};
}
NETPOCKET_INLINE void store3(double (*rows)[kBlock], int part, const SimdVector& value) {
  store(rows[0], part, value.x);
  store(rows[1], part, value.y);
  store(rows[2], part, value.z);
}
NETPOCKET_INLINE SimdVector broadcast3(const double* vector) {
  return {broadcast(vector[0]), broadcast(vector[1]), broadcast(vector[2])};
}

struct Surface {
  SimdDouble distance;
  SimdVector normal;
};

NETPOCKET_INLINE Surface nearest_on_box(const Solid& solid, const SimdVector& point) {
  const SimdDouble zero = broadcast(0), one = broadcast(1);
  const SimdVector half = broadcast3(solid.half);
  const SimdVector excess = {absolute(point.x) - half.x, absolute(point.y) - half.y, absolute(point.z) - half.z};
  const SimdVector outside = {larger(excess.x, zero), larger(excess.y, zero), larger(excess.z, zero)};
  const SimdDouble square = dot(outside, outside), distance = square_root(square);
  const SimdVector signs = {sign(point.x), sign(point.y), sign(point.z)};
  const SimdVector normal = {outside.x / distance * signs.x, outside.y / distance * signs.y,
                             outside.z / distance * signs.z};
  const Mask is_inside = square < broadcast(kSmallestSquare);
  if (!is_any(is_inside)) return {distance, normal};
  const Mask along_y = excess.y >= larger(excess.x, excess.z);
  const Mask along_x = (excess.x == excess.z ? point.x * point.z > zero : excess.x > excess.z) & ~along_y;
  const SimdDouble depth = along_y ? excess.y : (along_x ? excess.x : excess.z);
  const SimdDouble side = along_y ? signs.y : (along_x ? signs.x : signs.z);
  const SimdVector of_face = {side * (along_x ? one : zero), side * (along_y ? one : zero),
                              side * (along_x | along_y ? zero : one)};
  return {is_inside ? depth : distance, select(is_inside, of_face, normal)};
}

NETPOCKET_INLINE Surface nearest_on_cylinder(const Solid& solid, const SimdVector& point) {
  const SimdDouble zero = broadcast(0), one = broadcast(1);
  const SimdDouble radial_square = point.x * point.x + point.z * point.z, radius = square_root(radial_square);
  const Mask is_on_axis = radial_square < broadcast(kSmallestSquare);
  const SimdDouble radial_x = is_on_axis ? one : point.x / radius, radial_z = is_on_axis ? zero : point.z / radius;
  const SimdDouble axial = sign(point.y);
  const SimdDouble flank = radius - broadcast(solid.radius), end = absolute(point.y) - broadcast(solid.half_length);
  const SimdDouble outside_flank = larger(flank, zero), outside_end = larger(end, zero);
  const SimdDouble square = outside_flank * outside_flank + outside_end * outside_end, distance = square_root(square);
  const SimdDouble of_flank = outside_flank / distance, of_end = outside_end / distance;
  const SimdDouble no_side = axial * zero;  // with the sign that zeros of shape.cpp have
  const SimdVector normal = {of_flank * radial_x + of_end * no_side, of_flank * zero + of_end * axial,
                             of_flank * radial_z + of_end * no_side};
  const Mask is_inside = square < broadcast(kSmallestSquare);
  if (!is_any(is_inside)) return {distance, normal};
  const Mask is_end = end >= flank;
  const SimdVector of_surface = {is_end ? no_side : radial_x, is_end ? axial : zero, is_end ? no_side : radial_z};
  return {is_inside ? (is_end ? end : flank) : distance, select(is_inside, of_surface, normal)};
}

NETPOCKET_INLINE Surface nearest_on(const Solid& solid, const SimdVector& point) {
  const SimdVector local = point - broadcast3(solid.centre);
  const Surface inner = solid.kind == Kind::box ? nearest_on_box(solid, local) : nearest_on_cylinder(solid, local);
  return {inner.distance - broadcast(solid.rounding), inner.normal};
}

struct Trial {
  SimdDouble t, distance, slope;
  SimdVector normal;
};
NETPOCKET_INLINE Trial select(const Mask& mask, const Trial& a, const Trial& b) {
  return {mask ? a.t : b.t, mask ? a.distance : b.distance, mask ? a.slope : b.slope, select(mask, a.normal, b.normal)};
}
NETPOCKET_INLINE Trial load_trial(const TrialRows& rows, int part) {
  return {load(rows.t, part), load(rows.distance, part), load(rows.slope, part), load3(rows.normal, part)};
}
NETPOCKET_INLINE void store_trial(TrialRows& rows, int part, const Trial& trial) {
  store(rows.t, part, trial.t);
  store(rows.distance, part, trial.distance);
  store(rows.slope, part, trial.slope);
  store3(rows.normal, part, trial.normal);
}

struct Piece {
  SimdVector start, along;
};
NETPOCKET_INLINE Piece load_piece(const PieceRows& rows, int part) {
  return {load3(rows.start, part), load3(rows.along, part)};
}
NETPOCKET_INLINE Trial try_at(const Solid& solid, const Piece& piece, const SimdDouble& t) {
  const Surface found = nearest_on(solid, piece.start + t * piece.along);
  return {t, found.distance, dot(found.normal, piece.along), found.normal};
}

}  // namespace

void points(const Solid& solid, Points& points) {
  for (int part = 0; part < kParts; ++part) {
    const Surface found = nearest_on(solid, load3(points.point, part));
    store(points.distance, part, found.distance);
    store3(points.normal, part, found.normal);
  }
}

void between(const Solid& solid, Between& search) {
  for (int part = 0; part < kParts; ++part) {
    const Piece piece = load_piece(search.piece, part);
    const SimdDouble reach = load(search.reach, part);
    Trial low = load_trial(search.low, part), high = load_trial(search.high, part);
    SimdDouble result = {};
    Mask is_active = ~Mask{}, is_far = {};
    for (int i = 0; i < kMostTrials; ++i) {
      const SimdDouble crossing =
          ((high.distance - low.distance) + (low.slope * low.t - high.slope * high.t)) / (low.slope - high.slope);
      const SimdDouble bound = low.distance + low.slope * (crossing - low.t);
      const Mask ends_far = is_active & (bound > reach);
      result = ends_far ? bound : result;
      is_far |= ends_far;
      is_active &= ~ends_far & ~(smaller(low.distance, high.distance) - bound < broadcast(kTolerance));
      if (!is_any(is_active)) break;
      const SimdDouble secant = low.t - low.slope * (high.t - low.t) / (high.slope - low.slope);
      SimdDouble t = i % 2 == 0 ? crossing : secant;
      t = (t > low.t) & (t < high.t) ? t : broadcast(0.5) * (low.t + high.t);
      const Trial next = try_at(solid, piece, t);
      const Mask falls = next.slope < broadcast(0), is_flat = next.slope == broadcast(0);
      low = select(is_active & (falls | is_flat), next, low);
      high = select(is_active & ~falls, next, high);
      is_active &= ~is_flat;
    }
    store_trial(search.low, part, low);
    store_trial(search.high, part, high);
    store(search.bound, part, result);
    store(search.is_far, part, is_far ? broadcast(1) : broadcast(0));
  }
}

namespace {

// The members of Deepest in one part of the lanes, and what follows from them.
struct Depths {
  SimdDouble radius, from, depth, slope;  // at the nearest place; the slope is that of the depth, 0 inside the piece
  SimdDouble weight_at_start, rise, here, end;
  Mask rises;
};

NETPOCKET_INLINE Depths depths_of(const Deepest& search, int part) {
  Depths d;
  d.radius = load(search.radius, part);
  d.from = load(search.nearest, part);
  d.depth = d.radius - load(search.nearest_distance, part);
  const Mask is_inside = (d.from > broadcast(0)) & (d.from < broadcast(1));
  d.slope = is_inside ? broadcast(0) : -load(search.slope, part);
  d.weight_at_start = load(search.weight_at_start, part);
  d.rise = load(search.weight_at_end, part) - d.weight_at_start;
  d.here = d.weight_at_start + d.from * d.rise;
  d.rises = d.rise > broadcast(0);
  d.end = d.rises ? broadcast(1) : broadcast(0);
  return d;
}

// As deepest_of_parabola.
NETPOCKET_INLINE SimdDouble deepest_of_parabola(const Depths& d, const SimdDouble& known, const SimdDouble& depth) {
  const SimdDouble zero = broadcast(0), way = known - d.from;
  const SimdDouble bend = smaller((depth - d.depth - d.slope * way) / (way * way), zero);
  const SimdDouble square = broadcast(6) * d.rise * bend;
  const SimdDouble linear = broadcast(3.5) * d.rise * d.slope + broadcast(5) * d.here * bend;
  const SimdDouble constant = d.rise * d.depth + broadcast(2.5) * d.here * d.slope;
  const SimdDouble root = square_root(larger(linear * linear - broadcast(4) * square * constant, zero));
  const SimdDouble largest = broadcast(2) * constant / (root - linear);
  const SimdDouble end = d.end - d.from;
  const SimdDouble x = largest != largest ? zero : clamp(largest, smaller(end, zero), larger(end, zero));
  return way == zero ? d.from : clamp(d.from + x, zero, broadcast(1));
}

// As DeepestSearch::slope_at.
NETPOCKET_INLINE SimdDouble slope_at(const Depths& d, const Trial& trial) {
  const SimdDouble weight = d.weight_at_start + trial.t * d.rise;
  const SimdDouble slope = d.rise * (d.radius - trial.distance) - broadcast(2.5) * weight * trial.slope;
  return d.rises ? slope : -slope;
}

struct Bound {
  SimdDouble t, slope;
};

// As DeepestSearch::guess.
NETPOCKET_INLINE SimdDouble guess(const Depths& d, const Bound& low, const Bound& high, const SimdDouble& depth,
                                  int number) {
  SimdDouble t = low.t + (high.t - low.t) * low.slope / (low.slope - high.slope);
  if (number % 2 == 1) t = low.t == d.from ? deepest_of_parabola(d, high.t, depth) : t;
  const SimdDouble margin = broadcast(kInside) * (high.t - low.t);
  const SimdDouble after_low = low.t + margin, before_high = high.t - margin;
  return clamp(t, smaller(after_low, before_high), larger(after_low, before_high));
}

class DistanceAlong {
 public:
  DistanceAlong(const Solid& solid, const Piece& piece) : solid_(solid), piece_(piece) {}
  [[gnu::always_inline]] Trial at(const SimdDouble& t) const { return try_at(solid_, piece_, t); }
  [[gnu::always_inline]] Trial with_normal(const Trial& trial) const { return trial; }

 private:
  const Solid& solid_;
  const Piece& piece_;
};

// As DistanceFromSphere of segment_contact.cpp.
class DistanceFromSphere {
 public:
  [[gnu::always_inline]] DistanceFromSphere(const Solid& solid, const Piece& piece)
      : start_(piece.start - broadcast3(solid.centre)), along_(piece.along), radius_(broadcast(solid.radius)) {
    const SimdDouble zero = broadcast(0);
    square_ = dot(along_, along_);
    foot_ = square_ > zero ? -dot(start_, along_) / square_ : zero;
    const SimdVector nearest = start_ + foot_ * along_;
    apart_ = dot(nearest, nearest);
  }
  [[gnu::always_inline]] Trial at(const SimdDouble& t) const {
    const SimdDouble zero = broadcast(0), way = t - foot_, from_centre = square_root(apart_ + way * way * square_);
    return {t, from_centre - radius_, from_centre > zero ? way * square_ / from_centre : zero, SimdVector{}};
  }
  [[gnu::always_inline]] Trial with_normal(const Trial& trial) const {
    const SimdDouble zero = broadcast(0), from_centre = trial.distance + radius_;
    const SimdVector arm = start_ + trial.t * along_;
    const SimdVector outward = {arm.x / from_centre, arm.y / from_centre, arm.z / from_centre};
    return {trial.t, trial.distance, trial.slope,
            select(from_centre > zero, outward, SimdVector{zero, broadcast(1), zero})};
  }

 private:
  SimdVector start_, along_;
  SimdDouble radius_, square_, foot_, apart_;
};

template <typename Distance>
NETPOCKET_INLINE void deepest_of_part(const Distance& distance, Deepest& search, int part) {
  const SimdDouble unknown = broadcast(-std::numeric_limits<double>::infinity());
  const Depths d = depths_of(search, part);
  const SimdDouble length = load(search.length, part), steepest = absolute(d.rise) * d.depth;
  Bound low{d.from, steepest}, high{d.end, unknown};
  Trial found{};
  Mask is_active = d.from != d.end, is_found = {};
  SimdDouble t = deepest_of_parabola(d, d.end, d.radius - load(search.end_distance, part));
  for (int i = 0; i < kMostDeepTrials; ++i) {
    is_active &= absolute(high.t - low.t) * length > broadcast(kClose);
    if (!is_any(is_active)) break;
    const Trial trial = distance.at(t);
    const SimdDouble slope = slope_at(d, trial);
    const Mask is_flat = absolute(slope) <= broadcast(kFlat) * steepest;
    const Mask ends = is_active & (is_flat | ((t == d.end) & (slope >= broadcast(0))));
    found = select(ends, trial, found);
    is_found |= ends;
    is_active &= ~ends;
    const Mask grows = slope > broadcast(0);
    low = {is_active & grows ? t : low.t, is_active & grows ? slope : low.slope};
    high = {is_active & ~grows ? t : high.t, is_active & ~grows ? slope : high.slope};
    t = high.slope == unknown ? d.end : guess(d, low, high, d.radius - trial.distance, i);
  }
  const Mask is_nearest = ~is_found & (low.t == d.from);
  if (is_any(~is_found & ~is_nearest)) found = select(is_found, found, distance.at(low.t));
  store_trial(search.found, part, distance.with_normal(found));
  store(search.is_nearest, part, is_nearest ? broadcast(1) : broadcast(0));
}

}  // namespace

void deepest(const Solid& solid, Deepest& search) {
  for (int part = 0; part < kParts; ++part) {
    const Piece piece = load_piece(search.piece, part);
    if (solid.kind == Kind::sphere) {
      deepest_of_part(DistanceFromSphere(solid, piece), search, part);
    } else {
      deepest_of_part(DistanceAlong(solid, piece), search, part);
    }
  }
}

}  // namespace netpocket::segment_kernel::NETPOCKET_ISA_NAME
