#pragma once
// A tree of bounding boxes over triangles. It finds the triangles nearest to a point or a segment.
//
// Results do not depend on the order of the search. Of triangles with equal computed distances, the first in the tree
// is taken. Boxes are skipped only if they are farther by more than round-off. So a search among candidates that
// include the nearest triangle gives the same bits as a search of the whole tree.
//
// The place of a triangle is its index in the tree's own order. Immutable: any thread may use it. Lengths in m.

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
  std::int32_t place = -1;  // place of the triangle in the tree; -1: none
  TriangleFeature feature = TriangleFeature::face;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
};

// Nearest point of the triangle a, b, c to p: Ericson (2005), Real-Time Collision Detection, 5.1.5. For a triangle
// without area it is a point of its edges. The place is -1.
TriangleHit nearest_on_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                const Eigen::Vector3d& c);

// The point of a segment that is nearest to some triangles.
struct SegmentHit {
  double t = 0;                                               // 0 at the segment's start, 1 at its end
  double distance = std::numeric_limits<double>::infinity();  // m, >= 0; 0 where it crosses a triangle
};

class TriangleTree {
 public:
  using Corners = std::array<Eigen::Vector3d, 3>;

  TriangleTree() = default;
  explicit TriangleTree(const std::vector<Corners>& triangles);

  // The nearest triangle with a squared distance of at most `limit` (m^2); place -1 if there is none.
  TriangleHit nearest(const Eigen::Vector3d& point, double limit = std::numeric_limits<double>::infinity()) const;
  // Whether any triangle is within `reach` (m).
  bool any_within(const Eigen::Vector3d& point, double reach) const;
  // Appends the places of all triangles within `reach` (m). Returns false, with an incomplete list, if `places` would
  // grow beyond `most`.
  bool collect(const Eigen::Vector3d& point, double reach, std::size_t most, std::vector<std::int32_t>& places) const;
  // The point of a segment nearest to any triangle within `reach` (m); an infinite distance if there is none.
  SegmentHit nearest_to_segment(const Segment& segment, double reach) const;
  // The nearest of the triangles at these places.
  TriangleHit nearest_among(const Eigen::Vector3d& point, std::span<const std::int32_t> places) const;

  // Index of the triangle at a place, in the list given to the constructor.
  std::int32_t index(std::int32_t place) const { return indices_[place]; }

 private:
  // Boxes are in single precision, rounded outwards, so that a node fits into half a cache line.
  struct Node {
    std::array<float, 3> low;
    std::int32_t first;  // place of the first triangle, or first of two adjacent children
    std::array<float, 3> high;
    std::int32_t count;  // number of triangles; 0: the node has children
  };
  void build(std::int32_t node, std::int32_t first, std::int32_t count, const std::vector<Corners>& triangles,
             const std::vector<Eigen::Vector3d>& centres);
  static double squared_distance(const Node& node, const Eigen::Vector3d& point);
  static double least_distance(const Node& node, const Eigen::AlignedBox3d& box);
  TriangleHit hit(const Eigen::Vector3d& point, std::int32_t place) const;
  // Calls visit(place) for the triangles of all boxes within the squared distance that `limit()` currently returns,
  // nearer boxes first. Ends when visit returns false.
  template <typename Limit, typename Visit>
  void search(const Eigen::Vector3d& point, const Limit& limit, const Visit& visit) const;

  std::vector<Node> nodes_;
  std::vector<Corners> corners_;       // by place
  std::vector<std::int32_t> indices_;  // by place
};

}  // namespace netpocket
