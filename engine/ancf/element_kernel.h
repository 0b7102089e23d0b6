#pragma once
// Declares the instruction-set variants of the element kernel. Internal to ElementBatch, which chooses between them.

#include "engine/ancf/element_batch.h"
#include "engine/math/instruction_set.h"

namespace netpocket::element_kernel {

// Fills the rows of ElementBatch::states.
using StateKernel = void (*)(const BatchView& batch, int first, int last, const CoordinateRows& coordinates,
                             const CoordinateRows& velocities, double* states);
using Kernel = BatchPower (*)(const BatchView& batch, int first, int last, const CoordinateRows& coordinates,
                              const CoordinateRows& velocities, double* forces);

NETPOCKET_VARIANTS(void element_states(const BatchView& batch, int first, int last, const CoordinateRows& coordinates,
                                       const CoordinateRows& velocities, double* states);
                   BatchPower element_forces(const BatchView& batch, int first, int last,
                                             const CoordinateRows& coordinates, const CoordinateRows& velocities,
                                             double* forces);)

}  // namespace netpocket::element_kernel
