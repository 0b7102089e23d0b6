#pragma once
// The interval of material [p1, p2] inside an element, and its change while retractors wind material in or out.
//
// A material point keeps its p, while its xi and the element's length change in time. With S(xi, L):
//   r     = S q
//   dr/dt = S qd + Sd q,              Sd  = S_xi xid + S_L Ld
//   d2r/dt2 = S qdd + 2 Sd qd + Sdd q,  Sdd = S_xixi xid^2 + 2 S_xiL xid Ld + S_xi xidd + S_L Ldd   (S_LL = 0)
// Tang et al. (2023) Eqs. 5 to 7. Their Eq. 7 omits the terms with S_L; without these a rope that is reeled in without
// strain would accelerate. The full form is that of arbitrary Lagrangian-Eulerian ANCF cables: Hong & Ren (2011),
// Multibody System Dynamics 26(1). SI units.

#include "engine/math/vector.h"

namespace netpocket {

struct MaterialSpan {
  double length = 0;              // m, L = p2 - p1 > 0
  double start_rate = 0;          // m/s, dp1/dt: positive where material leaves at node 1
  double end_rate = 0;            // m/s, dp2/dt: positive where material enters at node 2
  double start_acceleration = 0;  // m/s^2
  double end_acceleration = 0;    // m/s^2

  bool operator==(const MaterialSpan&) const = default;
  double length_rate() const { return end_rate - start_rate; }
  double length_acceleration() const { return end_acceleration - start_acceleration; }
  double xi_rate(double xi) const;          // 1/s, at fixed material point
  double xi_acceleration(double xi) const;  // 1/s^2, at fixed material point
};

NodalWeights shape_rate(double xi, const MaterialSpan& span);          // Sd
NodalWeights shape_acceleration(double xi, const MaterialSpan& span);  // Sdd
NodalWeights shape_p_rate(double xi, const MaterialSpan& span);        // d(dS/dp)/dt at fixed material point
NodalWeights shape_pp_rate(double xi, const MaterialSpan& span);       // d(d2S/dp2)/dt at fixed material point

// Velocity (m/s) and acceleration (m/s^2) of the material point that is at xi now, world frame.
Eigen::Vector3d material_velocity(double xi, const MaterialSpan& span, const ElementCoordinates& q,
                                  const ElementCoordinates& velocity);
Eigen::Vector3d material_acceleration(double xi, const MaterialSpan& span, const ElementCoordinates& q,
                                      const ElementCoordinates& velocity, const ElementCoordinates& acceleration);

}  // namespace netpocket
