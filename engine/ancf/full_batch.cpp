#include "engine/ancf/full_batch.h"

#include "engine/ancf/instruction_set.h"

namespace netpocket {
namespace {

full_kernel::Kernel choose_kernel() {
  switch (instruction_set()) {
    case InstructionSet::avx512:
      return full_kernel::avx512::element_forces;
    case InstructionSet::avx2:
      return full_kernel::avx2::element_forces;
    case InstructionSet::baseline:
      break;
  }
  return full_kernel::baseline::element_forces;
}

}  // namespace

BatchPower FullBatch::forces(const ElementBatch& batch, int first, int last, const SlotRows& coordinates,
                             const SlotRows& velocities, double* forces) const {
  static const full_kernel::Kernel kernel = choose_kernel();
  return kernel(batch.view(), start_rates_.data(), first, last, coordinates, velocities, forces);
}

}  // namespace netpocket
