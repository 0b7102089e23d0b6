#include "render/scene/scale_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace netpocket {
namespace {

// The largest 1, 2 or 5 times a power of ten that is not longer.
double round_down(double length) {
  const double decade = std::pow(10, std::floor(std::log10(length)));
  for (const double step : {5.0, 2.0}) {
    if (step * decade <= length) return step * decade;
  }
  return decade;
}

}  // namespace

double pixel_length(const View& view) {
  if (view.camera->GetParallelProjection()) return 2 * view.camera->GetParallelScale() / view.height;
  const double half_angle = view.camera->GetViewAngle() / 2 * std::numbers::pi / 180;
  return 2 * view.camera->GetDistance() * std::tan(half_angle) / view.height;
}

ScaleBar::ScaleBar(const SceneOptions& options, const Color& color)
    : annotation_scale_(options.annotation_scale), color_(color), label_(color, Align::center) {
  props_ = {bar_.prop(), label_.prop()};
}

void ScaleBar::adapt(const View& view) {
  const double unit = view.scale() * annotation_scale_;
  const double pixel = pixel_length(view);
  const double length = round_down(170 * unit * pixel);
  const double right = view.width - 34 * unit, left = right - length / pixel, y = 36 * unit;
  const double width = std::max(2 * unit, 1.0);  // a thinner line can fall between the centres of pixels
  const double serif = 5 * unit;
  bar_.clear();
  bar_.add_line({left, y}, {right, y}, width, color_);
  for (const double x : {left + width / 2, right - width / 2}) {
    bar_.add_line({x, y - serif}, {x, y + serif}, width, color_);
  }
  label_.set_text(fmt::format("{:g} m", length));
  label_.place({(left + right) / 2, y + 18 * unit}, 16 * unit);
}

}  // namespace netpocket
