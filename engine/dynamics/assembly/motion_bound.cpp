#include "engine/dynamics/assembly/motion_bound.h"

#include <algorithm>
#include <cmath>

#include "engine/dynamics/assembly/motion_kernel.h"
#include "engine/math/instruction_set.h"

namespace netpocket {
namespace {

// Number of coordinates that a thread processes at once; whole blocks.
constexpr int kCoordinateRange = 2048;

motion_kernel::Kernel kernel() {
  using namespace motion_kernel;
  static const Kernel chosen = NETPOCKET_VARIANT_OF(motion_kernel, largest_square);
  return chosen;
}

double largest_of(const std::vector<double>& maxima) {
  double largest = 0;
  for (const double value : maxima) {
    if (std::isnan(value)) return value;
    largest = std::max(largest, value);
  }
  return largest;
}

}  // namespace

MotionBound::MotionBound(const Model& model)
    : node_count_(static_cast<std::int32_t>(model.nodes.size())),
      first_gradient_(CoordinateLayout{node_count_, 0}.gradient(0)),
      gradient_count_(static_cast<std::int32_t>(model.gradients.size())) {
  quarter_length_.setZero(kBlockSize, CoordinateLayout::padded(gradient_count_) / kBlockSize);
  for (const ModelElement& element : model.elements) {
    for (const std::int32_t gradient : {element.gradient1, element.gradient2}) {
      double& quarter = quarter_length_(gradient % kBlockSize, gradient / kBlockSize);
      quarter = std::max(quarter, 0.25 * element.length);
    }
  }
  weights_.assign(static_cast<std::size_t>(first_gradient_) + static_cast<std::size_t>(quarter_length_.size()), 0.0);
  std::fill_n(weights_.begin(), node_count_, 1.0);
  std::copy_n(quarter_length_.data(), quarter_length_.size(), weights_.begin() + first_gradient_);
}

template <typename Squares>
double MotionBound::largest(const DividedLoop& loop, const Squares& squares) const {
  const auto node = values_of_ranges<double>(loop, node_count_, kCoordinateRange, [&](int first, int last) {
    return largest_square(squares(first, last - first));
  });
  const auto gradient = values_of_ranges<double>(loop, gradient_count_, kCoordinateRange, [&](int first, int last) {
    const int count = last - first;
    const auto quarter = quarter_length_.middleCols(first / kBlockSize, (count + kBlockSize - 1) / kBlockSize);
    return largest_square(quarter.square() * squares(first_gradient_ + first, count));
  });
  return std::sqrt(largest_of(node)) + std::sqrt(largest_of(gradient));
}

double MotionBound::speed(const CoordinateVectors& velocities, const DividedLoop& loop) const {
  const auto fastest = [&](std::int32_t begin, std::int32_t count) {
    return largest_of(
        values_of_ranges<double>(loop, count / kBlockSize, kCoordinateRange / kBlockSize, [&](int first, int last) {
          const std::ptrdiff_t coordinate = begin + static_cast<std::ptrdiff_t>(first) * kBlockSize;
          return kernel()(velocities.rows().first + coordinate * kVectorRows, weights_.data() + coordinate,
                          static_cast<std::size_t>(last - first));
        }));
  };
  return speed(fastest(0, first_gradient_), fastest(first_gradient_, CoordinateLayout::padded(gradient_count_)));
}

double MotionBound::speed(double position, double gradient) { return std::sqrt(position) + std::sqrt(gradient); }

double MotionBound::way(const CoordinateVectors& before, const CoordinateVectors& now, const DividedLoop& loop) const {
  return largest(loop,
                 [&](std::int32_t first, std::int32_t count) { return now.squared_distances(before, first, count); });
}

}  // namespace netpocket
