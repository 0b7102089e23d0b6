#include "gui/workbench/viewport/orbit_camera.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace netpocket {
namespace {

constexpr double kNearest = 0.05;   // m, from the camera to the focal point
constexpr double kFarthest = 5000;  // m
constexpr double kNearPlane = 1e-3;

}  // namespace

double OrbitCamera::half_height(double depth) const {
  if (view_.half_height > 0) return view_.half_height;
  return depth * std::tan(view_.view_angle / 2 * std::numbers::pi / 180);
}

void OrbitCamera::orbit(double right_angle, double up_angle) {
  const Eigen::Vector3d across = right(), upwards = up();
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(-right_angle, upwards) * Eigen::AngleAxisd(up_angle, across)).toRotationMatrix();
  view_.position = view_.focal_point + turn * (view_.position - view_.focal_point);
  view_.view_up = turn * upwards;
}

void OrbitCamera::roll(double angle) { view_.view_up = Eigen::AngleAxisd(-angle, forward()) * up(); }

void OrbitCamera::pan(double right_part, double up_part) {
  const double height = 2 * half_height((view_.focal_point - view_.position).norm());
  move(-height * (right_part * right() + up_part * up()));
}

void OrbitCamera::zoom(double factor) {
  const Eigen::Vector3d away = view_.position - view_.focal_point;
  if (view_.half_height > 0) {
    view_.half_height = std::clamp(view_.half_height / factor, kNearest, kFarthest);
    return;
  }
  view_.position = view_.focal_point + away.normalized() * std::clamp(away.norm() / factor, kNearest, kFarthest);
}

void OrbitCamera::zoom_at(const QPointF& point, const QSizeF& size, double factor) {
  const double before = metres_per_pixel(size);
  zoom(factor);
  const double gained = before - metres_per_pixel(size);
  const QPointF offset = point - QPointF(size.width() / 2, size.height() / 2);
  move(gained * (offset.x() * right() - offset.y() * up()));
}

void OrbitCamera::move(const Eigen::Vector3d& shift) {
  view_.position += shift;
  view_.focal_point += shift;
}

std::optional<ScreenPoint> OrbitCamera::project(const Eigen::Vector3d& point, const QSizeF& size) const {
  const Eigen::Vector3d relative = point - view_.position;
  const double depth = relative.dot(forward());
  if (depth < kNearPlane) return std::nullopt;
  const double scale = size.height() / 2 / half_height(depth);
  return ScreenPoint{{size.width() / 2 + scale * relative.dot(right()), size.height() / 2 - scale * relative.dot(up())},
                     depth};
}

ViewRay OrbitCamera::ray(const QPointF& position, const QSizeF& size) const {
  const double x = (2 * position.x() - size.width()) / size.height(), y = 1 - 2 * position.y() / size.height();
  const Eigen::Vector3d sideways = half_height(1) * (x * right() + y * up());
  if (view_.half_height > 0) return {view_.position + sideways, forward()};
  return {view_.position, (forward() + sideways).normalized()};
}

double OrbitCamera::metres_per_pixel(const QSizeF& size) const {
  return 2 * half_height((view_.focal_point - view_.position).norm()) / size.height();
}

}  // namespace netpocket
