#pragma once
// Stretches of time of a figure whose x axis is time, and values at a time.

#include <optional>

#include "render/figures/figure.h"

namespace netpocket {

struct TimeRange {
  double begin = 0;  // s
  double end = 0;    // s

  double length() const { return end - begin; }
  bool operator==(const TimeRange&) const = default;
};

// From the first to the last time of all curves; empty without data.
std::optional<TimeRange> time_range(const Figure& figure);

// The figure cut to a range of time. Curves are interpolated at its ends, so that the axes show exactly the range.
Figure cut(const Figure& figure, const TimeRange& range);

// All panels show this range of time, also those whose curves end before.
void share_time(Figure& figure, const TimeRange& range);

// The curve's value, linear between points; empty outside its points and next to a gap.
std::optional<double> value_at(const Curve& curve, double time);

}  // namespace netpocket
