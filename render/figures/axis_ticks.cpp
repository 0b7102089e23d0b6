#include "render/figures/axis_ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace netpocket {
namespace {

constexpr double kRoundOff = 1e-9;  // of a step: what counts as on a tick
constexpr int kMoreIntervals = 4;   // than there is room for, rather than one label
constexpr int kLongestLabel = 5;    // significant digits before an offset is split off

int decimal_exponent(double value) { return static_cast<int>(std::floor(std::log10(value) + kRoundOff)); }

// Leading digit (1, 2 or 5) of a nice step.
int leading_digit(double step) { return static_cast<int>(std::lround(step / std::pow(10.0, decimal_exponent(step)))); }

std::vector<double> multiples(double step, const AxisLimits& limits) {
  std::vector<double> values;
  const double slack = kRoundOff * step;
  const auto first = static_cast<long long>(std::ceil((limits.low - slack) / step));
  const auto last = static_cast<long long>(std::floor((limits.high + slack) / step));
  for (long long i = first; i <= last; ++i) values.push_back(static_cast<double>(i) * step);
  return values;
}

// What to take off labels that would need too many digits; 0 when they do not.
double label_offset(double step, const AxisLimits& limits) {
  const double largest = std::max(std::abs(limits.low), std::abs(limits.high));
  if (decimal_exponent(largest) - decimal_exponent(step) < kLongestLabel) return 0;
  const double unit = std::pow(10.0, decimal_exponent(limits.span()) + 2);
  return std::round((limits.low + limits.high) / 2 / unit) * unit;
}

int label_exponent(double largest) {
  if (largest <= 0) return 0;
  const int exponent = decimal_exponent(largest);
  return exponent <= -3 || exponent >= 4 ? exponent : 0;
}

int decimals_for(double step) { return std::max(0, -decimal_exponent(step)); }

std::string multiplier_text(int exponent, double offset) {
  std::string text;
  if (exponent != 0) text = fmt::format("×10^{{{}}}", number_text(exponent, 0));
  if (offset == 0) return text;
  const std::string size = fmt::format("{:.12g}", std::abs(offset));
  return text + (offset > 0 ? (text.empty() ? "+" : " + ") : (text.empty() ? "−" : " − ")) + size;
}

}  // namespace

double nice_step(double span, int intervals) {
  const double smallest = span / std::max(intervals, 1);
  const double power = std::pow(10.0, decimal_exponent(smallest));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= smallest * (1 - kRoundOff)) return factor * power;
  }
  return 10 * power;
}

AxisLimits padded_limits(double low, double high, double margin, double minimum_span) {
  const double size = std::max(std::abs(low), std::abs(high));
  const double middle = (low + high) / 2;
  const auto around_middle = [middle](double half) { return AxisLimits{middle - half, middle + half}; };
  const double round_off = 1e-12 * size;
  if (high - low <= std::max(minimum_span, round_off)) {
    if (size > 0 && minimum_span > round_off) return around_middle(minimum_span / 2);
    return around_middle(size > 0 ? 0.05 * size : 1.0);
  }
  const double pad = margin * (high - low);
  return {low - pad, high + pad};
}

AxisTicks make_ticks(const AxisLimits& limits, int intervals, double least_step) {
  AxisTicks ticks;
  double step = std::max(nice_step(limits.span(), intervals), least_step);
  ticks.major = multiples(step, limits);
  // One label alone tells no scale.
  for (int more = intervals + 1; ticks.major.size() < 2 && more <= intervals + kMoreIntervals; ++more) {
    step = std::max(nice_step(limits.span(), more), least_step);
    ticks.major = multiples(step, limits);
  }

  double minor_step = step / (leading_digit(step) == 2 ? 4 : 5);
  // Of steps of 2 and 5, and of what is ten times less, the least one is a part.
  if (minor_step < least_step * (1 - kRoundOff)) minor_step = least_step;
  for (const double value : multiples(minor_step, limits)) {
    const double position = value / step;
    if (std::abs(position - std::round(position)) > kRoundOff) ticks.minor.push_back(value);
  }

  ticks.offset = label_offset(step, limits);
  double largest = 0;
  for (const double value : ticks.major) largest = std::max(largest, std::abs(value - ticks.offset));
  ticks.exponent = label_exponent(largest);
  const double scale = std::pow(10.0, ticks.exponent);
  for (const double value : ticks.major) {
    ticks.labels.push_back(number_text((value - ticks.offset) / scale, decimals_for(step / scale)));
  }
  ticks.multiplier = multiplier_text(ticks.exponent, ticks.offset);
  return ticks;
}

std::string number_text(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", std::abs(value), decimals);
  const bool is_zero = text.find_first_not_of("0.") == std::string::npos;
  return value < 0 && !is_zero ? "−" + text : text;
}

}  // namespace netpocket
