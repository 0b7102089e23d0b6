#pragma once
// Limits and ticks of an axis: round numbers, and labels short enough to read. Follows Heckbert, "Nice numbers for
// graph labels" (Graphics Gems, 1990), with steps of 1, 2 and 5.

#include <string>
#include <vector>

namespace netpocket {

struct AxisLimits {
  double low = 0;
  double high = 1;

  double span() const { return high - low; }
  bool operator==(const AxisLimits&) const = default;
};

struct AxisTicks {
  std::vector<double> major;        // data units, within the limits
  std::vector<double> minor;        // between the major ones
  std::vector<std::string> labels;  // one per major tick: (value - offset) / 10^exponent
  double offset = 0;                // not 0 when the values differ only in far digits
  int exponent = 0;                 // not 0 when the values are small or large
  std::string multiplier;  // rich text to put at the axis, e.g. "×10^{−3}", or "×10^{−5} + 7.5"; else empty
};

// Smallest of 1, 2, 5 times a power of ten that divides the span into at most `intervals` parts.
double nice_step(double span, int intervals);

// Widens [low, high] by a fraction of its span at either end, to at least `minimum_span`, and to something that can be
// drawn when low equals high. What is nothing but 0 has no scale: it gets [-1, 1].
AxisLimits padded_limits(double low, double high, double margin, double minimum_span);

// No two ticks are nearer than `least_step`, which is 1, 2 or 5 times a power of ten, or 0.
AxisTicks make_ticks(const AxisLimits& limits, int intervals, double least_step = 0);

// Fixed number of decimals, a typographic minus sign (U+2212), never "−0".
std::string number_text(double value, int decimals);

}  // namespace netpocket
