#pragma once
// The surface that the knots of a net span, in triangles between them.

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

#include "engine/systems/thrown_net/net_pattern.h"

namespace netpocket {

class NetSurface {
 public:
  // `nodes`: by knot of the pattern; columns of the positions below.
  NetSurface(const NetPattern& pattern, std::vector<std::int32_t> nodes);

  // m^2, of the net: the sum over its triangles. At most that of the flat net if no mesh side is longer than there.
  double area(const Eigen::Matrix3Xd& positions) const;
  // m^2, of the mouth: the magnitude of the vector area that the perimeter encloses.
  double mouth_area(const Eigen::Matrix3Xd& positions) const;
  // Part of all directions from `point` (m) that the net covers, 0 to 1: its solid angle by 4 pi. A flat net has at
  // most 0.5; a net that is closed round the point has 1. Surface that covers a direction twice, with opposite
  // sides, does not count.
  double enclosure(const Eigen::Matrix3Xd& positions, const Eigen::Vector3d& point) const;
  // m, mean of the knots.
  Eigen::Vector3d centre(const Eigen::Matrix3Xd& positions) const;

 private:
  std::vector<std::int32_t> nodes_;
  std::vector<std::array<std::int32_t, 3>> triangles_;  // nodes
  std::vector<std::int32_t> perimeter_;                 // nodes, in their order round the net
};

}  // namespace netpocket
