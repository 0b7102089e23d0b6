#pragma once
// The distribution of a sample: its quantiles with intervals that need no assumption on the distribution, and how far
// it is from a given distribution. Immutable: any thread may use it.

#include <cstdint>
#include <functional>
#include <vector>

#include "engine/statistics/interval.h"

namespace netpocket {

// One of the values of a sample, and the interval of the true quantile between two others. An end is infinite where the
// sample is too small to bound the quantile on that side.
struct QuantileEstimate {
  double value = 0;
  Interval interval;
};

class EmpiricalDistribution {
 public:
  // At least one value, none of them NaN.
  explicit EmpiricalDistribution(std::vector<double> values);

  const std::vector<double>& sorted() const { return sorted_; }
  // Share of the values that are at most x.
  double cumulative(double x) const;
  // The smallest value that at least the share `fraction` (0 to 1) of the values does not exceed.
  double quantile(double fraction) const;
  // The same with an interval whose ends are order statistics: each lies beyond the true quantile with a probability of
  // at most (1 - confidence)/2, by the binomial distribution of the number of values below it. David & Nagaraja (2003),
  // Order Statistics, section 7.1, doi:10.1002/0471722162.
  QuantileEstimate quantile_estimate(double fraction, double confidence) const;

 private:
  double order_statistic(std::int64_t rank) const;  // 1: the smallest; infinite outside 1 to size

  std::vector<double> sorted_;
};

// Kolmogorov's statistic: the largest difference between the sample's and a given cumulative distribution, which must
// be continuous.
double kolmogorov_smirnov_statistic(const EmpiricalDistribution& sample,
                                    const std::function<double(double)>& cumulative);

// Probability of a statistic of at least `statistic` if `size` values do come from the given distribution: Stephens
// (1970), J. R. Stat. Soc. B 32(1), doi:10.1111/j.2517-6161.1970.tb00821.x. Within 1e-3 or so for size >= 5 and results
// below 0.2.
double kolmogorov_smirnov_probability(double statistic, std::size_t size);

}  // namespace netpocket
