#pragma once
// Values of all vector unknowns ("coordinates") of a model: node positions first, then gradients, each group padded to
// whole blocks of eight. Positions and gradients belong to step n, velocities to the half step before it (leapfrog).

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/ancf/element_batch.h"
#include "engine/base/aligned_vector.h"

namespace netpocket {

// One vector per coordinate, in blocks of eight: eight x, eight y, eight z.
class CoordinateVectors {
 public:
  explicit CoordinateVectors(std::int32_t count = 0)
      : rows_(static_cast<std::size_t>(kBlockRows) * blocks_of(count), 0.0) {}

  Eigen::Vector3d get(std::int32_t coordinate) const {
    const double* row = rows_.data() + place(coordinate);
    return {row[0], row[kBlockSize], row[2 * kBlockSize]};
  }
  void set(std::int32_t coordinate, const Eigen::Vector3d& value) {
    double* row = rows_.data() + place(coordinate);
    row[0] = value.x();
    row[kBlockSize] = value.y();
    row[2 * kBlockSize] = value.z();
  }
  void add(std::int32_t coordinate, const Eigen::Vector3d& value) {
    double* row = rows_.data() + place(coordinate);
    row[0] += value.x();
    row[kBlockSize] += value.y();
    row[2 * kBlockSize] += value.z();
  }
  void set_zero() { std::fill(rows_.begin(), rows_.end(), 0.0); }
  // Number of coordinates, including padding.
  std::int32_t size() const { return static_cast<std::int32_t>(rows_.size() / kVectorRows); }
  CoordinateRows rows() const { return {rows_.data()}; }
  double* data() { return rows_.data(); }

  // Squared norms of the vectors of the blocks that hold `count` coordinates from `first` on, as an Eigen expression
  // with one column per block. `first` must be the first coordinate of its block.
  auto squared_norms(std::int32_t first, std::int32_t count) const {
    const auto component = [&](int row) { return component_rows(first, count, row).square(); };
    return (component(0) + component(2)) + component(1);
  }
  // Likewise, squared distances from the vectors of `other`.
  auto squared_distances(const CoordinateVectors& other, std::int32_t first, std::int32_t count) const {
    const auto component = [&](int row) {
      return (component_rows(first, count, row) - other.component_rows(first, count, row)).square();
    };
    return (component(0) + component(2)) + component(1);
  }

 private:
  static constexpr int kBlockRows = kVectorRows * kBlockSize;
  using Blocks = Eigen::Array<double, kBlockSize, Eigen::Dynamic>;

  static std::int32_t blocks_of(std::int32_t count) { return (count + kBlockSize - 1) / kBlockSize; }
  static std::ptrdiff_t place(std::int32_t coordinate) {
    const auto s = static_cast<std::uint32_t>(coordinate);  // unsigned division is faster
    return static_cast<std::ptrdiff_t>(s / kBlockSize) * kBlockRows + s % kBlockSize;
  }
  Eigen::Map<const Blocks, Eigen::Aligned64, Eigen::OuterStride<kBlockRows>> component_rows(std::int32_t first,
                                                                                            std::int32_t count,
                                                                                            int row) const {
    return {rows_.data() + place(first) + static_cast<std::ptrdiff_t>(row) * kBlockSize, kBlockSize, blocks_of(count)};
  }

  AlignedVector<double> rows_;
};

// Largest value of squared_norms or squared_distances; NaN if any value is NaN. Maxima may miss a NaN, sums do not.
template <typename Squares>
double largest_square(const Squares& squares) {
  using Column = Eigen::Array<double, kBlockSize, 1>;
  Column largest = Column::Zero(), sum = Column::Zero();
  for (Eigen::Index block = 0; block < squares.cols(); ++block) {
    const Column column = squares.col(block);
    largest = largest.max(column);
    sum += column;
  }
  const double total = sum.sum();
  return std::isnan(total) ? total : largest.maxCoeff();
}

// The vector of one lane, from rows x, y, z of a block.
inline Eigen::Vector3d lane_of(const double (&rows)[kVectorRows][kBlockSize], int lane) {
  return {rows[0][lane], rows[1][lane], rows[2][lane]};
}

// Numbering of the coordinates of a model.
struct CoordinateLayout {
  std::int32_t node_count = 0;
  std::int32_t gradient_count = 0;

  static std::int32_t padded(std::int32_t count) { return (count + kBlockSize - 1) / kBlockSize * kBlockSize; }
  std::int32_t position(std::int32_t node) const { return node; }
  std::int32_t gradient(std::int32_t gradient) const { return padded(node_count) + gradient; }
  std::int32_t size() const { return padded(node_count) + padded(gradient_count); }
};

}  // namespace netpocket
