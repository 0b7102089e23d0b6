#pragma once
// Cable element with strain and curvature integrated along its length: the reference evaluation (Tang et al. 2023,
// Eqs. 10 to 15). Strain energy 1/2 int (EA eps^2 + EI kappa^2) dp with 5 Gauss points for the axial and 3 for the
// bending part, internal damping EA (eps + c deps/dt) and EI (kappa + c dkappa/dt).
//
// With a = r', b = r'', A = a.a and G = |a x b|^2 the curvature kappa^2 = G A^-n (n = 3, green, or 2, material) has no
// singular derivative at kappa = 0. It does have one at a = 0, where a slack cord that carries no compression gathers
// up: the bending stiffness grows like |a|^-4, beyond any time step, and were it merely kept finite, material gathered
// at a point (a = 0) would turn freely there, for |a x b| vanishes: a hinge that costs nothing. Bending theory ends
// long before. Written with B = b.b and C = a.b it is kappa^2 = A^(1-n) B - A^-n C^2; where |a| < smallest_stretch both
// powers are continued by their second-order Taylor polynomials in A about A0 = smallest_stretch^2. With y = A/A0 - 1 <
// 0 the sum is
//   kappa^2 = A0^-n [1 - n y + n (n+1)/2 y^2] G + n (n+1)/2 A0^(1-n) (-y)^3 B:
// twice continuously differentiable, an energy, bounded, and at a = 0 a multiple of B: what is gathered resists bending
// and uneven gathering like the mean-strain element, whose bending energy is that of B.
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
  // |r'| down to which the curvature is exact: beyond 10 % of compression a cord has buckled within the element.
  double smallest_stretch = 0.9;
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

  // Means over the points at which stretching is evaluated, of what these forces follow.
  struct Stretching {
    double strain = 0;
    double largest_strain = 0;  // of any of the points
    double tension = 0;         // N, negative in compression
  };
  Stretching stretching(const ElementCoordinates& q, const ElementCoordinates& velocity) const;
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
