#include "render/scene/legend.h"

#include <fmt/format.h>

#include <string>

#include "render/scene/palette.h"

namespace netpocket {
namespace {

constexpr int kBands = 96;
constexpr int kValues = 6;
// Pixels of a picture 720 pixels high.
constexpr double kBarWidth = 16, kBarHeight = 260, kRightMargin = 86, kTick = 5;

// Without the zeros of an exponent, for which there is no room: 2e6, not 2e+06.
std::string short_number(double value) {
  std::string text = fmt::format("{:.4g}", value);
  const std::size_t exponent = text.find('e');
  if (exponent == std::string::npos) return text;
  return fmt::format("{}e{}", text.substr(0, exponent), std::stoi(text.substr(exponent + 1)));
}

}  // namespace

Legend::Legend(const ColorScale& scale, const SceneOptions& options, const Color& text)
    : scale_(scale), annotation_scale_(options.annotation_scale), text_color_(text), label_(text, Align::right) {
  label_.set_text(options.legend_title.empty() ? scale.label() : options.legend_title);
  values_.reserve(kValues);
  for (int i = 0; i < kValues; ++i) values_.emplace_back(text, Align::left);
  props_ = {bar_.prop(), label_.prop()};
  if (options.legend_ground) {
    const Color& ground = palette(options.background).background;
    label_.set_ground(ground);
    for (auto& value : values_) value.set_ground(ground);
  }
  for (auto& value : values_) props_.emplace_back(value.prop());
}

void Legend::adapt(const View& view) {
  const double unit = view.scale() * annotation_scale_;
  const Eigen::Vector2d low(view.width - kRightMargin * unit, (view.height - kBarHeight * unit) / 2);
  const double right = low.x() + kBarWidth * unit;
  const auto height_at = [&](double fraction) { return low.y() + fraction * kBarHeight * unit; };

  bar_.clear();
  const double frame = 1.0 * view.scale();
  for (int i = 0; i < kBands; ++i) {
    bar_.add_rectangle({low.x(), height_at(static_cast<double>(i) / kBands)},
                       {right, height_at(static_cast<double>(i + 1) / kBands)},
                       scale_.color_at_fraction((i + 0.5) / kBands));
  }
  const auto range = scale_.range();
  for (int i = 0; i < kValues; ++i) {
    const double fraction = static_cast<double>(i) / (kValues - 1);
    const double y = height_at(fraction);
    bar_.add_line({right, y}, {right + kTick * unit, y}, frame, text_color_);
    const double value = (range.low + fraction * (range.high - range.low)) / scale_.display_unit();
    // Higher values share the last colour.
    values_[i].set_text((i + 1 == kValues ? "\u2265 " : "") + short_number(value));
    values_[i].place({right + (kTick + 5) * unit, y}, 15 * unit);
  }
  label_.place({view.width - 24 * unit, height_at(1) + 24 * unit}, 16 * unit);
}

}  // namespace netpocket
