#pragma once
// Correction of the bending of an inflated rod's element that may wrinkle (wrinkling.h), to be added to the linear law
// of mean_strain_element.h or full_element.h. It uses the curvature of that evaluation, so that both together have the
// energy int W(kappa) dp. Pure functions; SI units, world frame.

#include <optional>

#include "engine/math/vector.h"

namespace netpocket {

struct InflatedSection {
  double EI;      // N m^2, before wrinkling
  double moment;  // N m, wrinkling moment
};

struct Softening {
  double energy = 0;                                      // J, difference from the linear law, <= 0
  ElementCoordinates force = ElementCoordinates::Zero();  // N and N m: -d(energy)/dq
};

// Correction for the mean-strain element. It uses the root mean square curvature, kappa^2 = (s.s + 3 a.a)/L^2 with
// s = g1 - g2 and a = g1 + g2 - 2 e, whose linear energy EI L kappa^2/2 is that of the mean-strain element. Empty if
// the element does not wrinkle.
std::optional<Softening> mean_strain_softening(const InflatedSection& section, double length,
                                               const ElementCoordinates& q);

// Correction for the full element (Green strain). It uses the curvature at each integration point. Empty if the element
// does not wrinkle.
std::optional<Softening> full_softening(const InflatedSection& section, double length, const ElementCoordinates& q);

}  // namespace netpocket
