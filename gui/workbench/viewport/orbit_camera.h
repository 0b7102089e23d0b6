#pragma once
// Moves a camera by hand, and maps between the world and the picture. Screen positions are in logical pixels from the
// top left corner. A plain value.

#include <Eigen/Core>
#include <QPointF>
#include <QSizeF>
#include <optional>

#include "render/scene/camera.h"

namespace netpocket {

struct ViewRay {
  Eigen::Vector3d origin;     // m, world
  Eigen::Vector3d direction;  // unit
};

struct ScreenPoint {
  QPointF position;
  double depth = 0;  // m, in front of the camera
};

class OrbitCamera {
 public:
  OrbitCamera() = default;
  explicit OrbitCamera(const CameraView& view) : view_(view) {}
  const CameraView& view() const { return view_; }

  // Turns about the focal point, angles in rad: to the right about the upward direction, then upwards.
  void orbit(double right, double up);
  // Turns the picture about its centre, rad, counter-clockwise.
  void roll(double angle);
  // Shifts so that what is under the mouse follows it, in parts of the picture's height.
  void pan(double right, double up);
  // Comes nearer (factor > 1) or goes away.
  void zoom(double factor);
  // As zoom(), keeping what is seen at `point` in its place.
  void zoom_at(const QPointF& point, const QSizeF& size, double factor);
  void move(const Eigen::Vector3d& shift);

  // Nothing when the point is behind the camera.
  std::optional<ScreenPoint> project(const Eigen::Vector3d& point, const QSizeF& size) const;
  ViewRay ray(const QPointF& position, const QSizeF& size) const;
  // Metres at the focal point for one pixel.
  double metres_per_pixel(const QSizeF& size) const;

 private:
  Eigen::Vector3d forward() const { return (view_.focal_point - view_.position).normalized(); }
  Eigen::Vector3d right() const { return forward().cross(view_.view_up).normalized(); }
  Eigen::Vector3d up() const { return right().cross(forward()); }
  // Half of the height seen at `depth`, m.
  double half_height(double depth) const;

  CameraView view_;
};

}  // namespace netpocket
