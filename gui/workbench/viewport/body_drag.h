#pragma once
// Moves a body with the mouse, in the plane of the picture through the point that was grabbed. A plain value.

#include <Eigen/Core>
#include <QPointF>
#include <QSizeF>

#include "gui/workbench/viewport/orbit_camera.h"

namespace netpocket {

class BodyDrag {
 public:
  // `grabbed`: the point under the mouse; `center`: of the body's mass; m, world. `size` of the picture, pixels.
  BodyDrag(const OrbitCamera& camera, const QSizeF& size, const Eigen::Vector3d& grabbed, const Eigen::Vector3d& center)
      : camera_(camera), size_(size), grabbed_(grabbed), center_(center) {}

  // Where the centre is with the mouse at `position`, in whole centimetres; m, world. Along one axis: only along that
  // of the world along which the mouse has moved farthest.
  Eigen::Vector3d center_at(const QPointF& position, bool along_one_axis) const;

 private:
  OrbitCamera camera_;
  QSizeF size_;
  Eigen::Vector3d grabbed_;
  Eigen::Vector3d center_;
};

}  // namespace netpocket
