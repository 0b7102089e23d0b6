#pragma once
// Cable element with one axial strain: the reference form of the mean-strain evaluation.
//
// With the chord gradient e = (r2 - r1)/L and the deviations of the nodes' gradients from it, h1 = g1 - e and
// h2 = g2 - e, the mean of the Green strain (r'.r' - 1)/2 over the element is
//   eps = (e.e + (2 h1.h1 - h1.h2 + 2 h2.h2)/15 - 1)/2,
// and the bending energy EI/2 int r''.r'' dp, which equals that of the curvature where r' has unit length, is
//   2 EI/L (h1.h1 + h1.h2 + h2.h2).
// Both integrals are exact and need no quadrature. Averaging the strain removes membrane locking, as reduced
// integration does (Gerstmayr & Shabana 2006, doi:10.1007/s11071-006-1856-1). The constant bending matrix is model T1
// of Berzeri & Shabana (2000), Journal of Sound and Vibration 235(4).
//
// Damping. The axial force is N = EA (eps + c deps/dt). Bending splits into the modes s = h1 - h2 (even) and
// a = h1 + h2 (odd) with the energy EI/(2L) (s.s + 3 a.a). Only the rates of |s| and |a| are damped. So rigid-body
// motion is not damped, and damping never adds energy.
//
// Forces resist: M qdd + internal_force = applied force. Values are in SI units and the world frame.

#include "engine/ancf/cable_section.h"
#include "engine/ancf/material_span.h"

namespace netpocket {

class MeanStrainElement {
 public:
  MeanStrainElement(const CableSection& section, const MaterialSpan& span) : section_(section), span_(span) {}

  double strain(const ElementCoordinates& q) const;
  // Total time derivative (1/s) of `strain`, including the part due to a changing length.
  double strain_rate(const ElementCoordinates& q, const ElementCoordinates& velocity) const;
  // Axial force (N), damping included.
  double tension(const ElementCoordinates& q, const ElementCoordinates& velocity) const;

  double axial_energy(const ElementCoordinates& q) const;    // J
  double bending_energy(const ElementCoordinates& q) const;  // J
  ElementCoordinates internal_force(const ElementCoordinates& q, const ElementCoordinates& velocity) const;
  // The same with a given axial force `tension` (N), e.g. that of a strain pair (strain_pair.h).
  ElementCoordinates internal_force(const ElementCoordinates& q, const ElementCoordinates& velocity,
                                    double tension) const;
  // Derivative of the elastic force with respect to q; symmetric.
  ElementTangent tangent(const ElementCoordinates& q) const;

  // Power (W) that damping turns into heat, >= 0.
  double dissipated_power(const ElementCoordinates& q, const ElementCoordinates& velocity) const;
  // Power (W) that the change of material length puts into the element against its internal force:
  //   d(energy)/dt = internal_force.velocity - dissipated_power + feeding_power
  double feeding_power(const ElementCoordinates& q, const ElementCoordinates& velocity) const;

 private:
  CableSection section_;
  MaterialSpan span_;
};

}  // namespace netpocket
