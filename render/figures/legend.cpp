#include "render/figures/legend.h"

#include <algorithm>
#include <cmath>

#include "render/figures/figure_style.h"

namespace netpocket {
namespace {

constexpr double kKeyLength = 16;
constexpr double kEntryHeight = style::kLegend.size * 1.35;
constexpr double kPadding = 3;
constexpr int kPlacesAcross = 13;
constexpr int kPlacesDown = 9;

struct Legend {
  std::vector<const Curve*> entries;
  std::size_t columns = 1;
  double entry_width = 0;

  std::size_t rows() const { return (entries.size() + columns - 1) / columns; }
  double width() const { return static_cast<double>(columns) * entry_width + kPadding; }
  double height() const { return static_cast<double>(rows()) * kEntryHeight + 2 * kPadding; }
};

Legend make_legend(cairo_t* context, const std::vector<Curve>& curves) {
  Legend legend;
  for (const Curve& curve : curves) {
    if (curve.label.empty()) continue;
    legend.entries.push_back(&curve);
    const double text = text_width(context, curve.label, style::kLegend);
    legend.entry_width = std::max(legend.entry_width, kKeyLength + text + 3 * kPadding);
  }
  return legend;
}

struct Place {
  Box box;
  double cost = INFINITY;  // points of curve hidden, then distance from the nearest corner
};

double hidden_length(const std::vector<Polyline>& lines, const Box& box) {
  double length = 0;
  for (const Polyline& line : lines) length += length_inside(line, box);
  return length;
}

// Readers look for a legend in a corner, the upper right one first.
double distance_from_corner(const Box& box, const Box& free) {
  const double right = free.right() - box.right();
  const double left = box.x - free.x;
  const double top = box.y - free.y;
  const double bottom = free.bottom() - box.bottom();
  return std::min(right, left + 1) + std::min(top, bottom + 2);
}

Place best_place(const Legend& legend, const std::vector<Polyline>& lines, const Box& free) {
  constexpr double kPointsPerHiddenPoint = 100;  // a hidden stretch weighs more than any way to a corner
  Place best;
  for (int across = 0; across < kPlacesAcross; ++across) {
    for (int down = 0; down < kPlacesDown; ++down) {
      const double x = free.x + (free.width - legend.width()) * across / (kPlacesAcross - 1);
      const double y = free.y + (free.height - legend.height()) * down / (kPlacesDown - 1);
      const Box box{x, y, legend.width(), legend.height()};
      const double cost = kPointsPerHiddenPoint * hidden_length(lines, box) + distance_from_corner(box, free);
      if (cost < best.cost) best = {box, cost};
    }
  }
  return best;
}

void draw_key(cairo_t* context, const Curve& curve, double x, double y) {
  const bool is_point = curve.marker != Marker::none && curve.y.size() == 1;
  if (!is_point) stroke_line(context, curve, {{x, y}, {x + kKeyLength, y}});
  if (curve.marker != Marker::none) draw_marker(context, curve, {x + kKeyLength / 2, y});
}

void paint(cairo_t* context, const Legend& legend, const Box& box) {
  cairo_set_source_rgba(context, 1, 1, 1, 0.85);
  cairo_rectangle(context, box.x, box.y, box.width, box.height);
  cairo_fill(context);
  for (std::size_t i = 0; i < legend.entries.size(); ++i) {
    const double x = box.x + kPadding + static_cast<double>(i % legend.columns) * legend.entry_width;
    const double y = box.y + kPadding + (static_cast<double>(i / legend.columns) + 0.5) * kEntryHeight;
    draw_key(context, *legend.entries[i], x, y);
    draw_text(context, legend.entries[i]->label, style::kLegend, x + kKeyLength + kPadding,
              y + kCapHeight * style::kLegend.size / 2, TextAlign::left);
  }
}

}  // namespace

void draw_legend(cairo_t* context, const std::vector<Curve>& curves, const std::vector<Polyline>& lines,
                 const Box& free) {
  Legend legend = make_legend(context, curves);
  if (legend.entries.empty()) return;
  Place best;
  Legend chosen;
  for (std::size_t columns = 1; columns <= legend.entries.size(); ++columns) {
    legend.columns = columns;
    const bool fits = legend.width() <= free.width && legend.height() <= free.height;
    if (!fits && columns > 1) continue;
    const Place place = best_place(legend, lines, free);
    if (place.cost < best.cost) {
      best = place;
      chosen = legend;
    }
  }
  paint(context, chosen, best.box);
}

void stroke_line(cairo_t* context, const Curve& curve, const Polyline& line) {
  if (line.empty()) return;
  cairo_set_source_rgb(context, curve.colour.red, curve.colour.green, curve.colour.blue);
  cairo_set_line_width(context, curve.width);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context, curve.dash.empty() ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  cairo_set_dash(context, curve.dash.data(), static_cast<int>(curve.dash.size()), 0);
  cairo_move_to(context, line.front().x, line.front().y);
  for (const Point& point : line) cairo_line_to(context, point.x, point.y);
  cairo_stroke(context);
  cairo_set_dash(context, nullptr, 0, 0);
}

void draw_marker(cairo_t* context, const Curve& curve, const Point& centre) {
  const double radius = 1.2 + curve.width;
  cairo_new_path(context);
  if (curve.marker == Marker::circle) cairo_arc(context, centre.x, centre.y, radius, 0, 6.283185307179586);
  if (curve.marker == Marker::square) {
    cairo_rectangle(context, centre.x - radius, centre.y - radius, 2 * radius, 2 * radius);
  }
  cairo_set_source_rgb(context, 1, 1, 1);
  cairo_fill_preserve(context);
  cairo_set_source_rgb(context, curve.colour.red, curve.colour.green, curve.colour.blue);
  cairo_set_line_width(context, 0.8);
  cairo_stroke(context);
}

}  // namespace netpocket
