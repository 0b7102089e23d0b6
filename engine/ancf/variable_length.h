#pragma once
// Inertia of an element whose material is wound in or out at its ends (mass flow), with the lumped mass of mass.h. Each
// node carries half of the material that is now inside. This material moves past the node along the chord:
//   v_i = dr_i/dt - dp_i/dt e,   e = (r2 - r1)/L
//   T = m L/4 (v1.v1 + v2.v2) + m L^3/156 (dg1/dt.dg1/dt + dg2/dt.dg2/dt)
// dp_i/dt is prescribed, so T depends explicitly on time. Lagrange's equations d/dt dT/dqd - dT/dq = Q are d'Alembert's
// principle for the material now inside (Tang et al. (2023) Eqs. 8 to 15, with the full Sd of material_span.h),
// integrated by the trapezoidal rule. T is invariant under translation and rotation of the whole. So linear and angular
// momentum are conserved exactly, and the power of the winding is known exactly.
//
// The internal forces of such an element are those of MeanStrainElement or FullElement with the same MaterialSpan.
// SI units, world frame.

#include "engine/ancf/material_span.h"

namespace netpocket {

// Kinetic energy T, J.
double kinetic_energy(double mass_per_length, const MaterialSpan& span, const ElementCoordinates& q,
                      const ElementCoordinates& velocity);

// dT/dqd - lumped mass * velocity (N s): the momentum of the flow past the nodes.
ElementCoordinates flow_momentum(double mass_per_length, const MaterialSpan& span, const ElementCoordinates& q);

// dT/dq (N): the momentum per time that the flow carries from one node to the other.
ElementCoordinates flow_force(double mass_per_length, const MaterialSpan& span, const ElementCoordinates& q,
                              const ElementCoordinates& velocity);

// 2 T - velocity.dT/dqd, J. It gives the power that the forces Q and the winding put in:
//   dT/dt = Q.velocity + d(flow_work)/dt - (dT/dt at fixed q and velocity)
double flow_work(double mass_per_length, const MaterialSpan& span, const ElementCoordinates& q,
                 const ElementCoordinates& velocity);

}  // namespace netpocket
