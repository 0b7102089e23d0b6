#include "engine/statistics/sobol_indices.h"

#include <cmath>
#include <limits>

#include "engine/sampling/design.h"
#include "engine/sampling/random.h"
#include "engine/statistics/empirical_distribution.h"

namespace netpocket {
namespace {

// Outputs of the blocks, one column each: at a, at b, and at a with each input from b.
Eigen::MatrixXd whole_blocks(int dimensions, const Eigen::VectorXd& outputs) {
  const Eigen::Index length = dimensions + 2;
  Eigen::MatrixXd blocks = Eigen::Map<const Eigen::MatrixXd>(outputs.data(), length, outputs.size() / length);
  Eigen::Index kept = 0;
  for (Eigen::Index i = 0; i < blocks.cols(); ++i) {
    if (blocks.col(i).allFinite()) blocks.col(kept++) = blocks.col(i).eval();
  }
  return blocks.leftCols(kept);
}

struct IndexValues {
  Eigen::VectorXd first, total;  // by input
};

IndexValues index_values(const Eigen::MatrixXd& blocks) {
  const Eigen::Index dimensions = blocks.rows() - 2;
  const Eigen::ArrayXd a = blocks.row(0).array(), b = blocks.row(1).array();
  const double mean = (a.mean() + b.mean()) / 2;
  const double variance = ((a - mean).square().mean() + (b - mean).square().mean()) / 2;
  IndexValues values{Eigen::VectorXd(dimensions), Eigen::VectorXd(dimensions)};
  for (Eigen::Index i = 0; i < dimensions; ++i) {
    const Eigen::ArrayXd mixed = blocks.row(i + 2).array();
    // The mean is taken out, because the estimate's error grows with it.
    values.first[i] = ((b - mean) * (mixed - a)).mean() / variance;
    values.total[i] = (a - mixed).square().mean() / (2 * variance);
  }
  return values;
}

Eigen::MatrixXd resampled(const Eigen::MatrixXd& blocks, RandomSequence& random) {
  Eigen::MatrixXd sample(blocks.rows(), blocks.cols());
  for (Eigen::Index i = 0; i < blocks.cols(); ++i) {
    sample.col(i) = blocks.col(random.below(static_cast<std::uint32_t>(blocks.cols())));
  }
  return sample;
}

// Samples whose output did not vary have no indices.
Interval percentile_interval(std::vector<double> values, double confidence) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  const EmpiricalDistribution distribution(std::move(values));
  return {distribution.quantile((1 - confidence) / 2), distribution.quantile((1 + confidence) / 2)};
}

}  // namespace

Eigen::MatrixXd variance_points(int dimensions, int blocks, std::uint64_t seed) {
  const Design design(DesignKind::sobol, 2 * dimensions, static_cast<std::uint64_t>(blocks), seed);
  const Eigen::Index length = dimensions + 2;
  Eigen::MatrixXd points(dimensions, length * blocks);
  for (Eigen::Index block = 0; block < blocks; ++block) {
    const Eigen::VectorXd both = design.point(static_cast<std::uint64_t>(block));
    const Eigen::VectorXd a = both.head(dimensions), b = both.tail(dimensions);
    points.col(length * block) = a;
    points.col(length * block + 1) = b;
    for (Eigen::Index i = 0; i < dimensions; ++i) {
      points.col(length * block + 2 + i) = a;
      points(i, length * block + 2 + i) = b[i];
    }
  }
  return points;
}

std::vector<SobolIndices> sobol_indices(int dimensions, const Eigen::VectorXd& outputs, double confidence,
                                        int resamples, std::uint64_t seed) {
  const Eigen::MatrixXd blocks = whole_blocks(dimensions, outputs);
  const IndexValues values = index_values(blocks);
  std::vector<std::vector<double>> first(static_cast<std::size_t>(dimensions)), total = first;
  RandomSequence random(seed);
  for (int i = 0; i < resamples; ++i) {
    const IndexValues drawn = index_values(resampled(blocks, random));
    for (std::size_t input = 0; input < first.size(); ++input) {
      first[input].push_back(drawn.first[static_cast<Eigen::Index>(input)]);
      total[input].push_back(drawn.total[static_cast<Eigen::Index>(input)]);
    }
  }
  std::vector<SobolIndices> indices(first.size());
  for (std::size_t input = 0; input < indices.size(); ++input) {
    const auto i = static_cast<Eigen::Index>(input);
    indices[input] = {{values.first[i], percentile_interval(first[input], confidence)},
                      {values.total[i], percentile_interval(total[input], confidence)}};
  }
  return indices;
}

}  // namespace netpocket
