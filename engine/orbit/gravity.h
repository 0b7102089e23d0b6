#pragma once
// Gravity of the Earth and its gradient: a point mass, or with the oblateness J2. Earth-centred inertial axes, z along
// the Earth's axis, SI units. Pure functions.
//
// With r from the Earth's centre and k = -3/2 J2 mu R_e^2:
//   a = -mu r/|r|^3 + k/|r|^5 [r (1 - 5 z^2/|r|^2) + 2 z e_z]
// Source: Vallado, Fundamentals of Astrodynamics and Applications, 4th ed. 2013, section 8.6; the same in Schaub &
// Junkins, Analytical Mechanics of Space Systems, section 12. The gradient is that expression's derivative.

#include <Eigen/Core>

namespace netpocket {

// World Geodetic System 1984 (NIMA TR8350.2): mu and R_e; J2 of the gravity model EGM96, without tides.
inline constexpr double kEarthMu = 3.986004418e14;    // m^3/s^2
inline constexpr double kEarthRadius = 6378137;       // m, at the equator
inline constexpr double kEarthJ2 = 1.08262668355e-3;  // of the radius above

// m/s^2 at `position` (m, not the centre). `j2`: 0 for a point mass.
Eigen::Vector3d gravity_at(const Eigen::Vector3d& position, double j2);
// 1/s^2: how gravity changes with the position, d a_i / d r_j. Symmetric, without trace.
Eigen::Matrix3d gravity_gradient_at(const Eigen::Vector3d& position, double j2);

}  // namespace netpocket
