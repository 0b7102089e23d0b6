#include "render/figures/panel_layout.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "render/figures/figure_style.h"

namespace netpocket {
namespace {

struct DataRange {
  double low = INFINITY;
  double high = -INFINITY;

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void include(const DataRange& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
  bool empty() const { return low > high; }
};

struct PanelRange {
  DataRange x;
  DataRange y;
};

PanelRange data_range(const Panel& panel) {
  PanelRange range;
  for (const Curve& curve : panel.curves) {
    for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
      if (!std::isfinite(curve.x[i]) || !std::isfinite(curve.y[i])) continue;
      range.x.include(curve.x[i]);
      range.y.include(curve.y[i]);
    }
  }
  return range;
}

std::vector<PanelRange> data_ranges(const Figure& figure) {
  std::vector<PanelRange> ranges;
  for (const Panel& panel : figure.panels) ranges.push_back(data_range(panel));
  std::map<int, DataRange> groups;
  for (std::size_t i = 0; i < ranges.size(); ++i) groups[figure.panels[i].y_group].include(ranges[i].y);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const int group = figure.panels[i].y_group;
    if (group >= 0 && !ranges[i].y.empty()) ranges[i].y = groups[group];
  }
  return ranges;
}

AxisLimits axis_limits(const PanelAxis& axis, const DataRange& range, double margin) {
  AxisLimits limits = range.empty() ? AxisLimits{} : padded_limits(range.low, range.high, margin, axis.minimum_span);
  if (axis.low) limits.low = *axis.low;
  if (axis.high) limits.high = *axis.high;
  if (!(limits.low < limits.high)) limits.high = limits.low + 1;
  return limits;
}

// Lifts the upper limit so that curves stay below the phase labels.
AxisLimits below_phase_labels(AxisLimits limits, double frame_height) {
  const double free = std::max(frame_height - style::kPhaseStrip, frame_height / 2);
  limits.high = limits.low + limits.span() * frame_height / free;
  return limits;
}

int intervals(double length, double spacing) { return std::max(2, static_cast<int>(length / spacing)); }

double widest_label(cairo_t* context, const AxisTicks& ticks) {
  double widest = 0;
  for (const std::string& label : ticks.labels) {
    widest = std::max(widest, text_width(context, label, style::kTickLabel));
  }
  return widest;
}

// What stands left of the frames of one column of panels.
struct Gutter {
  double labels = 0;      // widest tick label
  double multiplier = 0;  // widest text above the tick labels

  double title_baseline() const { return labels + 2 * style::kGap + 0.1 * style::kAxisTitle.size; }
  double width() const { return std::max(title_baseline() + style::kAxisTitle.size, multiplier + style::kGap); }
};

}  // namespace

PaperMap PanelLayout::map() const {
  const double x_scale = frame.width / x_limits.span();
  const double y_scale = -frame.height / y_limits.span();
  return {frame.x - x_scale * x_limits.low, x_scale, frame.bottom() - y_scale * y_limits.low, y_scale};
}

std::vector<PanelLayout> lay_out_panels(const Figure& figure, cairo_t* context, const Box& area) {
  const std::size_t columns = static_cast<std::size_t>(std::max(figure.columns, 1));
  const std::size_t rows = (figure.panels.size() + columns - 1) / columns;
  const double above = style::kPanelTitle.size * kLineHeight + style::kGap;
  const double below = (style::kTickLabel.size + style::kAxisTitle.size) * kLineHeight + 2 * style::kGap;
  const double cell_height = area.height / static_cast<double>(std::max<std::size_t>(rows, 1));
  const double frame_height = std::max(cell_height - above - below, 10.0);

  const std::vector<PanelRange> ranges = data_ranges(figure);
  std::vector<PanelLayout> layouts(figure.panels.size());
  std::vector<Gutter> gutters(columns);
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    const Panel& panel = figure.panels[i];
    PanelLayout& layout = layouts[i];
    layout.has_data = !ranges[i].x.empty();
    layout.x_limits = axis_limits(panel.x, ranges[i].x, 0);
    layout.y_limits = axis_limits(panel.y, ranges[i].y, style::kCurveMargin);
    if (!panel.phases.empty()) layout.y_limits = below_phase_labels(layout.y_limits, frame_height);
    layout.y_ticks = make_ticks(layout.y_limits, intervals(frame_height, style::kTickSpacingY));
    Gutter& gutter = gutters[i % columns];
    gutter.labels = std::max(gutter.labels, widest_label(context, layout.y_ticks));
    gutter.multiplier = std::max(gutter.multiplier, text_width(context, layout.y_ticks.multiplier, style::kTickLabel));
  }

  double free_width = area.width;
  for (const Gutter& gutter : gutters) free_width -= gutter.width() + style::kRightMargin;
  const double frame_width = std::max(free_width / static_cast<double>(columns), 10.0);
  double left = area.x;
  for (std::size_t column = 0; column < columns; ++column) {
    left += gutters[column].width();
    for (std::size_t i = column; i < layouts.size(); i += columns) {
      const double top = area.y + static_cast<double>(i / columns) * cell_height + above;
      layouts[i].frame = {left, top, frame_width, frame_height};
      layouts[i].y_title_baseline = left - gutters[column].title_baseline();
      layouts[i].x_ticks = make_ticks(layouts[i].x_limits, intervals(frame_width, style::kTickSpacingX));
    }
    left += frame_width + style::kRightMargin;
  }
  return layouts;
}

}  // namespace netpocket
