#include "engine/statistics/subset_simulation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "engine/math/power.h"
#include "engine/sampling/normal.h"
#include "engine/sampling/random.h"

namespace netpocket {
namespace {

constexpr int kSharesPerLevel = 10;  // inverse of the conditional probability

struct Level {
  Eigen::MatrixXd points;  // chain by chain
  Eigen::VectorXd values;
  int chain_length = 1;
};

// Modified Metropolis: each component is proposed and accepted by itself, so that the rate of acceptance does not fall
// with the number of components. The proposal is uniform within 1 of the component.
Eigen::VectorXd proposed(const Eigen::VectorXd& from, RandomSequence& random) {
  Eigen::VectorXd point = from;
  for (double& x : point) {
    const double candidate = x + 2 * random.fraction() - 1;
    const double log_ratio = (x * x - candidate * candidate) / 2;
    if (log_ratio >= 0 || random.fraction() < power(std::numbers::e, log_ratio)) x = candidate;
  }
  return point;
}

std::vector<Eigen::Index> by_value(const Eigen::VectorXd& values) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(values.size()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](Eigen::Index i) { return values[i]; });
  return order;
}

// As many of the first `kept` as there are chains, evenly over all of them: of more points than chains each has the
// same chance, whatever its value.
std::vector<Eigen::Index> spread(const std::vector<Eigen::Index>& order, std::size_t kept, std::size_t chains) {
  std::vector<Eigen::Index> chosen;
  for (std::size_t i = 0; i < chains; ++i) chosen.push_back(order[i * kept / chains]);
  return chosen;
}

Level first_level(const BatchFunction& limit_state, int dimensions, int samples, RandomSequence& random) {
  Level level{Eigen::MatrixXd(dimensions, samples), {}};
  for (double& x : level.points.reshaped()) x = random.normal();
  level.values = limit_state(level.points);
  return level;
}

// Chains from the seeds, of kSharesPerLevel points each, all with values of at most `limit`.
Level next_level(const BatchFunction& limit_state, const Level& last, const std::vector<Eigen::Index>& seeds,
                 double limit, RandomSequence& random) {
  const auto chains = static_cast<Eigen::Index>(seeds.size());
  Level level{Eigen::MatrixXd(last.points.rows(), last.points.cols()), Eigen::VectorXd(last.points.cols()),
              kSharesPerLevel};
  Eigen::MatrixXd now = last.points(Eigen::all, seeds), candidates(now.rows(), chains);
  Eigen::VectorXd values = last.values(seeds);
  for (Eigen::Index step = 0; step < kSharesPerLevel; ++step) {
    if (step > 0) {
      for (Eigen::Index c = 0; c < chains; ++c) candidates.col(c) = proposed(now.col(c), random);
      const Eigen::VectorXd found = limit_state(candidates);
      for (Eigen::Index c = 0; c < chains; ++c) {
        if (found[c] > limit) continue;
        now.col(c) = candidates.col(c);
        values[c] = found[c];
      }
    }
    for (Eigen::Index c = 0; c < chains; ++c) {
      level.points.col(c * kSharesPerLevel + step) = now.col(c);
      level.values[c * kSharesPerLevel + step] = values[c];
    }
  }
  return level;
}

// Squared coefficient of variation of the share of values of at most `limit`. Points of a chain are correlated.
double squared_variation(const Level& level, double limit) {
  const auto count = static_cast<double>(level.values.size());
  const double share = static_cast<double>((level.values.array() <= limit).count()) / count;
  if (share == 0 || share == 1) return 0;
  double gamma = 0;
  const Eigen::Index length = level.chain_length, chains = level.values.size() / length;
  for (Eigen::Index lag = 1; lag < length; ++lag) {
    double both = 0;
    for (Eigen::Index c = 0; c < chains; ++c) {
      for (Eigen::Index i = 0; i + lag < length; ++i) {
        both += level.values[c * length + i] <= limit && level.values[c * length + i + lag] <= limit ? 1 : 0;
      }
    }
    const double covariance = both / static_cast<double>(chains * (length - lag)) - share * share;
    const double weight = 1 - static_cast<double>(lag) / static_cast<double>(length);
    gamma += 2 * weight * covariance / (share * (1 - share));
  }
  return (1 - share) / (share * count) * (1 + std::max(0.0, gamma));
}

}  // namespace

SubsetResult subset_simulation(const BatchFunction& limit_state, int dimensions, const SubsetOptions& options) {
  RandomSequence random(options.seed);
  Level level = first_level(limit_state, dimensions, options.samples, random);
  SubsetResult result{.probability = 1, .levels = 1, .evaluations = options.samples};
  double variation = 0;
  for (;; ++result.levels) {
    const std::vector<Eigen::Index> order = by_value(level.values);
    const std::size_t chains = order.size() / kSharesPerLevel;
    // As in Au & Beck, the limit lies between the values that are kept and the next one: here at the last that is kept.
    const double limit = std::max(0.0, level.values[order[chains - 1]]);
    const double squared = squared_variation(level, limit);
    variation += squared;
    result.most_variation += std::sqrt(squared);
    // More than a tenth where values are equal, as those of a metric can be.
    const auto kept = static_cast<std::size_t>((level.values.array() <= limit).count());
    result.probability *= static_cast<double>(kept) / options.samples;
    result.steps.push_back({limit, result.probability, result.most_variation});
    if (limit == 0 || result.levels == options.most_levels) {
      result.is_resolved = limit == 0;
      result.variation = std::sqrt(variation);
      return result;
    }
    level = next_level(limit_state, level, spread(order, kept, chains), limit, random);
    result.evaluations += static_cast<int>(chains) * (kSharesPerLevel - 1);
  }
}

Interval subset_interval(const SubsetResult& result, double confidence) {
  const double deviation = std::sqrt(logarithm(1 + result.most_variation * result.most_variation));
  const double factor = power(std::numbers::e, normal_quantile((1 + confidence) / 2) * deviation);
  return {result.is_resolved ? result.probability / factor : 0, std::min(1.0, result.probability * factor)};
}

}  // namespace netpocket
