#include "engine/sampling/design.h"

#include <algorithm>

#include "engine/sampling/halton_sequence.h"
#include "engine/sampling/permutation.h"
#include "engine/sampling/random.h"
#include "engine/sampling/sobol_sequence.h"

namespace netpocket {
namespace {

// Sequences are exact multiples of a small number and may be 0.
double inside(double coordinate) {
  constexpr double kLeast = 0x1p-53;
  return std::clamp(coordinate, kLeast, 1 - kLeast);
}

}  // namespace

Design::Design(DesignKind kind, int dimensions, std::uint64_t count, std::uint64_t seed)
    : kind_(kind), dimensions_(dimensions), count_(count), seed_(seed) {}

Eigen::VectorXd Design::point(std::uint64_t index) const {
  Eigen::VectorXd point(dimensions_);
  for (int axis = 0; axis < dimensions_; ++axis) point[axis] = inside(coordinate(index, axis));
  return point;
}

double Design::coordinate(std::uint64_t index, int axis) const {
  switch (kind_) {
    case DesignKind::monte_carlo:
      return random_fraction(seed_, index, static_cast<std::uint32_t>(axis));
    case DesignKind::latin_hypercube:
      return stratified(index, axis);
    case DesignKind::sobol:
      return scrambled_sobol(index, axis, seed_);
    case DesignKind::halton:
      return shifted_halton(index, axis, seed_);
  }
  return 0;
}

double Design::stratified(std::uint64_t index, int axis) const {
  const std::uint64_t stratum = permuted(index, count_, seed_, static_cast<std::uint32_t>(axis));
  const double within = random_fraction(seed_, index, static_cast<std::uint32_t>(axis));
  return (static_cast<double>(stratum) + within) / static_cast<double>(count_);
}

std::uint64_t grid_size(const std::vector<int>& steps) {
  std::uint64_t size = 1;
  for (const int count : steps) size *= static_cast<std::uint64_t>(count);
  return size;
}

Eigen::VectorXd grid_point(const std::vector<int>& steps, std::uint64_t index) {
  Eigen::VectorXd point(static_cast<Eigen::Index>(steps.size()));
  for (std::size_t axis = steps.size(); axis-- > 0;) {
    const auto count = static_cast<std::uint64_t>(steps[axis]);
    point[static_cast<Eigen::Index>(axis)] = (static_cast<double>(index % count) + 0.5) / static_cast<double>(count);
    index /= count;
  }
  return point;
}

}  // namespace netpocket
