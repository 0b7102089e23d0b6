#include "render/figures/legend.h"

#include <algorithm>

#include "render/figures/curve_pen.h"
#include "render/figures/figure_style.h"

namespace netpocket {
namespace {

constexpr double kKeyLength = 16;
constexpr double kEntryHeight = style::kLegend.size * 1.35;
constexpr double kPadding = 3;
constexpr int kPlacesAcross = 13;
constexpr int kPlacesDown = 9;

// Entries of the labelled curves, arranged column by column.
class Legend {
 public:
  Legend(cairo_t* context, const std::vector<Curve>& curves) {
    for (const Curve& curve : curves) {
      if (curve.label.empty()) continue;
      entries_.push_back(&curve);
      text_widths_.push_back(text_width(context, curve.label, style::kLegend));
    }
  }

  std::size_t size() const { return entries_.size(); }
  const Curve& entry(std::size_t index) const { return *entries_[index]; }
  std::size_t rows(std::size_t columns) const { return (size() + columns - 1) / columns; }

  double column_width(std::size_t columns, std::size_t column) const {
    double widest = 0;
    const std::size_t first = column * rows(columns);
    for (std::size_t i = first; i < std::min(size(), first + rows(columns)); ++i) {
      widest = std::max(widest, text_widths_[i]);
    }
    return kKeyLength + kPadding + widest + 2 * kPadding;
  }

  double width(std::size_t columns) const {
    double sum = 0;
    for (std::size_t column = 0; column < columns; ++column) sum += column_width(columns, column);
    return sum + kPadding / 2;
  }

  double height(std::size_t columns) const {
    return static_cast<double>(rows(columns)) * kEntryHeight + 2 * kPadding - 1;
  }

 private:
  std::vector<const Curve*> entries_;
  std::vector<double> text_widths_;
};

double hidden_length(const std::vector<Polyline>& lines, const PlotBox& box) {
  constexpr double kClearance = 1.5;
  const PlotBox wider{box.x - kClearance, box.y - kClearance, box.width + 2 * kClearance, box.height + 2 * kClearance};
  double length = 0;
  for (const Polyline& line : lines) length += length_inside(line, wider);
  return length;
}

// Readers look for a legend in a corner, the upper right one first.
double distance_from_corner(const PlotBox& box, const PlotBox& free) {
  const double right = free.right() - box.right();
  const double left = box.x - free.x;
  const double top = box.y - free.y;
  const double bottom = free.bottom() - box.bottom();
  return std::min(right, left + 1) + std::min(top, bottom + 2);
}

// A hidden stretch of curve weighs more than any way to a corner; one column reads best.
double cost(const LegendPlace& place, const PlotBox& free) {
  return 1000 * place.hidden + distance_from_corner(place.box, free) + static_cast<double>(place.columns);
}

void draw_key(cairo_t* context, const Curve& curve, double x, double y) {
  const bool is_point = curve.marker != Marker::none && curve.y.size() == 1;
  if (!is_point) stroke_line(context, curve, {{x, y}, {x + kKeyLength, y}});
  if (curve.marker != Marker::none) draw_marker(context, curve, {x + kKeyLength / 2, y});
}

void paint_background(cairo_t* context, const PlotBox& box) {
  cairo_rectangle(context, box.x, box.y, box.width, box.height);
  cairo_set_source_rgba(context, 1, 1, 1, 0.85);
  cairo_fill_preserve(context);
  cairo_set_source_rgb(context, style::kLegendFrame.red, style::kLegendFrame.green, style::kLegendFrame.blue);
  cairo_set_line_width(context, style::kGridLine);
  cairo_stroke(context);
}

}  // namespace

LegendPlace place_legend(cairo_t* context, const std::vector<Curve>& curves, const std::vector<Polyline>& lines,
                         const PlotBox& free) {
  const Legend legend(context, curves);
  LegendPlace best;
  for (std::size_t columns = legend.size(); columns > 0; --columns) {
    const double width = legend.width(columns);
    const double height = legend.height(columns);
    const bool fits = width <= free.width && height <= free.height;
    if (!fits && (columns > 1 || !best.empty())) continue;
    for (int across = 0; across < kPlacesAcross; ++across) {
      for (int down = 0; down < kPlacesDown; ++down) {
        LegendPlace place;
        place.columns = columns;
        place.box = {free.x + (free.width - width) * across / (kPlacesAcross - 1),
                     free.y + (free.height - height) * down / (kPlacesDown - 1), width, height};
        place.hidden = hidden_length(lines, place.box);
        if (best.empty() || cost(place, free) < cost(best, free)) best = place;
      }
    }
  }
  return best;
}

double flattest_legend_height(cairo_t* context, const std::vector<Curve>& curves, double width) {
  const Legend legend(context, curves);
  std::size_t columns = std::max<std::size_t>(legend.size(), 1);
  while (columns > 1 && legend.width(columns) > width) --columns;
  return legend.height(columns);
}

void draw_legend(cairo_t* context, const std::vector<Curve>& curves, const LegendPlace& place) {
  if (place.empty()) return;
  paint_background(context, place.box);
  const Legend legend(context, curves);
  const std::size_t rows = legend.rows(place.columns);
  double x = place.box.x + kPadding;
  for (std::size_t i = 0; i < legend.size(); ++i) {
    if (i > 0 && i % rows == 0) x += legend.column_width(place.columns, i / rows - 1);
    const double y = place.box.y + kPadding - 0.5 + (static_cast<double>(i % rows) + 0.5) * kEntryHeight;
    draw_key(context, legend.entry(i), x, y);
    draw_text(context, legend.entry(i).label, style::kLegend, x + kKeyLength + kPadding,
              y + kCapHeight * style::kLegend.size / 2, TextAlign::left);
  }
}

}  // namespace netpocket
