#include "engine/bodies/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace netpocket {
namespace {

using Eigen::Vector3d;

constexpr std::int32_t kLeafSize = 4;
// Sufficient because each level halves the number of triangles of a node.
constexpr std::size_t kStackSize = 64;
// Factor that covers the rounding of squared distances to boxes and triangles.
constexpr double kRounding = 1 + 1e-12;
// The same for distances to planes, whose rounding grows with the distance of a segment from the triangle's corner.
constexpr double kSafeRounding = 1 + 1e-6;

float below(double value) { return std::nextafter(static_cast<float>(value), -HUGE_VALF); }
float above(double value) { return std::nextafter(static_cast<float>(value), HUGE_VALF); }

TriangleHit hit_at(const Vector3d& p, const Vector3d& nearest, TriangleFeature feature) {
  return {(p - nearest).squaredNorm(), -1, feature, nearest};
}

// Fraction of a segment at which it passes through a triangle; negative: nowhere. Also negative for a segment in the
// triangle's plane: it crosses an edge or has an end inside, which nearest_to_triangle finds.
double crossing_of(const Segment& segment, const TriangleTree::Corners& corners) {
  const Vector3d along = segment.end - segment.start;
  const Vector3d ab = corners[1] - corners[0], ac = corners[2] - corners[0];
  const Vector3d across = along.cross(ac);
  const double determinant = ab.dot(across);
  if (determinant == 0) return -1;
  const Vector3d from = segment.start - corners[0];
  const double u = from.dot(across) / determinant;
  const Vector3d third = from.cross(ab);
  const double v = along.dot(third) / determinant, t = ac.dot(third) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && t >= 0 && t <= 1 ? t : -1;
}

// Whether a segment is farther than `reach` (m) from a triangle: for certain if from its plane or its box. Costs a
// tenth of nearest_to_triangle.
bool is_surely_beyond(const Segment& segment, const Eigen::AlignedBox3d& box, const TriangleTree::Corners& corners,
                      double reach) {
  const Vector3d ab = corners[1] - corners[0], ac = corners[2] - corners[0];
  const Vector3d normal = ab.cross(ac);
  const double start = normal.dot(segment.start - corners[0]), end = normal.dot(segment.end - corners[0]);
  const double nearest = std::min(std::abs(start), std::abs(end));
  if (start * end > 0 && nearest * nearest > reach * reach * normal.squaredNorm() * kSafeRounding) return true;
  const Vector3d low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]) - box.max();
  const Vector3d high = box.min() - corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
  return low.cwiseMax(high).cwiseMax(0.0).squaredNorm() > reach * reach * kSafeRounding;
}

// Nearest place of a segment to a triangle: the crossing, or else the best of the segment's ends and the places nearest
// to the triangle's edges.
SegmentHit nearest_to_triangle(const Segment& segment, const TriangleTree::Corners& corners) {
  if (const double t = crossing_of(segment, corners); t >= 0) return {t, 0};
  SegmentHit best;
  const auto consider = [&](double t, double distance) {
    if (distance < best.distance) best = {t, distance};
  };
  for (const double t : {0.0, 1.0}) {
    const Vector3d& end = t == 0 ? segment.start : segment.end;
    consider(t, std::sqrt(nearest_on_triangle(end, corners[0], corners[1], corners[2]).squared_distance));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const SegmentDistance found = closest_points(segment, {corners[i], corners[(i + 1) % 3]});
    consider(found.first_fraction, found.distance);
  }
  return best;
}

}  // namespace

TriangleHit nearest_on_triangle(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return hit_at(p, a, TriangleFeature::corner0);
  const Vector3d bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return hit_at(p, b, TriangleFeature::corner1);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return hit_at(p, a + d1 / (d1 - d3) * ab, TriangleFeature::edge01);
  const Vector3d cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return hit_at(p, c, TriangleFeature::corner2);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return hit_at(p, a + d2 / (d2 - d6) * ac, TriangleFeature::edge20);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) {
    return hit_at(p, b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), TriangleFeature::edge12);
  }
  const double whole = va + vb + vc;
  return hit_at(p, a + vb / whole * ab + vc / whole * ac, TriangleFeature::face);
}

TriangleTree::TriangleTree(const std::vector<Corners>& triangles) {
  const auto count = static_cast<std::int32_t>(triangles.size());
  if (count == 0) return;
  std::vector<Vector3d> centres;
  centres.reserve(triangles.size());
  for (const Corners& t : triangles) centres.push_back((t[0] + t[1] + t[2]) / 3);
  indices_.resize(triangles.size());
  std::iota(indices_.begin(), indices_.end(), 0);
  nodes_.emplace_back();
  build(0, 0, count, triangles, centres);
  corners_.reserve(triangles.size());
  for (const std::int32_t index : indices_) corners_.push_back(triangles[index]);
}

