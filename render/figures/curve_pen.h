#pragma once
// Draws with a curve's colour, width, dash and marker: curves and legend keys alike.

#include <cairo.h>

#include "render/figures/figure.h"
#include "render/figures/polyline.h"

namespace netpocket {

// A line of one point is drawn as a dot.
void stroke_line(cairo_t* context, const Curve& curve, const Polyline& line);

// A small ring.
void draw_marker(cairo_t* context, const Curve& curve, const Point& centre);

}  // namespace netpocket
