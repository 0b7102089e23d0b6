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

namespace netpocket {

inline constexpr double kPairVariation = 0.25;  // alpha

// Strain that an element of a pair reacts to: N = EA kOwn eps_own + EA kMate eps_mate.
inline constexpr double kOwnShare = (1 + kPairVariation) / 2;
inline constexpr double kMateShare = (1 - kPairVariation) / 2;

inline constexpr double paired_strain(double own, double mate) { return kOwnShare * own + kMateShare * mate; }

}  // namespace netpocket
