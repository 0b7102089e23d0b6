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
  if (axis.limits) return *axis.limits;
  return range.empty() ? AxisLimits{} : padded_limits(range.low, range.high, margin, axis.minimum_span);
}

// Lifts the upper limit so that the data stay out of the top of the frame.
AxisLimits with_headroom(AxisLimits limits, double frame_height, double headroom) {
  const double free = std::max(frame_height - headroom, frame_height / 2);
  limits.high = limits.low + limits.span() * frame_height / free;
  return limits;
}

double phase_strip(const Panel& panel) { return panel.phases.empty() ? 0 : style::kPhaseStrip; }

int intervals(double length, double spacing) { return std::max(2, static_cast<int>(length / spacing)); }

AxisTicks axis_ticks(const PanelAxis& axis, const AxisLimits& limits, int intervals) {
  if (axis.names.empty()) return make_ticks(limits, intervals, axis.whole_numbers ? 1 : 0);
  AxisTicks ticks;
  for (const NamedTick& tick : axis.names) {
    ticks.major.push_back(tick.value);
    ticks.labels.push_back(tick.name);
  }
  return ticks;
}

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
  double width() const { return std::max(title_baseline() + style::kAxisTitle.size, multiplier + 2 * style::kGap); }
};

// Height above the frames: panel titles, or room for half a tick label.
double title_row_height(const Figure& figure) {
  const bool titled = figure.panels.size() > 1 || std::any_of(figure.panels.begin(), figure.panels.end(),
                                                              [](const Panel& panel) { return !panel.title.empty(); });
  return titled ? style::kPanelTitle.size * kLineHeight + style::kGap : style::kTickLabel.size / 2;
}

class GridLayout {
 public:
  GridLayout(const Figure& figure, cairo_t* context, const PlotBox& area)
      : figure_(figure), context_(context), area_(area), ranges_(data_ranges(figure)) {
    const std::size_t rows = (figure.panels.size() + columns_ - 1) / columns_;
    cell_height_ = area.height / static_cast<double>(std::max<std::size_t>(rows, 1));
    const double below = (style::kTickLabel.size + style::kAxisTitle.size) * kLineHeight + 2 * style::kGap;
    frame_height_ = std::max(cell_height_ - above_ - below, 10.0);
  }

  // `headroom` is the height kept free for a legend at the top of each panel.
  std::vector<PanelLayout> lay_out(const std::vector<double>& headroom) const {
    std::vector<PanelLayout> layouts(figure_.panels.size());
    std::vector<Gutter> gutters(columns_);
    for (std::size_t i = 0; i < layouts.size(); ++i) {
      set_vertical(figure_.panels[i], ranges_[i], headroom[i], layouts[i]);
      Gutter& gutter = gutters[i % columns_];
      const AxisTicks& ticks = layouts[i].y_ticks;
      gutter.labels = std::max(gutter.labels, widest_label(context_, ticks));
      gutter.multiplier = std::max(gutter.multiplier, text_width(context_, ticks.multiplier, style::kTickLabel));
    }
    set_horizontal(gutters, layouts);
    for (std::size_t i = 0; i < layouts.size(); ++i) layouts[i].legend = legend_place(figure_.panels[i], layouts[i]);
    return layouts;
  }

  // Headroom that lets every legend stand clear; equal within a group, which shares its limits.
  std::vector<double> headroom_for_legends(const std::vector<PanelLayout>& layouts) const {
    std::vector<double> headroom(layouts.size(), 0);
    std::map<int, double> groups;
    for (std::size_t i = 0; i < layouts.size(); ++i) {
      if (layouts[i].legend.hidden > 0) {
        const double width = free_for_legend(figure_.panels[i], layouts[i].frame).width;
        headroom[i] = flattest_legend_height(context_, figure_.panels[i].curves, width) + 2 * style::kGap;
      }
      double& group = groups[figure_.panels[i].y_group];
      group = std::max(group, headroom[i]);
    }
    for (std::size_t i = 0; i < layouts.size(); ++i) {
      if (figure_.panels[i].y_group >= 0) headroom[i] = groups[figure_.panels[i].y_group];
    }
    return headroom;
  }

 private:
  void set_vertical(const Panel& panel, const PanelRange& range, double headroom, PanelLayout& layout) const {
    layout.has_data = !range.x.empty();
    layout.x_limits = axis_limits(panel.x, range.x, 0);
    layout.y_limits = axis_limits(panel.y, range.y, style::kCurveMargin);
    layout.y_limits = with_headroom(layout.y_limits, frame_height_, phase_strip(panel) + headroom);
    layout.y_ticks = axis_ticks(panel.y, layout.y_limits, intervals(frame_height_, style::kTickSpacingY));
  }

  void set_horizontal(const std::vector<Gutter>& gutters, std::vector<PanelLayout>& layouts) const {
    double free_width = area_.width;
    for (const Gutter& gutter : gutters) free_width -= gutter.width() + style::kRightMargin;
    const double frame_width = std::max(free_width / static_cast<double>(columns_), 10.0);
    double left = area_.x;
    for (std::size_t column = 0; column < columns_; ++column) {
      left += gutters[column].width();
      for (std::size_t i = column; i < layouts.size(); i += columns_) {
        const std::size_t row = i / columns_;
        const double top = area_.y + static_cast<double>(row) * cell_height_ + above_;
        layouts[i].frame = {left, top, frame_width, frame_height_};
        layouts[i].y_title_baseline = left - gutters[column].title_baseline();
        const int count = intervals(frame_width, style::kTickSpacingX);
        layouts[i].x_ticks = axis_ticks(figure_.panels[i].x, layouts[i].x_limits, count);
      }
      left += frame_width + style::kRightMargin;
    }
  }

  // The part of the frame clear of ticks and phase labels.
  static PlotBox free_for_legend(const Panel& panel, const PlotBox& frame) {
    const double inset = style::kMajorTick + 1;
    const double top = panel.phases.empty() ? inset : style::kPhaseStrip + 2;
    return {frame.x + inset, frame.y + top, frame.width - 2 * inset, frame.height - top - inset};
  }

  LegendPlace legend_place(const Panel& panel, const PanelLayout& layout) const {
    std::vector<Polyline> lines;
    for (const Curve& curve : panel.curves) {
      for (const Polyline& line : map_curve(curve.x, curve.y, layout.map())) lines.push_back(decimate(line, 1));
    }
    return place_legend(context_, panel.curves, lines, free_for_legend(panel, layout.frame));
  }

  const Figure& figure_;
  cairo_t* context_;
  const PlotBox area_;
  const std::vector<PanelRange> ranges_;
  const std::size_t columns_ = static_cast<std::size_t>(std::max(figure_.columns, 1));
  const double above_ = title_row_height(figure_);
  double cell_height_ = 0;
  double frame_height_ = 0;
};

}  // namespace

PaperMap PanelLayout::map() const {
  const double x_scale = frame.width / x_limits.span();
  const double y_scale = -frame.height / y_limits.span();
  return {frame.x - x_scale * x_limits.low, x_scale, frame.bottom() - y_scale * y_limits.low, y_scale};
}

std::vector<PanelLayout> lay_out_panels(const Figure& figure, cairo_t* context, const PlotBox& area) {
  const GridLayout grid(figure, context, area);
  const std::vector<PanelLayout> tight = grid.lay_out(std::vector<double>(figure.panels.size(), 0));
  return grid.lay_out(grid.headroom_for_legends(tight));
}

}  // namespace netpocket
