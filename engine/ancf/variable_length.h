#pragma once
// Inertia of an element whose material is wound in or out at its ends (mass flow), with lumped mass as in mass.h. Each
// node carries half of the material now inside, which moves past it along the chord:
//   v_i = dr_i/dt - dp_i/dt e,   e = (r2 - r1)/L
//   T = m L/4 (v1.v1 + v2.v2) + m L^3/156 (dg1/dt.dg1/dt + dg2/dt.dg2/dt)
// dp_i/dt is prescribed, so that T depends on time by itself, and Lagrange's equations d/dt dT/dqd - dT/dq = Q are
// d'Alembert's principle for the material now inside (Tang et al. (2023) Eqs. 8 to 15, with the full Sd of
// material_span.h) integrated by the trapezoidal rule. Because T does not change when everything is shifted or turned,
// they keep linear and angular momentum exactly, and the power of what winds the material is known exactly.
//
// The internal forces of such an element are those of MeanStrainElement or FullElement with the same MaterialSpan.
// SI units, world frame.

#include "engine/ancf/material_span.h"

namespace netpocket {

// T. J
double kinetic_energy(double mass_per_length, const MaterialSpan& span, const ElementCoordinates& q,
                      const ElementCoordinates& velocity);

// dT/dqd less lumped mass * velocity: the momentum of the flow past the nodes. N s
ElementCoordinates flow_momentum(double mass_per_length, const MaterialSpan& span, const ElementCoordinates& q);

// dT/dq: the momentum that the flow carries from one node to the other. N
ElementCoordinates flow_force(double mass_per_length, const MaterialSpan& span, const ElementCoordinates& q,
                              const ElementCoordinates& velocity);

// 2 T - velocity.dT/dqd. With it the power that forces Q and what winds the material put in is
//   dT/dt = Q.velocity + d(flow_work)/dt - (dT/dt at fixed q and velocity). J
double flow_work(double mass_per_length, const MaterialSpan& span, const ElementCoordinates& q,
                 const ElementCoordinates& velocity);

}  // namespace netpocket
