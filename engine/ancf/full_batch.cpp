#include "engine/ancf/full_batch.h"

#include "engine/math/instruction_set.h"

namespace netpocket {
BatchPower FullBatch::forces(const ElementBatch& batch, int first, int last, const CoordinateRows& coordinates,
                             const CoordinateRows& velocities, double* forces) const {
  static const full_kernel::Kernel kernel = NETPOCKET_VARIANT_OF(full_kernel, element_forces);
  return kernel(batch.view(), start_rates_.data(), first, last, coordinates, velocities, forces);
}

}  // namespace netpocket
