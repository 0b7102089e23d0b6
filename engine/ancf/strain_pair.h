#pragma once
// Two consecutive mean-strain elements of one cord that share their axial strain (strain partners).
//
// Purpose. The shortest axial waves limit the step of explicit integration. In them the node between the two elements
// of a mesh side moves against its neighbours. These waves have no physical meaning: they are far shorter than the mesh
// resolves.
//
// Strain. The mean-strain element averages its strain over its own length; a pair averages it over both lengths. With
// the mean eps = (eps_1 + eps_2)/2 and the difference delta = eps_1 - eps_2 of two elements of the same length L and
// section, the energy and the tensions are
//   U = EA L (eps^2 + alpha delta^2/4),   N_1 = EA (eps + alpha delta/2),   N_2 = EA (eps - alpha delta/2).
// alpha = 1 gives two separate elements. Smaller values lower the frequency of the middle node by sqrt(alpha). They
// change nothing in a cord that is loaded at its ends only, because its strain is uniform. Mass and momentum are
// unaffected. The method is the counterpart of selective mass scaling (Olovsson, Simonsson & Unosson 2005,
// doi:10.1002/nme.1293) that scales stiffness, so the mass matrix stays diagonal. Both elements must carry full
// compression; otherwise U would have a jump.
//
// Mass. A fifth of the middle node's mass m L goes to the ends of the pair in equal parts. Then the first transverse
// vibration of a taut side, in which the middle node swings between knots at rest, has nearly the frequency of a
// string: w^2 = 2 T/(0.8 m L^2) = 1.58^2 T/(m L^2) instead of (pi/2)^2 T/(m L^2). With the whole mass it is 10 % too
// slow. The middle node also moves more easily along the cord, so that the ends limit the step less. The total mass and
// its centre are unchanged.

namespace netpocket {

inline constexpr double kPairVariation = 0.15;  // alpha
inline constexpr double kMovedMass = 0.2;       // fraction of the middle node's mass that goes to the ends

// Weights of the strain that an element of a pair reacts to: N = EA (kOwnShare eps_own + kPartnerShare eps_partner).
inline constexpr double kOwnShare = (1 + kPairVariation) / 2;
inline constexpr double kPartnerShare = (1 - kPairVariation) / 2;

// Moves part of an element's mass (or of the weights of a load) from its end at the strain partner to its other end.
template <typename Weights>
void move_from_middle(Weights& weights, bool middle_is_second) {
  const int middle = middle_is_second ? 2 : 0;  // column of ElementCoordinates
  const double moved = kMovedMass * weights[middle];
  weights[middle] -= moved;
  weights[2 - middle] += moved;
}

inline constexpr double paired_strain(double own, double strain_partner) {
  return kOwnShare * own + kPartnerShare * strain_partner;
}

}  // namespace netpocket
