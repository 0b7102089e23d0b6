#include "engine/analysis/metrics/cord_utilisation.h"

#include <algorithm>
#include <limits>

#include "engine/statistics/empirical_distribution.h"

namespace netpocket {

CordUtilisation::CordUtilisation(const Structure& structure, const std::vector<double>& strengths) {
  for (const StructureElement& element : structure.elements) {
    const auto group = static_cast<std::size_t>(element.group);
    strengths_.push_back(group < strengths.size() ? strengths[group] : 0);
  }
  largest_.resize(strengths_.size());
}

void CordUtilisation::add(const Snapshot& snapshot) {
  for (std::size_t i = 0; i < strengths_.size(); ++i) {
    if (!(strengths_[i] > 0)) continue;
    largest_[i] = std::max(largest_[i], snapshot.tension[static_cast<Eigen::Index>(i)] / strengths_[i]);
  }
}

double CordUtilisation::peak() const {
  double peak = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < strengths_.size(); ++i) {
    if (strengths_[i] > 0 && !(peak >= largest_[i])) peak = largest_[i];
  }
  return peak;
}

double CordUtilisation::most_elements() const {
  std::vector<double> values;
  for (std::size_t i = 0; i < strengths_.size(); ++i) {
    if (strengths_[i] > 0) values.push_back(largest_[i]);
  }
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : EmpiricalDistribution(values).quantile(0.99);
}

}  // namespace netpocket
