#pragma once
// A panel's legend, put where it hides as little of the curves as possible.

#include <cairo.h>

#include <vector>

#include "render/figures/figure.h"
#include "render/figures/polyline.h"

namespace netpocket {

// Draws the entries of the labelled curves inside `free`, the part of the frame open to a legend. `lines` is what the
// curves look like on paper. Nothing is drawn when no curve has a label.
void draw_legend(cairo_t* context, const std::vector<Curve>& curves, const std::vector<Polyline>& lines,
                 const Box& free);

// The line style and marker of a curve, for curves and legend keys alike.
void stroke_line(cairo_t* context, const Curve& curve, const Polyline& line);
void draw_marker(cairo_t* context, const Curve& curve, const Point& centre);

}  // namespace netpocket
