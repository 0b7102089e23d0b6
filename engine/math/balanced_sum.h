#pragma once
// Sums whose bits do not depend on the order of the terms, and in which equal and opposite terms cancel exactly. Terms
// of equal size are counted with their signs; then the sizes are added in ascending order. If the vectors are rotated
// by a quarter turn, their sum is rotated with them to the last bit.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

namespace netpocket {

// Sum of `terms`, which it sorts.
inline double balanced_sum(std::vector<double>& terms) {
  std::ranges::sort(terms, [](double a, double b) { return std::abs(a) < std::abs(b); });
  double sum = 0;
  for (std::size_t i = 0; i < terms.size();) {
    const double size = std::abs(terms[i]);
    double count = 0;
    std::size_t next = i;
    for (; next < terms.size() && std::abs(terms[next]) == size; ++next) count += terms[next] < 0 ? -1 : 1;
    sum += count * size;
    i = std::max(next, i + 1);  // NaN does not equal itself, but must enter the sum
    if (next < i) sum += size;
  }
  return sum;
}

// The same for each component of vectors.
inline Eigen::Vector3d balanced_sum(const std::vector<Eigen::Vector3d>& terms) {
  Eigen::Vector3d sum;
  std::vector<double> components(terms.size());
  for (int i = 0; i < 3; ++i) {
    std::ranges::transform(terms, components.begin(), [i](const Eigen::Vector3d& term) { return term[i]; });
    sum[i] = balanced_sum(components);
  }
  return sum;
}

}  // namespace netpocket
