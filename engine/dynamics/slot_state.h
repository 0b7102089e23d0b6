#pragma once
// State of all vector-valued coordinates ("slots") of a model: node positions first, then gradients, each group padded
// to whole blocks of eight. Positions belong to step n, velocities to the half step before it (leapfrog).

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>

#include "engine/ancf/element_batch.h"
#include "engine/dynamics/aligned_vector.h"

namespace netpocket {

// One vector per slot.
class SlotVectors {
 public:
  explicit SlotVectors(std::int32_t slots = 0) : x_(slots, 0.0), y_(slots, 0.0), z_(slots, 0.0) {}

  Eigen::Vector3d get(std::int32_t slot) const { return {x_[slot], y_[slot], z_[slot]}; }
  void set(std::int32_t slot, const Eigen::Vector3d& value) {
    x_[slot] = value.x();
    y_[slot] = value.y();
    z_[slot] = value.z();
  }
  void add(std::int32_t slot, const Eigen::Vector3d& value) {
    x_[slot] += value.x();
    y_[slot] += value.y();
    z_[slot] += value.z();
  }
  void set_zero() {
    for (auto* component : {&x_, &y_, &z_}) std::fill(component->begin(), component->end(), 0.0);
  }
  std::int32_t size() const { return static_cast<std::int32_t>(x_.size()); }
  SlotArrays arrays() { return {x_.data(), y_.data(), z_.data()}; }
  // The squared norms of `count` vectors from `first` on, as an expression.
  auto squared_norms(std::int32_t first, std::int32_t count) const {
    const auto component = [&](const AlignedVector<double>& values) {
      return Eigen::Map<const Eigen::ArrayXd>(values.data() + first, count);
    };
    return (component(x_).square() + component(z_).square()) + component(y_).square();
  }
  // Likewise of how far they are from those of `other`.
  auto squared_distances(const SlotVectors& other, std::int32_t first, std::int32_t count) const {
    const auto component = [&](const AlignedVector<double>& now, const AlignedVector<double>& before) {
      return (Eigen::Map<const Eigen::ArrayXd>(now.data() + first, count) -
              Eigen::Map<const Eigen::ArrayXd>(before.data() + first, count))
          .square();
    };
    return (component(x_, other.x_) + component(z_, other.z_)) + component(y_, other.y_);
  }

 private:
  AlignedVector<double> x_, y_, z_;
};

// Numbering of the slots of a model.
struct SlotLayout {
  std::int32_t node_count = 0;
  std::int32_t gradient_count = 0;

  static std::int32_t padded(std::int32_t count) { return (count + kBlockSize - 1) / kBlockSize * kBlockSize; }
  std::int32_t position(std::int32_t node) const { return node; }
  std::int32_t gradient(std::int32_t gradient) const { return padded(node_count) + gradient; }
  std::int32_t size() const { return padded(node_count) + padded(gradient_count); }
};

}  // namespace netpocket
