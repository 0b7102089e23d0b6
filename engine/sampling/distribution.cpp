#include "engine/sampling/distribution.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/math/power.h"
#include "engine/sampling/normal.h"

namespace netpocket {
namespace {

// Below it the quantile of a truncated normal distribution would lose its accuracy.
constexpr double kLeastTruncatedShare = 1e-290;

// Truncation bounds in standard deviations. If both lie above the mean they are mirrored, because the cumulative
// distribution keeps its relative accuracy only below the mean.
struct Truncation {
  double low, high;  // cumulative distribution at the bounds
  bool is_mirrored;

  explicit Truncation(const TruncatedNormal& d) {
    const double from = (d.min - d.mean) / d.deviation, to = (d.max - d.mean) / d.deviation;
    is_mirrored = from > 0;
    low = normal_cumulative(is_mirrored ? -to : from);
    high = normal_cumulative(is_mirrored ? -from : to);
  }
};

bool all_finite(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

std::string fault_of_numbers(std::initializer_list<double> numbers) {
  return all_finite(numbers) ? "" : "has a number that is not finite";
}

std::string fault_of_deviation(double deviation) {
  return deviation > 0 ? "" : fmt::format("needs a deviation > 0, not {:g}", deviation);
}

std::string fault_of_range(double min, double max) {
  return min < max ? "" : fmt::format("needs a min below its max, not {:g} and {:g}", min, max);
}

// The first that is not empty.
std::string first_of(std::initializer_list<std::string> faults) {
  for (const std::string& fault : faults) {
    if (!fault.empty()) return fault;
  }
  return "";
}

std::string fault_of(const Normal& d) {
  return first_of({fault_of_numbers({d.mean, d.deviation}), fault_of_deviation(d.deviation)});
}

std::string fault_of(const TruncatedNormal& d) {
  const std::string fault = first_of({fault_of_numbers({d.mean, d.deviation, d.min, d.max}),
                                      fault_of_deviation(d.deviation), fault_of_range(d.min, d.max)});
  if (!fault.empty()) return fault;
  const Truncation t(d);
  if (t.high - t.low >= kLeastTruncatedShare) return "";
  return fmt::format("is cut to {:g} to {:g}, too far from its mean {:g} for its deviation {:g}", d.min, d.max, d.mean,
                     d.deviation);
}

std::string fault_of(const Uniform& d) {
  return first_of({fault_of_numbers({d.min, d.max}), fault_of_range(d.min, d.max)});
}

std::string fault_of(const LogNormal& d) {
  const std::string median = d.median > 0 ? "" : fmt::format("needs a median > 0, not {:g}", d.median);
  return first_of({fault_of_numbers({d.median, d.log_deviation}), median, fault_of_deviation(d.log_deviation)});
}

std::string fault_of(const Triangular& d) {
  const bool is_within = d.min <= d.mode && d.mode <= d.max;
  return first_of({fault_of_numbers({d.min, d.mode, d.max}), fault_of_range(d.min, d.max),
                   is_within ? "" : fmt::format("needs a mode from {:g} to {:g}, not {:g}", d.min, d.max, d.mode)});
}

std::string fault_of(const Discrete& d) {
  if (d.values.empty()) return "needs at least one value";
  if (!all_finite(d.values) || !all_finite(d.weights)) return "has a number that is not finite";
  if (d.weights.empty()) return "";
  if (d.weights.size() != d.values.size()) {
    return fmt::format("needs as many weights as values, not {} and {}", d.weights.size(), d.values.size());
  }
  if (std::ranges::any_of(d.weights, [](double weight) { return weight < 0; })) return "has a weight below 0";
  const double sum = std::accumulate(d.weights.begin(), d.weights.end(), 0.0);
  return sum > 0 && std::isfinite(sum) ? "" : "needs weights with a finite sum above 0";
}

std::string fault_of(const Samples& d) { return fault_of(Discrete{d.values, {}}); }

// A value and the share of draws that are at most it.
struct Step {
  double value, share;
};

// In increasing order of the values.
std::vector<Step> steps_of(const Discrete& d) {
  std::vector<Step> steps(d.values.size());
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = {d.values[i], d.weights.empty() ? 1 : d.weights[i]};
  std::ranges::stable_sort(steps, {}, &Step::value);
  for (std::size_t i = 1; i < steps.size(); ++i) steps[i].share += steps[i - 1].share;
  const double total = steps.back().share;
  for (Step& step : steps) step.share /= total;
  return steps;
}

double value_at(const Normal& d, double u) { return d.mean + d.deviation * normal_quantile(u); }

double value_at(const TruncatedNormal& d, double u) {
  const Truncation t(d);
  const double share = t.is_mirrored ? t.high - u * (t.high - t.low) : t.low + u * (t.high - t.low);
  const double z = normal_quantile(share);
  return std::clamp(d.mean + d.deviation * (t.is_mirrored ? -z : z), d.min, d.max);
}

// This form cannot overflow and reaches both ends.
double value_at(const Uniform& d, double u) { return (1 - u) * d.min + u * d.max; }

double value_at(const LogNormal& d, double u) {
  return d.median * power(std::numbers::e, d.log_deviation * normal_quantile(u));
}

double value_at(const Triangular& d, double u) {
  const double width = d.max - d.min, left = d.mode - d.min;
  if (u * width < left) return d.min + std::sqrt(u * width * left);
  return d.max - std::sqrt((1 - u) * width * (d.max - d.mode));
}

double value_at(const Discrete& d, double u) {
  const std::vector<Step> steps = steps_of(d);
  return std::ranges::lower_bound(steps, u, {}, &Step::share)->value;
}

double value_at(const Samples& d, double u) { return value_at(Discrete{d.values, {}}, u); }

double share_below(const Normal& d, double x) { return normal_cumulative((x - d.mean) / d.deviation); }

double share_below(const TruncatedNormal& d, double x) {
  if (x <= d.min) return 0;
  if (x >= d.max) return 1;
  const Truncation t(d);
  const double z = (x - d.mean) / d.deviation;
  if (t.is_mirrored) return (t.high - normal_cumulative(-z)) / (t.high - t.low);
  return (normal_cumulative(z) - t.low) / (t.high - t.low);
}

double share_below(const Uniform& d, double x) { return std::clamp((x - d.min) / (d.max - d.min), 0.0, 1.0); }

double share_below(const LogNormal& d, double x) {
  return x <= 0 ? 0 : normal_cumulative(logarithm(x / d.median) / d.log_deviation);
}

double share_below(const Triangular& d, double x) {
  if (x <= d.min) return 0;
  if (x >= d.max) return 1;
  const double width = d.max - d.min;
  if (x < d.mode) return (x - d.min) * (x - d.min) / (width * (d.mode - d.min));
  return 1 - (d.max - x) * (d.max - x) / (width * (d.max - d.mode));
}

double share_below(const Discrete& d, double x) {
  double share = 0;
  for (const Step& step : steps_of(d)) {
    if (step.value <= x) share = step.share;
  }
  return share;
}

double share_below(const Samples& d, double x) { return share_below(Discrete{d.values, {}}, x); }

}  // namespace

std::string find_fault(const Distribution& distribution) {
  return std::visit([](const auto& d) { return fault_of(d); }, distribution);
}

double quantile(const Distribution& distribution, double fraction) {
  constexpr double kLeast = 0x1p-53;
  const double inner = std::clamp(fraction, kLeast, 1 - kLeast);
  return std::visit([inner](const auto& d) { return value_at(d, inner); }, distribution);
}

double cumulative(const Distribution& distribution, double x) {
  return std::visit([x](const auto& d) { return share_below(d, x); }, distribution);
}

}  // namespace netpocket
