#pragma once
// Forces on coordinates other than the elements' internal forces: gravity and constant loads, and what each step adds
// to them. Most coordinates bear none. Blocks of coordinates with forces are marked, so that the others need not be
// read.

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/dynamics/assembly/coordinate_vectors.h"

namespace netpocket {

class AppliedForces {
 public:
  explicit AppliedForces(std::int32_t coordinate_count)
      : forces_(coordinate_count),
        marks_(static_cast<std::size_t>(forces_.size() / kBlockSize), Mark::nothing),
        constant_marks_(marks_) {}

  // Sets the constant forces, N (positions) or N m (gradients). To be called before any add().
  void set_constant(CoordinateVectors constant) {
    constant_.reset();
    forces_ = std::move(constant);
    for (std::int32_t coordinate = 0; coordinate < forces_.size(); ++coordinate) {
      if (forces_.get(coordinate) != Eigen::Vector3d::Zero()) mark(coordinate) = Mark::constant;
    }
    constant_marks_ = marks_;
    const bool any = std::ranges::any_of(marks_, [](Mark mark) { return mark != Mark::nothing; });
    if (any) constant_ = forces_;
  }
  // The constant forces; null if there are none.
  const CoordinateVectors* constant() const { return constant_ ? &*constant_ : nullptr; }

  // Begins a step: resets all forces to the constant ones.
  void clear() {
    for (const std::int32_t first : touched_) {
      double* rows = forces_.data() + static_cast<std::ptrdiff_t>(first) * kVectorRows;
      if (constant_) {
        std::copy_n(constant_->rows().first + static_cast<std::ptrdiff_t>(first) * kVectorRows,
                    kVectorRows * kBlockSize, rows);
      } else {
        Eigen::Map<Eigen::Array<double, kVectorRows * kBlockSize, 1>, Eigen::Aligned64>(rows).setZero();
      }
      mark(first) = constant_marks_[static_cast<std::size_t>(first / kBlockSize)];
    }
    touched_.clear();
  }
  void add(std::int32_t coordinate, const Eigen::Vector3d& force) {
    touch(coordinate);
    forces_.add(coordinate, force);
  }
  Eigen::Vector3d get(std::int32_t coordinate) const { return forces_.get(coordinate); }
  // Marks a coordinate to which a force is going to be added in data().
  void touch(std::int32_t coordinate) {
    if (mark(coordinate) == Mark::touched) return;
    mark(coordinate) = Mark::touched;
    touched_.push_back(coordinate - coordinate % kBlockSize);
  }
  double* data() { return forces_.data(); }

  CoordinateRows rows() const { return forces_.rows(); }
  // By block of coordinates: 0 where no force acts.
  const std::uint8_t* loaded() const { return reinterpret_cast<const std::uint8_t*>(marks_.data()); }

 private:
  enum class Mark : std::uint8_t { nothing, constant, touched };
  Mark& mark(std::int32_t coordinate) { return marks_[static_cast<std::uint32_t>(coordinate) / kBlockSize]; }

  CoordinateVectors forces_;
  std::optional<CoordinateVectors> constant_;
  std::vector<Mark> marks_;            // by block of coordinates
  std::vector<Mark> constant_marks_;   // marks from constant forces only
  std::vector<std::int32_t> touched_;  // first coordinates of blocks with Mark::touched
};

}  // namespace netpocket
