#pragma once
// The nodes and gradients on which contacts act in a step: how many contacts share them, and the velocities that all
// other forces of the step lead to.
//
// All contacts of a step are computed from the same state (Jacobi iteration). A contact is solved for its own speed
// where it has damping, friction or a spring too stiff for the step. Contacts that share nodes must then share the
// nodes' inertia too. So a contact's inverse mass counts every contact on its nodes:
//   w = sum_i |S_i| (sum_c |S_i,c|)/m_i,
// the row sum of the contacts' common inverse mass matrix. No step can then push a node beyond what a single contact
// would (mass splitting: Tonge, Benevolenski & Voroshilov 2012, doi:10.1145/2185520.2185601).
//
// Contacts act on few coordinates, mostly on all eight of a block (the eight sectors). Only these blocks are stored.

#include <cmath>
#include <span>
#include <vector>

#include "engine/dynamics/assembly/coordinate_vectors.h"
#include "engine/dynamics/assembly/element_curve.h"

namespace netpocket {

class ContactedCoordinates {
 public:
  explicit ContactedCoordinates(std::int32_t count) : place_(static_cast<std::size_t>(count) / kBlockSize, -1) {}

  // Begins a step.
  void clear() {
    for (const std::int32_t block : blocks_) place_[static_cast<std::size_t>(block)] = -1;
    blocks_.clear();
    shared_weight_.clear();
  }
  // Index, in the rows below, of the block of a coordinate on which a contact acts.
  std::int32_t place_for(std::int32_t coordinate) {
    const auto block = static_cast<std::uint32_t>(coordinate) / kBlockSize;
    std::int32_t& place = place_[block];
    if (place < 0) {
      place = static_cast<std::int32_t>(blocks_.size());
      blocks_.push_back(static_cast<std::int32_t>(block));
      shared_weight_.resize(shared_weight_.size() + kBlockSize, 0.0);
    }
    return place;
  }
  bool is_empty() const { return blocks_.empty(); }
  bool holds(std::int32_t coordinate) const { return place_[static_cast<std::uint32_t>(coordinate) / kBlockSize] >= 0; }
  // Coordinates that are copies of one node: they share all contacts of the copies. To be called after all share().
  // Returns whether there are any.
  bool share_among(std::span<const std::int32_t> copies) {
    double total = 0;
    for (const std::int32_t copy : copies) {
      if (holds(copy)) total += shared_weight_[place(copy, kBlockSize)];
    }
    if (total == 0) return false;
    for (const std::int32_t copy : copies) {
      place_for(copy);
      shared_weight_[place(copy, kBlockSize)] = total;
    }
    return true;
  }
  // Records that a contact acts on `coordinate` with this weight. Returns the index of its block in the rows below.
  std::int32_t share(std::int32_t coordinate, double weight) {
    const std::int32_t place = place_for(coordinate);
    shared_weight_[static_cast<std::size_t>(place) * kBlockSize +
                   static_cast<std::uint32_t>(coordinate) % kBlockSize] += std::abs(weight);
    return place;
  }
  // By index of a block: rows x, y, z of predicted velocities, and the sums of |weight|.
  const double* predicted_rows() const { return predicted_.data(); }
  const double* shared_weights() const { return shared_weight_.data(); }
  double* shared_weights() { return shared_weight_.data(); }

  // Predicts the velocities after a kick of `dt` (s) by all forces but contact. To be called after all share() of the
  // step. `sum_forces(blocks, rows)` fills the rows of the given blocks of coordinates with forces.
  template <typename Function>
  void predict(const CoordinateVectors& velocities, std::span<const double> inverse_mass, double dt,
               const Function& sum_forces) {
    if (blocks_.empty()) return;
    predicted_.resize(blocks_.size() * kRows);
    sum_forces(std::span<const std::int32_t>(blocks_), predicted_.data());
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      const auto block = static_cast<std::size_t>(blocks_[i]);
      const double* velocity = velocities.rows().first + block * kRows;
      const double* inverse = inverse_mass.data() + block * kBlockSize;
      using Row = Eigen::Array<double, kBlockSize, 1>;
      const Row gain = dt * Eigen::Map<const Row>(inverse);
      for (std::size_t k = 0; k < kRows; k += kBlockSize) {
        Eigen::Map<Row, Eigen::Aligned64> row(predicted_.data() + i * kRows + k);
        row = Eigen::Map<const Row, Eigen::Aligned64>(velocity + k) + gain * row;
      }
    }
  }
  // Predicted velocity of a coordinate on which a contact acts.
  Eigen::Vector3d get(std::int32_t coordinate) const {
    const double* row = predicted_.data() + place(coordinate, kRows);
    return {row[0], row[kBlockSize], row[2 * kBlockSize]};
  }

  // Changes the predicted velocity of a coordinate on which a contact acts.
  void add_to_prediction(std::int32_t coordinate, const Eigen::Vector3d& change) {
    double* row = predicted_.data() + place(coordinate, kRows);
    row[0] += change.x();
    row[kBlockSize] += change.y();
    row[2 * kBlockSize] += change.z();
  }

  // Inverse mass (1/kg) of a contact, with its coordinates' inertia shared.
  double inverse_mass(const ElementIndices& coordinate, const ElementWeights& weight,
                      std::span<const double> inverse_mass) const {
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      sum += std::abs(weight[i]) * shared_weight_[place(coordinate[i], kBlockSize)] * inverse_mass[coordinate[i]];
    }
    return sum;
  }

 private:
  static constexpr std::size_t kRows = kVectorRows * kBlockSize;

  // Index of a coordinate's first value, in rows of which a block takes `stride` values.
  std::size_t place(std::int32_t coordinate, std::size_t stride) const {
    const auto s = static_cast<std::uint32_t>(coordinate);
    return static_cast<std::size_t>(place_[s / kBlockSize]) * stride + s % kBlockSize;
  }

  std::vector<std::int32_t> place_;      // by block of coordinates: index into blocks_, or -1
  std::vector<std::int32_t> blocks_;     // blocks of coordinates on which contacts act
  AlignedVector<double> shared_weight_;  // by coordinate of blocks_: sum of |weight|
  AlignedVector<double> predicted_;      // by block of blocks_: rows x, y, z of velocities
};

}  // namespace netpocket
