#pragma once
// The instruction-set variants of ancf/variable_length.h for eight elements of ropes that are wound: what the flow of
// material and masses that change do in a step. Tested against it to round-off.

#include <cstdint>

#include "engine/ancf/element_batch.h"

namespace netpocket {

// Material inside an element, by lane (material_span.h).
struct alignas(64) SpanRows {
  double length[kBlockSize];                            // m
  double start_rate[kBlockSize], end_rate[kBlockSize];  // m/s
};

// Up to eight elements. What lanes without one find, which may be no number, is not asked for.
struct RopeBlock {
  double mass_per_length[kBlockSize];  // kg/m
  SpanRows before, now;                // at the start of the previous step and of the present one

  // Filled by the kernels.
  double force[4][kVectorRows][kBlockSize];  // by corner, N and N m
  double energy_change[kBlockSize];          // J

  std::int32_t coordinate[4][kBlockSize];  // r1, g1, r2, g2
  std::int32_t count = 0;
};

namespace rope_kernel {

// dT/dq and, spread over a kick of `kick` (s), the momenta that velocities do not hold: of masses that have changed and
// of the flow, now and one step of `last_dt` (s) before.
using ForceKernel = void (*)(const CoordinateRows& coordinates, const CoordinateRows& velocities, double last_dt,
                             double kick, RopeBlock& block);
// Kinetic energy at these coordinates and velocities with the present span less that with the one before.
using EnergyKernel = void (*)(const CoordinateRows& coordinates, const CoordinateRows& velocities, RopeBlock& block);

namespace baseline {
void forces(const CoordinateRows&, const CoordinateRows&, double, double, RopeBlock&);
void energy_change(const CoordinateRows&, const CoordinateRows&, RopeBlock&);
}  // namespace baseline
namespace avx2 {
void forces(const CoordinateRows&, const CoordinateRows&, double, double, RopeBlock&);
void energy_change(const CoordinateRows&, const CoordinateRows&, RopeBlock&);
}  // namespace avx2
namespace avx512 {
void forces(const CoordinateRows&, const CoordinateRows&, double, double, RopeBlock&);
void energy_change(const CoordinateRows&, const CoordinateRows&, RopeBlock&);
}  // namespace avx512

}  // namespace rope_kernel
}  // namespace netpocket
