#pragma once
// Curves as points on paper.

#include <vector>

namespace netpocket {

struct Point {
  double x = 0;
  double y = 0;

  bool operator==(const Point&) const = default;
};

// Rectangle on paper; y grows downwards.
struct PlotBox {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;

  double right() const { return x + width; }
  double bottom() const { return y + height; }
};

using Polyline = std::vector<Point>;

// Linear map from data to paper: x to x_origin + x_scale x, likewise y.
struct PaperMap {
  double x_origin = 0;
  double x_scale = 1;
  double y_origin = 0;
  double y_scale = 1;

  Point operator()(double x, double y) const { return {x_origin + x_scale * x, y_origin + y_scale * y}; }
};

// The curve on paper, split where a value is not finite.
std::vector<Polyline> map_curve(const std::vector<double>& x, const std::vector<double>& y, const PaperMap& map);

// Length of the part of the line that lies inside the box.
double length_inside(const Polyline& line, const PlotBox& box);

// Keeps the first, lowest, highest and last of consecutive points in one column of the given width. A line through them
// looks the same when a column is a quarter of a pixel wide (one pixel changes the edges of dense curves).
Polyline decimate(const Polyline& line, double column_width);

}  // namespace netpocket
