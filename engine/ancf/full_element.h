#pragma once
// Cable element whose strain and curvature are integrated along its length: the reference evaluation (Tang et al. 2023,
// Eqs. 10 to 15). The strain energy is 1/2 int (EA eps^2 + EI kappa^2) dp, with 5 Gauss points for the axial and 3 for
// the bending part. The internal damping is EA (eps + c deps/dt) and EI (kappa + c dkappa/dt).
//
// Curvature. With a = r', b = r'', A = a.a and G = |a x b|^2, kappa^2 = G A^-n (n = 3 for green, 2 for material) has no
// singular derivative at kappa = 0. It has one at a = 0, which a slack cord without compression approaches where its
// material gathers. The bending stiffness grows there like |a|^-4, beyond any time step. Merely bounding it would not
// do: at a = 0, |a x b| vanishes, so gathered material would turn freely like a hinge without stiffness. Bending theory
// is not valid there anyway. Therefore, with B = b.b and C = a.b, the curvature is written as
//   kappa^2 = A^(1-n) B - A^-n C^2.
// Where |a| < smallest_stretch, both powers are replaced by their second-order Taylor polynomials in A about
// A0 = smallest_stretch^2. With y = A/A0 - 1 < 0 the sum is
//   kappa^2 = A0^-n [1 - n y + n (n+1)/2 y^2] G + n (n+1)/2 A0^(1-n) (-y)^3 B.
// It is twice continuously differentiable, bounded, and defines an energy. At a = 0 it is a multiple of B. So gathered
// material resists bending and uneven gathering like the mean-strain element, whose bending energy is that of B.
//
// Forces resist: M qdd + internal_force = applied force. SI units, world frame. While material is wound in or out
// (MaterialSpan), strain rates are those of material points.

#include "engine/ancf/cable_section.h"
#include "engine/ancf/material_span.h"

namespace netpocket {

enum class StrainMeasure {
  green,    // eps = (r'.r' - 1)/2, kappa = |r' x r''|/|r'|^3: Gerstmayr & Shabana (2006), doi:10.1007/s11071-006-1856-1
  material  // eps = |r'| - 1, K = |r' x r''|/|r'|^2: Gerstmayr & Irschik (2008), Journal of Sound and Vibration 318
};

struct FullElementOptions {
  StrainMeasure measure = StrainMeasure::green;
  // Smallest |r'| for which the curvature is exact. Beyond 10 % of compression a cord has buckled within the element.
  double smallest_stretch = 0.9;
};

class FullElement {
 public:
  FullElement(const CableSection& section, const MaterialSpan& span, const FullElementOptions& options = {})
      : section_(section), span_(span), options_(options) {}

  // Axial force (N) at xi, with damping. It is conjugate to the chosen strain measure.
  double tension(double xi, const ElementCoordinates& q, const ElementCoordinates& velocity) const;

  double axial_energy(const ElementCoordinates& q) const;    // J
  double bending_energy(const ElementCoordinates& q) const;  // J
  ElementCoordinates internal_force(const ElementCoordinates& q, const ElementCoordinates& velocity) const;
  // Derivative of the elastic force with respect to q; exact and symmetric.
  ElementTangent tangent(const ElementCoordinates& q) const;

  // Means over the element at the Gauss points of the axial part.
  struct Stretching {
    double strain = 0;
    double largest_strain = 0;  // at any Gauss point
    double tension = 0;         // N, negative in compression
  };
  Stretching stretching(const ElementCoordinates& q, const ElementCoordinates& velocity) const;
  // Power (W) that damping turns into heat, >= 0.
  double dissipated_power(const ElementCoordinates& q, const ElementCoordinates& velocity) const;
  // Power (W) that the change of material length puts into the element against its internal force:
  //   d(energy)/dt = internal_force.velocity - dissipated_power + feeding_power
  double feeding_power(const ElementCoordinates& q, const ElementCoordinates& velocity) const;

 private:
  CableSection section_;
  MaterialSpan span_;
  FullElementOptions options_;
};

}  // namespace netpocket
