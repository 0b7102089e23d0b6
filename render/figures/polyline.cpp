#include "render/figures/polyline.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace netpocket {
namespace {

// Length of the part of a segment inside a box (Liang & Barsky 1984).
double length_inside(const Point& a, const Point& b, const PlotBox& box) {
  const bool misses = std::max(a.x, b.x) < box.x || std::min(a.x, b.x) > box.right() || std::max(a.y, b.y) < box.y ||
                      std::min(a.y, b.y) > box.bottom();
  if (misses) return 0;
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  double enter = 0;
  double leave = 1;
  const auto clip = [&](double direction, double distance) {  // keeps direction * t <= distance
    if (direction == 0) {
      if (distance < 0) leave = -1;
    } else if (direction < 0) {
      enter = std::max(enter, distance / direction);
    } else {
      leave = std::min(leave, distance / direction);
    }
  };
  clip(-dx, a.x - box.x);
  clip(dx, box.right() - a.x);
  clip(-dy, a.y - box.y);
  clip(dy, box.bottom() - a.y);
  return std::max(0.0, leave - enter) * std::hypot(dx, dy);
}

}  // namespace

std::vector<Polyline> map_curve(const std::vector<double>& x, const std::vector<double>& y, const PaperMap& map) {
  std::vector<Polyline> lines;
  bool open = false;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    const bool finite = std::isfinite(x[i]) && std::isfinite(y[i]);
    if (finite && !open) lines.emplace_back();
    if (finite) lines.back().push_back(map(x[i], y[i]));
    open = finite;
  }
  return lines;
}

double length_inside(const Polyline& line, const PlotBox& box) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += length_inside(line[i - 1], line[i], box);
  return length;
}

Polyline decimate(const Polyline& line, double column_width) {
  Polyline kept;
  const auto column = [&](std::size_t i) { return std::floor(line[i].x / column_width); };
  std::size_t first = 0;
  while (first < line.size()) {
    std::size_t last = first;
    std::size_t lowest = first;
    std::size_t highest = first;
    while (last + 1 < line.size() && column(last + 1) == column(first)) {
      ++last;
      if (line[last].y < line[lowest].y) lowest = last;
      if (line[last].y > line[highest].y) highest = last;
    }
    std::array<std::size_t, 4> chosen = {first, lowest, highest, last};
    std::sort(chosen.begin(), chosen.end());
    const auto end = std::unique(chosen.begin(), chosen.end());
    std::for_each(chosen.begin(), end, [&](std::size_t i) { kept.push_back(line[i]); });
    first = last + 1;
  }
  return kept;
}

}  // namespace netpocket
