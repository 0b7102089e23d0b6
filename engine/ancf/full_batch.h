#pragma once
// Internal forces of many full cable elements at once. It is the fast form of full_element.h with the default options
// (Green strain); a test requires both to agree to round-off. An ElementBatch supplies the elements, their lengths and
// the layout of the forces.

#include <vector>

#include "engine/ancf/element_batch.h"
#include "engine/ancf/full_kernel.h"

namespace netpocket {

class FullBatch {
 public:
  explicit FullBatch(int block_count) : start_rates_(block_count) {}

  // Sets the rate dp1/dt (m/s) at which material leaves a variable element at its first node. The length of the element
  // is set in the ElementBatch.
  void set_start_rate(int element, double rate) {
    start_rates_[element / kBlockSize].value[element % kBlockSize] = rate;
  }

  // As ElementBatch::forces, but with the full evaluation.
  BatchPower forces(const ElementBatch& batch, int first, int last, const CoordinateRows& coordinates,
                    const CoordinateRows& velocities, double* forces) const;

 private:
  std::vector<full_kernel::StartRates> start_rates_;
};

}  // namespace netpocket
