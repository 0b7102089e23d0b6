#pragma once
// The largest stable step of the explicit integrator, and what limits it.
//
// For a mode of frequency w and damping rate d, the leapfrog step with damping at the last half step is stable up to
//   dt = (sqrt(d^2 + 4 w^2) - d) / w^2,
// from dt^2 w^2 + 2 d dt <= 4 (Belytschko, Liu & Moran, Nonlinear Finite Elements, section 6.2; lagged damping). The
// limiting mode is found by power iteration on M^-1 (K + 2/dt C). For this every cable is taken as straight along its
// present chords, and K omits the geometric stiffness of tensions. CableSystem::stable_step_as_bent adds the effect of
// bends and tensions.

#include <span>
#include <string>
#include <vector>

#include "engine/ancf/element_batch.h"
#include "engine/dynamics/assembly/coordinate_vectors.h"
#include "engine/model/model.h"

namespace netpocket {

// The main kind of a limiting mode.
enum class StepLimit : std::uint8_t { nothing, axial_waves, bending_waves, full_element, hinge, line };

struct StableStep {
  double step;  // s
  StepLimit limit = StepLimit::nothing;
  std::int32_t thread = 0;  // in which the limiting mode has most energy
  // Of the limiting mode: w^2 (1/s^2) and d (1/s).
  double stiffness = 0, damping = 0;
};

// Text such as "axial waves in panel 3 row 2". `thread`: index into Model::threads.
std::string limit_text(const Model& model, StepLimit limit, std::int32_t thread);

// Stable step (s) of one mode, from w^2 (1/s^2) and d (1/s). Infinite without stiffness.
double stable_step_of_mode(double stiffness, double damping);

// Stable step of mean-strain elements with lumped mass. `elements`: at their present lengths. `inverse_mass`: by
// coordinate, 0 where a coordinate is not free. The step is infinite if nothing moves.
// Bodies are taken as standing.
StableStep find_stable_step(const Model& model, const CoordinateLayout& layout, std::span<const BatchElement> elements,
                            std::span<const double> inverse_mass, const CoordinateVectors& coordinates);

// A step (s) that is stable with a model's tension lines as well, whatever their directions: the squared frequencies of
// two stiffnesses add up at most, and those of lines are at most twice the largest sum k/m of a node (Gershgorin).
StableStep with_lines(const Model& model, const CoordinateLayout& layout, std::span<const double> inverse_mass,
                      const StableStep& without);

// As find_stable_step for full elements with consistent mass, from the highest frequency of any single element in its
// present shape. It is an upper bound of that of the whole model (Irons & Treharne 1971). `elements`: at their present
// lengths.
StableStep find_stable_step_of_full_elements(const Model& model, std::span<const BatchElement> elements,
                                             const CoordinateVectors& coordinates);

// Stable step (s) of a single straight mean-strain element of `length` (m) with lumped mass. It is a lower bound for a
// chain of equal elements, in which every node has two neighbours and twice the mass. `paired`: a chain of strain pairs
// (strain_pair.h).
double stable_step_of_lumped_element(const CableSection& section, double length, bool paired);

// The same for a full element with lumped mass, such as those of variable-length ropes. Its strain at five points acts
// on the light gradients, which makes it far stiffer than the mean-strain element.
double stable_step_of_lumped_full_element(const CableSection& section, double length);

}  // namespace netpocket
