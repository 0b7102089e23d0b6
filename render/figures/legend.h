#pragma once
// A panel's legend, put where it hides as little of the curves as possible.

#include <cairo.h>

#include <vector>

#include "render/figures/figure.h"
#include "render/figures/polyline.h"

namespace netpocket {

// Where a legend goes, and how its entries are arranged.
struct LegendPlace {
  PlotBox box;
  std::size_t columns = 1;
  double hidden = 0;  // points of curve behind the legend

  bool empty() const { return box.width <= 0; }
};

// The best place inside `free`, the part of a frame open to a legend, for the labelled curves. `lines` is what the
// curves look like on paper. Empty when no curve has a label.
LegendPlace place_legend(cairo_t* context, const std::vector<Curve>& curves, const std::vector<Polyline>& lines,
                         const PlotBox& free);

// Height of the legend with as many columns as the width allows.
double flattest_legend_height(cairo_t* context, const std::vector<Curve>& curves, double width);

void draw_legend(cairo_t* context, const std::vector<Curve>& curves, const LegendPlace& place);

}  // namespace netpocket
