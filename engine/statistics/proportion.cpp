#include "engine/statistics/proportion.h"

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>

#include "engine/sampling/normal.h"
#include "engine/statistics/boost_policy.h"

namespace netpocket {
namespace {

// The x at which the regularised incomplete beta function is `probability`.
double beta_quantile(double a, double b, double probability) {
  return boost::math::ibeta_inv(a, b, probability, BoostPolicy());
}

}  // namespace

Interval clopper_pearson_interval(std::int64_t successes, std::int64_t trials, double confidence) {
  const auto k = static_cast<double>(successes), n = static_cast<double>(trials);
  const double tail = (1 - confidence) / 2;
  return {successes == 0 ? 0 : beta_quantile(k, n - k + 1, tail),
          successes == trials ? 1 : beta_quantile(k + 1, n - k, 1 - tail)};
}

Interval wilson_interval(std::int64_t successes, std::int64_t trials, double confidence) {
  const auto k = static_cast<double>(successes), n = static_cast<double>(trials);
  const double z = normal_quantile((1 + confidence) / 2);
  const double share = k / n, weight = 1 + z * z / n;
  const double centre = (share + z * z / (2 * n)) / weight;
  const double half = z / weight * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
  return {std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

bool is_narrow_enough(std::int64_t successes, std::int64_t trials, double confidence, double half_width) {
  return trials >= kFewestTrials && clopper_pearson_interval(successes, trials, confidence).half_width() <= half_width;
}

std::int64_t most_trials_needed(double confidence, double half_width) {
  const auto suffices = [&](std::int64_t trials) {
    return is_narrow_enough(trials / 2, trials, confidence, half_width);
  };
  std::int64_t enough = kFewestTrials;
  while (!suffices(enough)) enough *= 2;
  std::int64_t too_few = enough / 2;
  while (enough - too_few > 1) {
    const std::int64_t middle = too_few + (enough - too_few) / 2;
    (suffices(middle) ? enough : too_few) = middle;
  }
  return enough;
}

}  // namespace netpocket
