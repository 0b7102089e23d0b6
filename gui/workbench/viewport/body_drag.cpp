#include "gui/workbench/viewport/body_drag.h"

#include <cmath>

namespace netpocket {
namespace {

constexpr double kGrid = 100;  // steps in a metre

}  // namespace

Eigen::Vector3d BodyDrag::center_at(const QPointF& position, bool along_one_axis) const {
  const CameraView& view = camera_.view();
  const Eigen::Vector3d forward = (view.focal_point - view.position).normalized();
  const ViewRay ray = camera_.ray(position, size_);
  const double travelled = (grabbed_ - ray.origin).dot(forward) / ray.direction.dot(forward);
  Eigen::Vector3d shift = ray.origin + travelled * ray.direction - grabbed_;
  if (along_one_axis) {
    Eigen::Index axis = 0;
    const double length = shift.cwiseAbs().maxCoeff(&axis);
    shift = std::copysign(length, shift[axis]) * Eigen::Vector3d::Unit(axis);
  }
  // Coordinates that do not change keep their value to the last digit.
  Eigen::Vector3d center = center_;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(shift[i]) * kGrid >= 0.5) center[i] = std::round((center_[i] + shift[i]) * kGrid) / kGrid;
  }
  return center;
}

}  // namespace netpocket
