#include "gui/workbench/panels/time_window.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace netpocket {
namespace {

std::size_t point_count(const Curve& curve) { return std::min(curve.x.size(), curve.y.size()); }

void cut(Curve& curve, const TimeRange& range) {
  const auto end = curve.x.begin() + static_cast<std::ptrdiff_t>(point_count(curve));
  const std::size_t first = std::lower_bound(curve.x.begin(), end, range.begin) - curve.x.begin();
  const std::size_t last = std::upper_bound(curve.x.begin(), end, range.end) - curve.x.begin();
  const auto left = value_at(curve, range.begin);
  const auto right = value_at(curve, range.end);
  Curve part = curve;
  part.x.assign(curve.x.begin() + first, curve.x.begin() + std::max(first, last));
  part.y.assign(curve.y.begin() + first, curve.y.begin() + std::max(first, last));
  if (left && (part.x.empty() || part.x.front() > range.begin)) {
    part.x.insert(part.x.begin(), range.begin);
    part.y.insert(part.y.begin(), *left);
  }
  if (right && (part.x.empty() || part.x.back() < range.end)) {
    part.x.push_back(range.end);
    part.y.push_back(*right);
  }
  curve = std::move(part);
}

}  // namespace

std::optional<TimeRange> time_range(const Figure& figure) {
  TimeRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Panel& panel : figure.panels) {
    for (const Curve& curve : panel.curves) {
      if (point_count(curve) == 0) continue;
      range.begin = std::min(range.begin, curve.x.front());
      range.end = std::max(range.end, curve.x[point_count(curve) - 1]);
    }
  }
  if (!(range.begin < range.end)) return std::nullopt;
  return range;
}

Figure cut(const Figure& figure, const TimeRange& range) {
  Figure result = figure;
  for (Panel& panel : result.panels) {
    for (Curve& curve : panel.curves) cut(curve, range);
  }
  return result;
}

void share_time(Figure& figure, const TimeRange& range) {
  for (Panel& panel : figure.panels) panel.x.limits = AxisLimits{range.begin, range.end};
}

std::optional<double> value_at(const Curve& curve, double time) {
  const std::size_t count = point_count(curve);
  if (count == 0 || !(time >= curve.x.front() && time <= curve.x[count - 1])) return std::nullopt;
  const auto end = curve.x.begin() + static_cast<std::ptrdiff_t>(count);
  const std::size_t after = std::lower_bound(curve.x.begin(), end, time) - curve.x.begin();
  double value = curve.y[after];
  if (curve.x[after] > time) {
    const std::size_t before = after - 1;
    const double part = (time - curve.x[before]) / (curve.x[after] - curve.x[before]);
    value = curve.y[before] + part * (curve.y[after] - curve.y[before]);
  }
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace netpocket
