#pragma once
// Cross-section of a cable: the material properties that the element formulas need.

namespace netpocket {

struct CableSection {
  double EA = 0;               // N, axial stiffness
  double EI = 0;               // N m^2, bending stiffness
  double mass_per_length = 0;  // kg/m
  double axial_damping = 0;    // s, c of EA (eps + c d(eps)/dt)
  double bending_damping = 0;  // s, c of EI (kappa + c d(kappa)/dt)
  double compression = 1;      // fraction of EA that acts where eps < 0: 1 = full, 0 = tension only

  // Axial stiffness at the strain `eps`, N.
  double axial_stiffness(double eps) const { return eps < 0 ? compression * EA : EA; }
};

// Bending damping acts on the rate of a magnitude, d|s|/dt = s.ds/dt / |s|, which is undefined at s = 0. Therefore the
// square of this number (s in radians) is added to s.s. Its size is the round-off of a chord's direction (1e-14 for
// positions of 10 m and elements of 0.1 m) with a margin, far below any bending that matters.
inline constexpr double kBendingRoundOff = 1e-13;

}  // namespace netpocket
