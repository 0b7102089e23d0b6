#pragma once
// Inertia of an element whose material is wound in or out at its ends (mass flow): d'Alembert's principle for the
// material now inside, int rhoA S^T (S qdd + 2 Sd qd + Sdd q) dp + internal force = applied force.
// Tang et al. (2023) Eqs. 8 to 15, with the full Sd and Sdd of material_span.h. SI units, world frame.
//
// The internal forces of such an element are those of MeanStrainElement or FullElement with the same MaterialSpan.

#include "engine/ancf/material_span.h"

namespace netpocket {

// Matrices that act on each world component alike; integrated exactly.
struct SpanInertia {
  SpanInertia(double mass_per_length, const MaterialSpan& span);

  // What the flow of material adds to mass * qdd: 2 int rhoA S^T Sd dp qd + int rhoA S^T Sdd dp q.
  ElementCoordinates flow_force(const ElementCoordinates& q, const ElementCoordinates& velocity) const;

  Eigen::Matrix4d mass;           // int rhoA S^T S dp
  Eigen::Matrix4d mass_velocity;  // int rhoA S^T Sd dp
  Eigen::Matrix4d mass_position;  // int rhoA S^T Sdd dp
};

// mass * columns: generalised inertia force of accelerations, momentum of velocities.
ElementCoordinates apply(const Eigen::Matrix4d& matrix, const ElementCoordinates& columns);

// Kinetic energy of the material now inside. J
double kinetic_energy(double mass_per_length, const MaterialSpan& span, const ElementCoordinates& q,
                      const ElementCoordinates& velocity);

// Power that the flow of material brings into the element's kinetic energy T, so that
//   dT/dt = (inertia force).velocity + inertia_feeding_power. W
// It is the work of the inertia on the motion through the element, int rhoA (Sd q).a dp, and the kinetic energy that
// crosses the ends with the material, [rhoA v.v/2 dp/dt] (Reynolds' transport theorem).
double inertia_feeding_power(double mass_per_length, const MaterialSpan& span, const ElementCoordinates& q,
                             const ElementCoordinates& velocity, const ElementCoordinates& acceleration);

}  // namespace netpocket