// Divides the triangles in two halves along the longest edge of the box round their centres.
void TriangleTree::build(std::int32_t node, std::int32_t first, std::int32_t count,
                         const std::vector<Corners>& triangles, const std::vector<Vector3d>& centres) {
  Vector3d low = Vector3d::Constant(HUGE_VAL), high = -low;
  Vector3d centre_low = low, centre_high = high;
  for (std::int32_t place = first; place < first + count; ++place) {
    for (const Vector3d& corner : triangles[indices_[place]]) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
    centre_low = centre_low.cwiseMin(centres[indices_[place]]);
    centre_high = centre_high.cwiseMax(centres[indices_[place]]);
  }
  for (int axis = 0; axis < 3; ++axis) {
    nodes_[node].low[axis] = below(low[axis]);
    nodes_[node].high[axis] = above(high[axis]);
  }
  if (count <= kLeafSize) {
    nodes_[node].first = first;
    nodes_[node].count = count;
    return;
  }
  int axis = 0;
  (centre_high - centre_low).maxCoeff(&axis);
  const std::int32_t half = count / 2;
  const auto begin = indices_.begin() + first;
  std::nth_element(begin, begin + half, begin + count, [&](std::int32_t a, std::int32_t b) {
    return std::pair(centres[a][axis], a) < std::pair(centres[b][axis], b);
  });
  const auto children = static_cast<std::int32_t>(nodes_.size());
  nodes_[node].first = children;
  nodes_[node].count = 0;
  nodes_.resize(nodes_.size() + 2);
  build(children, first, half, triangles, centres);
  build(children + 1, first + half, count - half, triangles, centres);
}

double TriangleTree::squared_distance(const Node& node, const Vector3d& point) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double outside =
        std::max({node.low[axis] - point[axis], point[axis] - static_cast<double>(node.high[axis]), 0.0});
    sum += outside * outside;
  }
  return sum;
}

TriangleHit TriangleTree::hit(const Vector3d& point, std::int32_t place) const {
  const Corners& corners = corners_[place];
  TriangleHit found = nearest_on_triangle(point, corners[0], corners[1], corners[2]);
  found.place = place;
  return found;
}

template <typename Limit, typename Visit>
void TriangleTree::search(const Vector3d& point, const Limit& limit, const Visit& visit) const {
  if (nodes_.empty()) return;
  struct Waiting {
    std::int32_t node;
    double squared_distance;
  };
  std::array<Waiting, kStackSize> stack;
  std::size_t size = 0;
  stack[size++] = {0, squared_distance(nodes_[0], point)};
  while (size > 0) {
    const Waiting next = stack[--size];
    if (next.squared_distance > limit() * kRounding) continue;
    const Node& node = nodes_[next.node];
    if (node.count > 0) {
      for (std::int32_t place = node.first; place < node.first + node.count; ++place) {
        if (!visit(place)) return;
      }
      continue;
    }
    const double left = squared_distance(nodes_[node.first], point);
    const double right = squared_distance(nodes_[node.first + 1], point);
    const Waiting children[2] = {{node.first, left}, {node.first + 1, right}};
    const bool left_first = left <= right;
    stack[size++] = children[left_first ? 1 : 0];
    stack[size++] = children[left_first ? 0 : 1];
  }
}

TriangleHit TriangleTree::nearest(const Vector3d& point, double limit) const {
  TriangleHit best;
  best.squared_distance = limit;
  search(
      point, [&] { return best.squared_distance; },
      [&](std::int32_t place) {
        const TriangleHit found = hit(point, place);
        if (found.squared_distance < best.squared_distance ||
            (found.squared_distance == best.squared_distance && (best.place < 0 || place < best.place))) {
          best = found;
        }
        return true;
      });
  return best;
}

bool TriangleTree::any_within(const Vector3d& point, double reach) const {
  bool any = false;
  search(
      point, [&] { return reach * reach; },
      [&](std::int32_t place) {
        any = hit(point, place).squared_distance <= reach * reach;
        return !any;
      });
  return any;
}

bool TriangleTree::collect(const Vector3d& point, double reach, std::size_t most,
                           std::vector<std::int32_t>& places) const {
  bool complete = true;
  search(
      point, [&] { return reach * reach; },
      [&](std::int32_t place) {
        if (hit(point, place).squared_distance > reach * reach * kRounding) return true;
        complete = places.size() < most;
        if (complete) places.push_back(place);
        return complete;
      });
  return complete;
}

double TriangleTree::least_distance(const Node& node, const Eigen::AlignedBox3d& box) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double outside =
        std::max({node.low[axis] - box.max()[axis], box.min()[axis] - static_cast<double>(node.high[axis]), 0.0});
    sum += outside * outside;
  }
  return std::sqrt(sum);
}

SegmentHit TriangleTree::nearest_to_segment(const Segment& segment, double reach) const {
  SegmentHit best;
  if (nodes_.empty()) return best;
  Eigen::AlignedBox3d box(segment.start);
  box.extend(segment.end);
  double limit = reach;
  std::array<std::int32_t, kStackSize> stack;
  std::size_t size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const Node& node = nodes_[static_cast<std::size_t>(stack[--size])];
    if (!(least_distance(node, box) <= limit * kRounding)) continue;
    for (std::int32_t place = node.first; place < node.first + node.count; ++place) {
      const Corners& corners = corners_[static_cast<std::size_t>(place)];
      if (is_surely_beyond(segment, box, corners, limit)) continue;
      const SegmentHit found = nearest_to_triangle(segment, corners);
      if (found.distance > limit || found.distance >= best.distance) continue;
      best = found;
      limit = found.distance;
    }
    if (node.count > 0) continue;
    stack[size++] = node.first + 1;
    stack[size++] = node.first;
  }
  return best;
}

TriangleHit TriangleTree::nearest_among(const Vector3d& point, std::span<const std::int32_t> places) const {
  TriangleHit best;
  for (const std::int32_t place : places) {
    const TriangleHit found = hit(point, place);
    if (found.squared_distance < best.squared_distance ||
        (found.squared_distance == best.squared_distance && place < best.place)) {
      best = found;
    }
  }
  return best;
}

}  // namespace netpocket
