#include "render/figures/curve_pen.h"

namespace netpocket {

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
  cairo_arc(context, centre.x, centre.y, radius, 0, 6.283185307179586);
  cairo_set_source_rgb(context, 1, 1, 1);
  cairo_fill_preserve(context);
  cairo_set_source_rgb(context, curve.colour.red, curve.colour.green, curve.colour.blue);
  cairo_set_line_width(context, 0.8);
  cairo_stroke(context);
}

}  // namespace netpocket
