#include "engine/systems/thrown_net/net_surface.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/math/elementary.h"

namespace netpocket {
namespace {

// Solid angle of a triangle whose corners are seen at a, b and c: Van Oosterom & Strackee 1983,
// doi:10.1109/TBME.1983.325207. Positive or negative by the side that is seen.
double solid_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  const double volume = a.dot(b.cross(c));
  const double spread = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return volume == 0 && spread == 0 ? 0 : 2 * arc_tangent(volume, spread);
}

}  // namespace

NetSurface::NetSurface(const NetPattern& pattern, std::vector<std::int32_t> nodes) : nodes_(std::move(nodes)) {
  const auto node = [this](std::int32_t knot) { return nodes_[static_cast<std::size_t>(knot)]; };
  for (const auto& [a, b, c] : pattern.triangles) triangles_.push_back({node(a), node(b), node(c)});
  for (const std::int32_t knot : pattern.perimeter) perimeter_.push_back(node(knot));
}

double NetSurface::area(const Eigen::Matrix3Xd& positions) const {
  double sum = 0;
  for (const auto& [a, b, c] : triangles_) {
    const Eigen::Vector3d along = positions.col(b) - positions.col(a), across = positions.col(c) - positions.col(a);
    sum += 0.5 * along.cross(across).norm();
  }
  return sum;
}

double NetSurface::mouth_area(const Eigen::Matrix3Xd& positions) const {
  const Eigen::Vector3d origin = positions.col(perimeter_.front());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < perimeter_.size(); ++i) {
    const Eigen::Vector3d here = positions.col(perimeter_[i]) - origin;
    const Eigen::Vector3d next = positions.col(perimeter_[(i + 1) % perimeter_.size()]) - origin;
    sum += 0.5 * here.cross(next);
  }
  return sum.norm();
}

double NetSurface::enclosure(const Eigen::Matrix3Xd& positions, const Eigen::Vector3d& point) const {
  double sum = 0;
  for (const auto& [a, b, c] : triangles_) {
    sum += solid_angle(positions.col(a) - point, positions.col(b) - point, positions.col(c) - point);
  }
  return std::abs(sum) / (4 * std::numbers::pi);
}

Eigen::Vector3d NetSurface::centre(const Eigen::Matrix3Xd& positions) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const std::int32_t node : nodes_) sum += positions.col(node);
  return sum / static_cast<double>(nodes_.size());
}

}  // namespace netpocket
