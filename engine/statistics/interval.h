#pragma once
// A confidence interval.

namespace netpocket {

struct Interval {
  double lower = 0;
  double upper = 0;

  double half_width() const { return (upper - lower) / 2; }
  bool contains(double value) const { return lower <= value && value <= upper; }
};

}  // namespace netpocket
