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

NetSurface::NetSurface(std::vector<std::int32_t> knots, int cells) : knots_(std::move(knots)) {
  const auto knot = [&](int row, int column) { return knots_[static_cast<std::size_t>(row * (cells + 1) + column)]; };
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      const std::int32_t a = knot(row, column), b = knot(row, column + 1);
      const std::int32_t c = knot(row + 1, column + 1), d = knot(row + 1, column);
      triangles_.push_back({a, b, c});
      triangles_.push_back({a, c, d});
    }
  }
  for (int i = 0; i < cells; ++i) perimeter_.push_back(knot(0, i));
  for (int i = 0; i < cells; ++i) perimeter_.push_back(knot(i, cells));
  for (int i = cells; i > 0; --i) perimeter_.push_back(knot(cells, i));
  for (int i = cells; i > 0; --i) perimeter_.push_back(knot(i, 0));
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
  for (const std::int32_t knot : knots_) sum += positions.col(knot);
  return sum / static_cast<double>(knots_.size());
}

}  // namespace netpocket
