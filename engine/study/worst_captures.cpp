#include "engine/study/worst_captures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/statistics/empirical_distribution.h"

namespace netpocket {
namespace {

// The rows with the least keys; keys that are no number count as infinite.
std::vector<std::size_t> least(const std::vector<double>& keys, std::size_t count) {
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&keys](std::size_t row) { return std::isnan(keys[row]) ? INFINITY : keys[row]; };
  std::ranges::stable_sort(order, {}, key);
  order.resize(std::min(order.size(), count));
  return order;
}

}  // namespace

std::vector<std::size_t> worst_captures(const StudyResults& results, const CaptureRanking& ranking, std::size_t count) {
  const ResultColumn* column = results.find(ranking.by);
  if (column == nullptr) return {};
  std::vector<double> keys = column->values;
  if (ranking.largest_is_worst) {
    for (double& key : keys) key = -key;
  }
  return least(keys, count);
}

std::vector<std::size_t> typical_captures(const StudyResults& results, const std::string& by, std::size_t count) {
  const ResultColumn* column = results.find(by);
  if (column == nullptr) return {};
  std::vector<double> captured;
  for (std::size_t row = 0; row < results.size(); ++row) {
    if (results.captured[row] == 1 && std::isfinite(column->values[row])) captured.push_back(column->values[row]);
  }
  if (captured.empty()) return {};
  const double median = EmpiricalDistribution(captured).quantile(0.5);
  std::vector<double> distances(results.size(), INFINITY);
  for (std::size_t row = 0; row < results.size(); ++row) {
    if (results.captured[row] == 1) distances[row] = std::abs(column->values[row] - median);
  }
  return least(distances, std::min(count, captured.size()));
}

}  // namespace netpocket
