#pragma once
// Instruction-set variants of ancf/variable_length.h, for eight elements of wound ropes: the effects of the material's
// flow and of changing masses in a step. Also of MeanStrainElement::tension. Tested against them to round-off.

#include <cstdint>

#include "engine/ancf/element_batch.h"
#include "engine/math/instruction_set.h"

namespace netpocket {

// Material inside an element, by lane (material_span.h).
struct alignas(64) SpanRows {
  double length[kBlockSize];                            // m
  double start_rate[kBlockSize], end_rate[kBlockSize];  // m/s
};

// Up to eight elements. Results in lanes without an element may be NaN and must be ignored.
struct RopeBlock {
  double mass_per_length[kBlockSize];  // kg/m
  // Of CableSection: EA (N), the fraction of it under compression, and the damping (s).
  double axial_stiffness[kBlockSize], compression[kBlockSize], axial_damping[kBlockSize];
  SpanRows before, now;  // at the start of the previous and of the present step

  // Filled by the kernels.
  double force[4][kVectorRows][kBlockSize];  // by corner, N and N m
  double energy_change[kBlockSize];          // J

  std::int32_t coordinate[4][kBlockSize];  // r1, g1, r2, g2
  std::int32_t rope[kBlockSize];           // index of the lane's rope
  std::int32_t count = 0;
};

namespace rope_kernel {

// Computes the force: dT/dq, plus momentum changes spread over a kick of `kick` (s). The latter are those that
// velocities do not contain: of changed masses, and of the flow from one step of `last_dt` (s) before until now.
using ForceKernel = void (*)(const CoordinateRows& coordinates, const CoordinateRows& velocities, double last_dt,
                             double kick, RopeBlock& block);
// Computes the change of kinetic energy at these coordinates and velocities: present span minus previous span.
using EnergyKernel = void (*)(const CoordinateRows& coordinates, const CoordinateRows& velocities, RopeBlock& block);
// Computes the tensions (N, by lane) of mean-strain elements with the material `spans`.
using TensionKernel = void (*)(const CoordinateRows& coordinates, const CoordinateRows& velocities,
                               const SpanRows& spans, const RopeBlock& block, double* tensions);

NETPOCKET_VARIANTS(void forces(const CoordinateRows&, const CoordinateRows&, double, double, RopeBlock&);
                   void energy_change(const CoordinateRows&, const CoordinateRows&, RopeBlock&);
                   void tensions(const CoordinateRows&, const CoordinateRows&, const SpanRows&, const RopeBlock&,
                                 double*);)

}  // namespace rope_kernel
}  // namespace netpocket
