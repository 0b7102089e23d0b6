#include "render/figures/study_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/figures/rich_text.h"

namespace netpocket {

std::string axis_title(const ResultColumn& column) {
  const bool has_unit = !column.unit.empty() && column.unit != "1";
  return plain_text(has_unit ? fmt::format("{} ({})", column.name, column.unit) : column.name);
}

Curve plain_line(FigureColour colour, double width, const std::string& label) {
  Curve curve;
  curve.colour = colour;
  curve.width = width;
  curve.label = label;
  return curve;
}

Curve scatter(FigureColour colour, const std::string& label) {
  Curve curve = plain_line(colour, 0.9, label);
  curve.marker = Marker::circle;
  return curve;
}

void add_point(Curve& curve, double x, double y) {
  curve.x.insert(curve.x.end(), {x, kGapInCurve});
  curve.y.insert(curve.y.end(), {y, kGapInCurve});
}

Panel panel_of(const std::string& x_title, const std::string& y_title, std::vector<Curve> curves) {
  Panel panel;
  panel.x.title = x_title;
  panel.y.title = y_title;
  panel.curves = std::move(curves);
  return panel;
}

ColumnRange range_of(const ResultColumn& column) {
  ColumnRange range;
  for (const double value : column.values) {
    if (std::isfinite(value)) range = {std::min(range.from, value), std::max(range.to, value)};
  }
  return range;
}

}  // namespace netpocket
