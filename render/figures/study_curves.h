#pragma once
// What figures of studies are put together from. Pure functions: any thread may call them.

#include <limits>
#include <string>
#include <vector>

#include "engine/study/study_results.h"
#include "render/figures/figure.h"

namespace netpocket {

inline constexpr double kGapInCurve = std::numeric_limits<double>::quiet_NaN();

// "target.mass (kg)"
std::string axis_title(const ResultColumn& column);

Curve plain_line(FigureColour colour, double width = 0.9, const std::string& label = "");
// Points alone, as add_point() makes them.
Curve scatter(FigureColour colour, const std::string& label);
void add_point(Curve& curve, double x, double y);

Panel panel_of(const std::string& x_title, const std::string& y_title, std::vector<Curve> curves);

// Of the finite values of a column; the other way round without any.
struct ColumnRange {
  double from = std::numeric_limits<double>::infinity(), to = -std::numeric_limits<double>::infinity();

  double at(double fraction) const { return from + fraction * (to - from); }
  double fraction(double value) const { return to > from ? (value - from) / (to - from) : 0.5; }
};
ColumnRange range_of(const ResultColumn& column);

}  // namespace netpocket
