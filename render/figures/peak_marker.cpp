#include "render/figures/peak_marker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/figures/axis_ticks.h"

namespace netpocket {

std::optional<Curve> peak_marker(const std::vector<double>& times, const std::vector<double>& values,
                                 const std::string& unit, double least) {
  std::optional<std::size_t> peak;
  for (std::size_t i = 0; i < std::min(values.size(), times.size()); ++i) {
    if (!std::isfinite(values[i]) || values[i] == 0 || std::abs(values[i]) < least) continue;
    if (!peak || std::abs(values[i]) > std::abs(values[*peak])) peak = i;
  }
  if (!peak) return std::nullopt;
  Curve curve;
  curve.x = {times[*peak]};
  curve.y = {values[*peak]};
  curve.colour = kBlack;
  curve.marker = Marker::circle;
  const int decimals = 2 - static_cast<int>(std::floor(std::log10(std::abs(curve.y[0]))));  // three digits
  curve.label =
      fmt::format("{} {} at {} s", number_text(curve.y[0], std::max(decimals, 1)), unit, number_text(curve.x[0], 2));
  return curve;
}

}  // namespace netpocket
