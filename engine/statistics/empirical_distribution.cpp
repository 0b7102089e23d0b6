#include "engine/statistics/empirical_distribution.h"

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "engine/statistics/boost_policy.h"

namespace netpocket {
namespace {

// Probability that at least `successes` of `trials` trials succeed.
double binomial_tail(std::int64_t successes, std::int64_t trials, double probability) {
  if (successes <= 0) return 1;
  if (successes > trials) return 0;
  return boost::math::ibeta(static_cast<double>(successes), static_cast<double>(trials - successes + 1), probability,
                            BoostPolicy());
}

}  // namespace

EmpiricalDistribution::EmpiricalDistribution(std::vector<double> values) : sorted_(std::move(values)) {
  std::ranges::sort(sorted_);
}

double EmpiricalDistribution::cumulative(double x) const {
  const auto above = std::ranges::upper_bound(sorted_, x);
  return static_cast<double>(above - sorted_.begin()) / static_cast<double>(sorted_.size());
}

double EmpiricalDistribution::quantile(double fraction) const {
  // A share such as 0.95 x 20 = 19.000000000000004 means 19.
  constexpr double kRoundOff = 1e-9;
  const double rank = std::ceil(fraction * static_cast<double>(sorted_.size()) - kRoundOff);
  return sorted_[static_cast<std::size_t>(std::clamp(rank - 1, 0.0, static_cast<double>(sorted_.size() - 1)))];
}

double EmpiricalDistribution::order_statistic(std::int64_t rank) const {
  if (rank < 1) return -std::numeric_limits<double>::infinity();
  if (rank > static_cast<std::int64_t>(sorted_.size())) return std::numeric_limits<double>::infinity();
  return sorted_[static_cast<std::size_t>(rank - 1)];
}

QuantileEstimate EmpiricalDistribution::quantile_estimate(double fraction, double confidence) const {
  const auto size = static_cast<std::int64_t>(sorted_.size());
  const double tail = (1 - confidence) / 2;
  // The value of rank r exceeds the quantile if fewer than r values lie below the quantile, and lies below it if at
  // least r do.
  const auto may_exceed = [&](std::int64_t rank) { return 1 - binomial_tail(rank, size, fraction) > tail; };
  const auto may_lie_below = [&](std::int64_t rank) { return binomial_tail(rank, size, fraction) > tail; };
  // Both change once as the rank grows.
  const auto first = [&](const auto& holds) {
    std::int64_t low = 0, high = size + 1;  // it holds from a rank in (low, high] on
    while (high - low > 1) {
      const std::int64_t middle = low + (high - low) / 2;
      (holds(middle) ? high : low) = middle;
    }
    return high;
  };
  const std::int64_t lower = first(may_exceed) - 1;
  const std::int64_t upper = first([&](std::int64_t rank) { return !may_lie_below(rank); });
  return {quantile(fraction), {order_statistic(lower), order_statistic(upper)}};
}

double kolmogorov_smirnov_statistic(const EmpiricalDistribution& sample,
                                    const std::function<double(double)>& cumulative) {
  const std::vector<double>& sorted = sample.sorted();
  const auto size = static_cast<double>(sorted.size());
  double largest = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double expected = cumulative(sorted[i]), before = static_cast<double>(i) / size;
    largest = std::max({largest, expected - before, before + 1 / size - expected});
  }
  return largest;
}

double kolmogorov_smirnov_probability(double statistic, std::size_t size) {
  const double root = std::sqrt(static_cast<double>(size));
  const double x = (root + 0.12 + 0.11 / root) * statistic;
  // Kolmogorov's series converges too slowly below 0.2, where the probability is 1 to twelve digits.
  if (x < 0.2) return 1;
  double sum = 0;
  for (int k = 1; k <= 100; ++k) sum += (k % 2 == 1 ? 2 : -2) * std::exp(-2 * k * k * x * x);
  return std::clamp(sum, 0.0, 1.0);
}

}  // namespace netpocket
