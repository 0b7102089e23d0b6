#pragma once
// Declares the instruction-set variants of the full element's kernel. Internal to FullBatch, which chooses between
// them.

#include "engine/ancf/element_batch.h"
#include "engine/math/instruction_set.h"

namespace netpocket::full_kernel {

// Rates dp1/dt (m/s) of eight elements.
struct alignas(64) StartRates {
  double value[kBlockSize] = {};
};

using Kernel = BatchPower (*)(const BatchView& batch, const StartRates* start_rates, int first, int last,
                              const CoordinateRows& coordinates, const CoordinateRows& velocities, double* forces);

NETPOCKET_VARIANTS(BatchPower element_forces(const BatchView&, const StartRates*, int, int, const CoordinateRows&,
                                             const CoordinateRows&, double*);)

}  // namespace netpocket::full_kernel
