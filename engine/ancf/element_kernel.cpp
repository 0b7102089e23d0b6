// This file is compiled once per instruction set; NETPOCKET_ISA_NAME is the namespace of the variant.

#include "engine/ancf/element_kernel.h"

#include "engine/ancf/element_formulas.h"
#include "engine/math/simd.h"

namespace netpocket::element_kernel::NETPOCKET_ISA_NAME {
namespace {

using namespace simd;

NETPOCKET_INLINE const ElementBlock& strain_partner_of(const BatchView& batch, const ElementBlock& block) {
  if (block.pairing == Pairing::elsewhere) return batch.strain_partners[block.strain_partners];
  return block.pairing == Pairing::first ? *(&block + 1) : *(&block - 1);
}

NETPOCKET_INLINE SimdVector chord_of(const ElementBlock& block, int part, const CoordinateRows& coordinates) {
  return load(block.inverse_length, part) *
         (load_coordinate(coordinates, block, 2, part) - load_coordinate(coordinates, block, 0, part));
}

}  // namespace

BatchPower element_forces(const BatchView& batch, int first, int last, const CoordinateRows& coordinates,
                          const CoordinateRows& velocities, double* forces) {
  PowerSimd power[kParts] = {};
  for (int i = first; i < last; ++i) {
    const ElementBlock* block = batch.blocks + i;
    if (block->pairing == Pairing::second) continue;
    double* out = forces + static_cast<std::ptrdiff_t>(i) * kForceRows * kBlock;
    for (int part = 0; part < kParts; ++part) {
      if (block->variable) {
        any_block_forces<true>(batch, block, part, coordinates, velocities, out, power[part], power[part]);
      } else {
        any_block_forces<false>(batch, block, part, coordinates, velocities, out, power[part], power[part]);
      }
    }
  }
  return total_of(power);
}

void element_states(const BatchView& batch, int first, int last, const CoordinateRows& coordinates,
                    const CoordinateRows& velocities, double* states) {
  for (int i = first; i < last; ++i) {
    const ElementBlock& block = batch.blocks[i];
    double* out = states + static_cast<std::ptrdiff_t>(i) * kStateRows * kBlock;
    for (int part = 0; part < kParts; ++part) {
      const Kinematics k = block.variable ? kinematics<true, false>(block, part, coordinates, velocities)
                                          : kinematics<false, false>(block, part, coordinates, velocities);
      const SimdDouble stiffness =
          load(batch.sections[block.section].bending_rigidity, part) * load(block.inverse_length, part);
      store(out, part, k.strain);
      store(out + kBlock, part, k.strain_rate);
      store(out + 2 * kBlock, part, broadcast(0.5) * (stiffness * (k.s_square + broadcast(3.0) * k.a_square)));
      SimdDouble bends = broadcast(78.0 / 1800) * (broadcast(25.0) * k.s_square + broadcast(9.0) * k.a_square);
      if (block.pairing != Pairing::none) {
        const SimdVector fold = k.e - chord_of(strain_partner_of(batch, block), part, coordinates);
        bends = bends + broadcast(0.5) * dot(fold, fold);
      }
      store(out + 3 * kBlock, part, bends);
    }
  }
}

}  // namespace netpocket::element_kernel::NETPOCKET_ISA_NAME
