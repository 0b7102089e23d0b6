#pragma once
// Bending of an inflated membrane tube: Comer & Levy (1963), AIAA Journal 1(7), doi:10.2514/3.1873.
//
// The wall carries no compression. Up to the wrinkling moment M_w = pi p r^3/2, the pressure keeps the whole wall in
// tension and the tube bends like a beam, M = EI kappa. Beyond it, the wall is slack over an angle 2 theta_0. With
// u = pi - theta_0 and kappa_w = M_w/EI,
//   kappa/kappa_w = pi/(sin u - u cos u),      M/M_w = (2 u - sin 2 u)/(2 (sin u - u cos u)).
// The moment tends to the ultimate moment 2 M_w = pi p r^3 as the slack part grows to the whole circumference.
// With k = kappa/kappa_w the energy per length (that of the wall less the work of the pressure) is M_w kappa_w times
//   1 + k^2 (u cos^2 u + u/2 - 3/4 sin 2u)/pi + 2 k cos u.

namespace netpocket {

// Wrinkling moment of a tube of mean radius `radius` (m) under `pressure` (Pa), N m.
double wrinkling_moment(double pressure, double radius);

// Moment and energy at the curvature k = kappa/kappa_w >= 0.
struct InflatedBending {
  explicit InflatedBending(double k);

  double moment;  // M/M_w
  double energy;  // per length, divided by M_w kappa_w
};

}  // namespace netpocket
