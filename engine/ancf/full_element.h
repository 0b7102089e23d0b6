#pragma once
// Cable element with strain and curvature integrated along its length: the reference evaluation (Tang et al. 2023,
// Eqs. 10 to 15). Strain energy 1/2 int (EA eps^2 + EI kappa^2) dp with 5 Gauss points for the axial and 3 for the
// bending part, internal damping EA (eps + c deps/dt) and EI (kappa + c dkappa/dt).
//
// With a = r', b = r'', A = a.a and G = |a x b|^2 the curvature kappa^2 = G A^-n has no singular derivative at
// kappa = 0. It does have one at a = 0: where a slack cord gathers up, |a| -> 0, EI kappa^2 grows like 1/|a|^4 (green)
// or 1/|a|^2 (material), and so do its forces, beyond any time step. Bending theory ends long before. Where
// |a| < smallest_stretch, A^-n is therefore continued by its second-order Taylor polynomial in A about
// smallest_stretch^2 (twice continuously differentiable, finite at a = 0, still an energy); elsewhere it is exact.
// That bounds the forces. Only an axial stiffness keeps |a| from vanishing: give slack cords a small
// CableSection::compression.
//
// Forces resist: M qdd + internal_force = applied force. Values are in SI units and the world frame. While material is
// wound in or out (MaterialSpan), rates of strain are those of material points.

#include "engine/ancf/cable_section.h"
#include "engine/ancf/material_span.h"

namespace netpocket {

enum class StrainMeasure {
  green,    // eps = (r'.r' - 1)/2, kappa = |r' x r''|/|r'|^3: Gerstmayr & Shabana (2006), doi:10.1007/s11071-006-1856-1
  material  // eps = |r'| - 1, K = |r' x r''|/|r'|^2: Gerstmayr & Irschik (2008), Journal of Sound and Vibration 318
};

struct FullElementOptions {
  StrainMeasure measure = StrainMeasure::green;
  double smallest_stretch = 0.5;  // |r'| down to which the curvature is exact
};

class FullElement {
 public:
  FullElement(const CableSection& section, const MaterialSpan& span, const FullElementOptions& options = {})
      : section_(section), span_(span), options_(options) {}

  // Axial force with damping at xi; N, conjugate to the measure's strain.
  double tension(double xi, const ElementCoordinates& q, const ElementCoordinates& velocity) const;

  double axial_energy(const ElementCoordinates& q) const;    // J
  double bending_energy(const ElementCoordinates& q) const;  // J
  ElementCoordinates internal_force(const ElementCoordinates& q, const ElementCoordinates& velocity) const;
  // Derivative of the elastic force, exact and symmetric.
  ElementTangent tangent(const ElementCoordinates& q) const;

  // Power that damping turns into heat, >= 0. W
  double dissipated_power(const ElementCoordinates& q, const ElementCoordinates& velocity) const;
  // Power that the change of material length puts into the element against its internal force, so that
  //   d(energy)/dt = internal_force.velocity - dissipated_power + feeding_power. W
  double feeding_power(const ElementCoordinates& q, const ElementCoordinates& velocity) const;

 private:
  CableSection section_;
  MaterialSpan span_;
  FullElementOptions options_;
};

}  // namespace netpocket
