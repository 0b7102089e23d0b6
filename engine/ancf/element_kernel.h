#pragma once
// The instruction-set variants of the element kernel and the choice between them. Internal to ElementBatch.

#include "engine/ancf/element_batch.h"

namespace netpocket::element_kernel {

using Kernel = BatchPower (*)(const BatchView& batch, int first, int last, const SlotArrays& coordinates,
                              const SlotArrays& velocities, double* forces);

namespace baseline {
BatchPower element_forces(const BatchView& batch, int first, int last, const SlotArrays& coordinates,
                          const SlotArrays& velocities, double* forces);
}
namespace avx2 {
BatchPower element_forces(const BatchView& batch, int first, int last, const SlotArrays& coordinates,
                          const SlotArrays& velocities, double* forces);
}
namespace avx512 {
BatchPower element_forces(const BatchView& batch, int first, int last, const SlotArrays& coordinates,
                          const SlotArrays& velocities, double* forces);
}

}  // namespace netpocket::element_kernel
