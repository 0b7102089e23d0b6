#pragma once
// The fused pass over pairs of elements (pair_kernel.h) of a system that one thread steps. Elements whose forces are
// needed before anything moves are computed on demand, once a step.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/ancf/element_batch.h"
#include "engine/base/aligned_vector.h"
#include "engine/dynamics/assembly/pair_kernel.h"

namespace netpocket {

class PairedElements {
 public:
  // `batch` must outlive this object. `elements`: those of the batch.
  PairedElements(const ElementBatch& batch, std::span<const BatchElement> elements, std::int32_t coordinate_count);

  // Number of blocks of coordinates that the pass can move.
  int middle_count() const { return middle_count_; }
  // By block of coordinates: 1 where the pass can move it, else 0.
  std::span<const std::uint8_t> is_middle() const { return is_middle_; }

  // Begins a step, in which the forces of no element are known.
  void forget();
  // Stores in `element_forces` the forces of all elements on these blocks of coordinates.
  void find_forces(std::span<const std::int32_t> coordinate_blocks, const CoordinateRows& coordinates,
                   const CoordinateRows& velocities, double* element_forces);
  // Computes the forces of element blocks [first, last), stores those that act on anything but middles, and moves
  // middles, as pair_kernel::MoveKernel. Middles of elements whose forces were known stay where they are.
  pair_kernel::PairSums move(const update_kernel::UpdateView& motion, int first, int last, double kick, double drift,
                             double* element_forces) const;
  // What the kernels take.
  pair_kernel::PairView view(double* element_forces) const;
  // Blocks of coordinates that move() leaves although it could move them.
  std::span<const std::int32_t> unmoved_middles() const { return unmoved_; }

 private:
  void find_middles(std::span<const BatchElement> elements, std::int32_t coordinate_count);
  void list_elements(std::span<const BatchElement> elements);

  const ElementBatch& batch_;
  std::vector<pair_kernel::PairMiddle> middles_;  // by element block
  std::vector<std::uint8_t> is_middle_;
  int middle_count_ = 0;
  // By block of coordinates: the element blocks that act on it; of a pair the first.
  std::vector<std::int32_t> acting_, acting_end_;
  std::vector<std::uint8_t> known_;   // by element block
  std::vector<std::int32_t> wanted_;  // element blocks
  std::vector<std::int32_t> known_blocks_, unmoved_;
  mutable AlignedVector<double> powers_;
};

}  // namespace netpocket
