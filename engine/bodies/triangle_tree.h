#pragma once
// A tree of bounding boxes over triangles that finds the nearest ones to a point.
//
// Answers do not depend on the order of the search: of triangles whose computed distances are equal the first in the
// tree counts, and boxes are left out only if they are farther by more than round-off. So a search among candidates
// that hold the nearest triangle gives the same bits as a search of the whole tree.
// Immutable: any thread may use it. Lengths in m.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/bodies/segment_distance.h"

namespace netpocket {

enum class TriangleFeature : std::uint8_t { corner0, corner1, corner2, edge01, edge12, edge20, face };

// The nearest point of a triangle.
struct TriangleHit {
  double squared_distance = std::numeric_limits<double>::infinity();
  std::int32_t place = -1;  // of the triangle in the tree; -1: none
  TriangleFeature feature = TriangleFeature::face;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
};

// Nearest point of the triangle a, b, c to p: Ericson (2005), Real-Time Collision Detection, 5.1.5. Triangles without
// area have their edges' points.
TriangleHit nearest_on_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                const Eigen::Vector3d& c);

// The place of a segment that is nearest to some triangles: of the way from its start to its end.
struct SegmentHit {
  double t = 0;
  double distance = std::numeric_limits<double>::infinity();  // m, >= 0; 0 where it crosses one
};

class TriangleTree {
 public:
  using Corners = std::array<Eigen::Vector3d, 3>;

  TriangleTree() = default;
  explicit TriangleTree(const std::vector<Corners>& triangles);

  // The nearest triangle with a squared distance of at most `limit`.
  TriangleHit nearest(const Eigen::Vector3d& point, double limit = std::numeric_limits<double>::infinity()) const;
  // Whether any triangle is within `reach`.
  bool any_within(const Eigen::Vector3d& point, double reach) const;
  // Appends the places of all triangles within `reach`; stops when `most` are found and one more exists: then false.
  bool collect(const Eigen::Vector3d& point, double reach, std::size_t most, std::vector<std::int32_t>& places) const;
  // The nearest place of a segment to any triangle within `reach` (m) of it; an infinite distance if there is none.
  SegmentHit nearest_to_segment(const Segment& segment, double reach) const;
  TriangleHit nearest_among(const Eigen::Vector3d& point, std::span<const std::int32_t> places) const;

  // Index of the triangle at a place, as given.
  std::int32_t index(std::int32_t place) const { return indices_[place]; }

 private:
  // Boxes in single precision, rounded outwards: a node in half a cache line.
  struct Node {
    std::array<float, 3> low;
    std::int32_t first;  // first triangle's place, or first of two adjacent children
    std::array<float, 3> high;
    std::int32_t count;  // triangles; 0: children
  };
  void build(std::int32_t node, std::int32_t first, std::int32_t count, const std::vector<Corners>& triangles,
             const std::vector<Eigen::Vector3d>& centres);
  static double squared_distance(const Node& node, const Eigen::Vector3d& point);
  static double least_distance(const Node& node, const Eigen::AlignedBox3d& box);
  TriangleHit hit(const Eigen::Vector3d& point, std::int32_t place) const;
  // Calls visit(place) for the triangles of all boxes within the squared distance that `limit()` gives at the time,
  // nearest boxes first, until it returns false.
  template <typename Limit, typename Visit>
  void search(const Eigen::Vector3d& point, const Limit& limit, const Visit& visit) const;

  std::vector<Node> nodes_;
  std::vector<Corners> corners_;       // by place
  std::vector<std::int32_t> indices_;  // by place
};

}  // namespace netpocket
