#pragma once
// Where the parts of a panel go: limits, ticks, the frame and the legend.

#include <cairo.h>

#include <vector>

#include "render/figures/axis_ticks.h"
#include "render/figures/figure.h"
#include "render/figures/legend.h"
#include "render/figures/polyline.h"

namespace netpocket {

struct PanelLayout {
  PlotBox frame;
  AxisLimits x_limits;
  AxisLimits y_limits;
  AxisTicks x_ticks;
  AxisTicks y_ticks;
  double y_title_baseline = 0;  // x of the upward axis title, the same for a column of panels
  LegendPlace legend;
  bool has_data = false;

  PaperMap map() const;
};

// The frames of all panels, aligned in rows and columns, with limits and ticks that suit their size. A legend that
// would hide a curve gets room of its own above the curves.
std::vector<PanelLayout> lay_out_panels(const Figure& figure, cairo_t* context, const PlotBox& area);

}  // namespace netpocket
