#include "engine/statistics/screening.h"

#include <cmath>
#include <numeric>
#include <utility>

#include "engine/sampling/random.h"

namespace netpocket {
namespace {

constexpr double kStep = 0.5;

std::vector<int> shuffled(int count, RandomSequence& random) {
  std::vector<int> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
  }
  return order;
}

// The input that changes between two points.
Eigen::Index changed_input(const Eigen::MatrixXd& points, Eigen::Index before) {
  Eigen::Index input = 0;
  (points.col(before + 1) - points.col(before)).cwiseAbs().maxCoeff(&input);
  return input;
}

InputEffect summarised(const std::vector<double>& effects) {
  InputEffect result;
  result.steps = static_cast<int>(effects.size());
  for (const double effect : effects) {
    result.mean += effect / result.steps;
    result.mean_absolute += std::abs(effect) / result.steps;
  }
  if (result.steps < 2) return result;
  for (const double effect : effects) result.deviation += (effect - result.mean) * (effect - result.mean);
  result.deviation = std::sqrt(result.deviation / (result.steps - 1));
  return result;
}

}  // namespace

Eigen::MatrixXd screening_points(int dimensions, int trajectories, int levels, std::uint64_t seed) {
  const int length = dimensions + 1;
  Eigen::MatrixXd points(dimensions, static_cast<Eigen::Index>(trajectories) * length);
  for (int t = 0; t < trajectories; ++t) {
    RandomSequence random(seed, static_cast<std::uint64_t>(t));
    Eigen::VectorXd point(dimensions);
    for (double& u : point) u = (random.below(static_cast<std::uint32_t>(levels)) + 0.5) / levels;
    const Eigen::Index first = static_cast<Eigen::Index>(t) * length;
    points.col(first) = point;
    const std::vector<int> order = shuffled(dimensions, random);
    for (int i = 0; i < dimensions; ++i) {
      double& u = point[order[static_cast<std::size_t>(i)]];
      u += u < kStep ? kStep : -kStep;
      points.col(first + i + 1) = point;
    }
  }
  return points;
}

std::vector<InputEffect> screening_effects(const Eigen::MatrixXd& points, const Eigen::VectorXd& outputs) {
  const Eigen::Index dimensions = points.rows();
  std::vector<std::vector<double>> effects(static_cast<std::size_t>(dimensions));
  for (Eigen::Index i = 0; i + 1 < points.cols(); ++i) {
    if ((i + 1) % (dimensions + 1) == 0) continue;  // from one walk to the next
    const Eigen::Index input = changed_input(points, i);
    const double effect = (outputs[i + 1] - outputs[i]) / (points(input, i + 1) - points(input, i));
    if (std::isfinite(effect)) effects[static_cast<std::size_t>(input)].push_back(effect);
  }
  std::vector<InputEffect> results;
  for (const std::vector<double>& list : effects) results.push_back(summarised(list));
  return results;
}

}  // namespace netpocket
