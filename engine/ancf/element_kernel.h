#pragma once
// The instruction-set variants of the element kernel and the choice between them. Internal to ElementBatch.

#include "engine/ancf/element_batch.h"

namespace netpocket::element_kernel {

using Kernel = double (*)(const ElementBlock* blocks, const std::uint8_t* variable, int first, int last,
                          const SlotArrays& coordinates, const SlotArrays& velocities, double* forces);

namespace baseline {
double element_forces(const ElementBlock*, const std::uint8_t*, int, int, const SlotArrays&, const SlotArrays&,
                      double*);
}
namespace avx2 {
double element_forces(const ElementBlock*, const std::uint8_t*, int, int, const SlotArrays&, const SlotArrays&,
                      double*);
}
namespace avx512 {
double element_forces(const ElementBlock*, const std::uint8_t*, int, int, const SlotArrays&, const SlotArrays&,
                      double*);
}

}  // namespace netpocket::element_kernel
