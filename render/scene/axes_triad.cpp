#include "render/scene/axes_triad.h"

#include <vtkMatrix4x4.h>

#include <algorithm>

namespace netpocket {
namespace {

constexpr std::array<Color, 3> kAxisColors = {{{0.80, 0.25, 0.20}, {0.20, 0.58, 0.30}, {0.20, 0.40, 0.80}}};
// Pixels of a picture 720 pixels high.
constexpr double kLength = 40, kCorner = 66, kHead = 9;

// Row i: world axis i seen in the picture (right, up, towards the viewer).
Eigen::Matrix3d seen_axes(vtkCamera& camera) {
  const auto* view = camera.GetViewTransformMatrix();
  Eigen::Matrix3d axes;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) axes(column, row) = view->GetElement(row, column);
  }
  return axes;
}

}  // namespace

AxesTriad::AxesTriad(const SceneOptions& options, const Color& text)
    : annotation_scale_(options.annotation_scale),
      names_{OverlayText(text, Align::center), OverlayText(text, Align::center), OverlayText(text, Align::center)} {
  constexpr const char* kNames[] = {"X", "Y", "Z"};
  props_ = {arrows_.prop()};
  for (int i = 0; i < 3; ++i) {
    names_[i].set_text(kNames[i]);
    props_.emplace_back(names_[i].prop());
  }
}

void AxesTriad::add_arrow(const Eigen::Vector2d& from, const Eigen::Vector2d& along, double unit, const Color& color) {
  const double length = along.norm();
  if (length < kHead * unit) return;  // points at the viewer
  const Eigen::Vector2d direction = along / length, side(-direction.y(), direction.x());
  const Eigen::Vector2d tip = from + along, neck = tip - kHead * unit * direction;
  arrows_.add_line(from, neck, 2.2 * unit, color);
  arrows_.add_triangle(tip, neck + 3.6 * unit * side, neck - 3.6 * unit * side, color);
}

void AxesTriad::adapt(const View& view) {
  const double unit = view.scale() * annotation_scale_;
  const Eigen::Matrix3d axes = seen_axes(*view.camera);
  const Eigen::Vector2d center = Eigen::Vector2d::Constant(kCorner * unit);
  std::array order = {0, 1, 2};
  std::ranges::sort(order, {}, [&](int i) { return axes(i, 2); });  // nearest last

  arrows_.clear();
  for (const int i : order) {
    const Eigen::Vector2d along = kLength * unit * axes.row(i).head<2>().transpose();
    add_arrow(center, along, unit, kAxisColors[i]);
    const bool towards_viewer = along.norm() < kHead * unit;
    const Eigen::Vector2d beside(-11 * unit, -11 * unit);
    names_[i].place(towards_viewer ? Eigen::Vector2d(center + beside)
                                   : Eigen::Vector2d(center + along + 11 * unit * along.normalized()),
                    15 * unit);
  }
}

}  // namespace netpocket
