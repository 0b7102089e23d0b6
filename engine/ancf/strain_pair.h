#pragma once
// Two mean-strain elements in a row on one cord that share their axial strain.
//
// The shortest waves of stretching, in which the node between two elements of a mesh side moves against its neighbours,
// limit the step of explicit integration, although they mean nothing: they are far shorter than what the mesh resolves.
// As the mean-strain element averages its strain over its own length, so a pair averages over both: of the mean
// eps = (eps_1 + eps_2)/2 and the difference delta = eps_1 - eps_2 of two elements of the same length L and section,
//   U = EA L (eps^2 + alpha delta^2/4),   hence tensions N_1 = EA (eps + alpha delta/2), N_2 = EA (eps - alpha
//   delta/2).
// alpha = 1 gives two separate elements. Smaller values lower the frequency of the node between by sqrt(alpha); a cord
// loaded at its ends only, whose strain is uniform, does not notice, nor do mass and momentum. Of selective scaling
// (Olovsson, Simonsson & Unosson 2005, doi:10.1002/nme.1293) it is the counterpart that scales stiffness, not mass: the
// mass matrix stays diagonal. Both elements must carry full compression, so that U has no jump.
//
// Of the mass of the node between, m L, a fifth goes to the pair's ends in equal parts. Then a taut side's first
// vibration across, in which that node swings between knots at rest, has the string's frequency: w^2 = 2 T/(0.8 m
// L^2), 1.58^2 instead of (pi/2)^2 T/(m L^2), where with the whole mass it is 10 % too slow; and the node moves the
// more easily along the cord, so that the ends limit the step less. Mass and its centre are unchanged.

namespace netpocket {

inline constexpr double kPairVariation = 0.15;  // alpha
inline constexpr double kMovedMass = 0.2;       // part of the middle node's mass that goes to the ends

// Strain that an element of a pair reacts to: N = EA kOwn eps_own + EA kMate eps_mate.
inline constexpr double kOwnShare = (1 + kPairVariation) / 2;
inline constexpr double kPartnerShare = (1 - kPairVariation) / 2;

// Moves mass, or weights of a load, from an element's end at its strain partner to its other end.
template <typename Weights>
void move_from_middle(Weights& weights, bool middle_is_second) {
  const int middle = middle_is_second ? 2 : 0;  // as the corners of ElementCoordinates
  const double moved = kMovedMass * weights[middle];
  weights[middle] -= moved;
  weights[2 - middle] += moved;
}

inline constexpr double paired_strain(double own, double strain_partner) {
  return kOwnShare * own + kPartnerShare * strain_partner;
}

}  // namespace netpocket
