#pragma once
// An element of an inflated rod that may wrinkle (wrinkling.h): how its bending differs from the linear law of
// mean_strain_element.h or full_element.h, on the curvature of that evaluation, so that the sum is the energy
// int W(kappa) dp.

#include <optional>

#include "engine/math/vector.h"

namespace netpocket {

struct InflatedSection {
  double EI;      // N m^2, before wrinkling
  double moment;  // N m, at which it wrinkles
};

struct Softening {
  double energy = 0;                                      // J, less than the linear law's: <= 0
  ElementCoordinates force = ElementCoordinates::Zero();  // N and N m: -d(energy)/dq
};

// Of the root mean square curvature kappa^2 = (s.s + 3 a.a)/L^2, s = g1 - g2, a = g1 + g2 - 2 e, whose linear energy
// EI L kappa^2/2 is that of the mean-strain element. Nothing where it does not wrinkle.
std::optional<Softening> mean_strain_softening(const InflatedSection& section, double length,
                                               const ElementCoordinates& q);

// Of the curvature at each point of integration of the full element (Green strain). Nothing where it does not wrinkle.
std::optional<Softening> full_softening(const InflatedSection& section, double length, const ElementCoordinates& q);

}  // namespace netpocket
