#pragma once
// Internal forces of many full cable elements at once: the fast form of full_element.h with its default options (Green
// strain), tested against it to round-off. Elements, their lengths and the layout of the forces are those of an
// ElementBatch.

#include <vector>

#include "engine/ancf/element_batch.h"
#include "engine/ancf/full_kernel.h"

namespace netpocket {

class FullBatch {
 public:
  explicit FullBatch(int block_count) : start_rates_(block_count) {}

  // Rate dp1/dt (m/s) at which material leaves a variable element at its first node; its length is the ElementBatch's.
  void set_start_rate(int element, double rate) {
    start_rates_[element / kBlockSize].value[element % kBlockSize] = rate;
  }

  // As ElementBatch::forces, of the full evaluation.
  BatchPower forces(const ElementBatch& batch, int first, int last, const CoordinateRows& coordinates,
                    const CoordinateRows& velocities, double* forces) const;

 private:
  std::vector<full_kernel::StartRates> start_rates_;
};

}  // namespace netpocket
