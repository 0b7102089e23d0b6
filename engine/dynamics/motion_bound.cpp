#include "engine/dynamics/motion_bound.h"

#include <algorithm>
#include <cmath>

namespace netpocket {
namespace {

// Slots that a thread takes at once; whole blocks.
constexpr int kSlotRange = 2048;

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
      first_gradient_(SlotLayout{node_count_, 0}.gradient(0)),
      gradient_count_(static_cast<std::int32_t>(model.gradients.size())) {
  quarter_length_.setZero(kBlockSize, SlotLayout::padded(gradient_count_) / kBlockSize);
  for (const ModelElement& element : model.elements) {
    for (const std::int32_t gradient : {element.gradient1, element.gradient2}) {
      double& quarter = quarter_length_(gradient % kBlockSize, gradient / kBlockSize);
      quarter = std::max(quarter, 0.25 * element.length);
    }
  }
}

template <typename Squares>
double MotionBound::largest(const DividedLoop& loop, const Squares& squares) const {
  const auto node = values_of_ranges<double>(
      loop, node_count_, kSlotRange, [&](int first, int last) { return largest_square(squares(first, last - first)); });
  const auto gradient = values_of_ranges<double>(loop, gradient_count_, kSlotRange, [&](int first, int last) {
    const int count = last - first;
    const auto quarter = quarter_length_.middleCols(first / kBlockSize, (count + kBlockSize - 1) / kBlockSize);
    return largest_square(quarter.square() * squares(first_gradient_ + first, count));
  });
  return std::sqrt(largest_of(node)) + std::sqrt(largest_of(gradient));
}

double MotionBound::speed(const SlotVectors& velocities, const DividedLoop& loop) const {
  return largest(loop, [&](std::int32_t first, std::int32_t count) { return velocities.squared_norms(first, count); });
}

double MotionBound::way(const SlotVectors& before, const SlotVectors& now, const DividedLoop& loop) const {
  return largest(loop,
                 [&](std::int32_t first, std::int32_t count) { return now.squared_distances(before, first, count); });
}

}  // namespace netpocket
