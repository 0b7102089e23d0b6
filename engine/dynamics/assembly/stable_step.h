#pragma once
// The largest stable step of the explicit integrator and what limits it.
//
// For a mode of frequency w and damping rate d the leapfrog step with damping at the last half step is stable up to
//   dt = (sqrt(d^2 + 4 w^2) - d) / w^2,
// from dt^2 w^2 + 2 d dt <= 4 (Belytschko, Liu & Moran, Nonlinear Finite Elements, section 6.2; lagged damping). The
// limiting mode is found by power iteration on M^-1 (K + 2/dt C) with every cable straight along its present chords, K
// without the geometric stiffness of tensions. What bends and tensions add: CableSystem::stable_step_as_bent.

#include <span>
#include <string>
#include <vector>

#include "engine/ancf/element_batch.h"
#include "engine/dynamics/assembly/coordinate_vectors.h"
#include "engine/model/model.h"

namespace netpocket {

// What a limiting mode mostly is.
enum class StepLimit : std::uint8_t { nothing, axial_waves, bending_waves, full_element, hinge };

struct StableStep {
  double step;  // s
  StepLimit limit = StepLimit::nothing;
  std::int32_t thread = 0;  // in which the limiting mode takes most energy
  // Of the limiting mode: w^2 (1/s^2) and d (1/s).
  double stiffness = 0, damping = 0;
};

// E.g. "axial waves in panel 3 row 2".
std::string limit_text(const Model& model, StepLimit limit, std::int32_t thread);

// Stable step of one mode, s.
double stable_step_of_mode(double stiffness, double damping);

// `inverse_mass` by coordinate, 0 where a coordinate does not move by itself.
StableStep find_stable_step(const Model& model, const CoordinateLayout& layout, std::span<const BatchElement> elements,
                            std::span<const double> inverse_mass, const CoordinateVectors& coordinates);

// The same for full elements with consistent mass: the highest frequency of any single element, which bounds that of
// the whole from above (Irons & Treharne 1971). `elements` at their present lengths; elements in their present shape.
StableStep find_stable_step_of_full_elements(const Model& model, std::span<const BatchElement> elements,
                                             const CoordinateVectors& coordinates);

// Stable step (s) of a straight mean-strain element of `length` (m) by itself, with lumped mass: a bound for a chain of
// equal ones, in which every node has two neighbours and twice the mass. `paired`: a chain of pairs (strain_pair.h).
double stable_step_of_lumped_element(const CableSection& section, double length, bool paired);

// The same of a full element with lumped mass, such as those of ropes whose length changes. Its strain at five points
// acts on the light slopes, so that it is far stiffer than the mean-strain one.
double stable_step_of_lumped_full_element(const CableSection& section, double length);

}  // namespace netpocket
