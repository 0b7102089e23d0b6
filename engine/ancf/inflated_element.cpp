#include "engine/ancf/inflated_element.h"

#include <cmath>

#include "engine/ancf/quadrature.h"
#include "engine/ancf/shape_functions.h"
#include "engine/ancf/strain_measure.h"
#include "engine/ancf/wrinkling.h"

namespace netpocket {
namespace {

// Difference from the linear law at one curvature: of the energy per length, and of the secant stiffness,
// EI (1 - M/(EI kappa)).
struct Loss {
  Loss(const InflatedSection& section, double kappa) {
    const double k = kappa * section.EI / section.moment;
    if (!(k > 1)) return;
    const InflatedBending bending(k);
    energy = (bending.energy - k * k / 2) * section.moment * section.moment / section.EI;
    stiffness = section.EI * (1 - bending.moment / k);
  }

  double energy = 0;     // N
  double stiffness = 0;  // N m^2
};

}  // namespace

std::optional<Softening> mean_strain_softening(const InflatedSection& section, double length,
                                               const ElementCoordinates& q) {
  const Eigen::Vector3d e = (q.col(2) - q.col(0)) / length;
  const Eigen::Vector3d s = q.col(1) - q.col(3), a = (q.col(1) + q.col(3)) - 2 * e;
  const Loss loss(section, std::sqrt(squared_norm(s) + 3 * squared_norm(a)) / length);
  if (loss.stiffness == 0) return std::nullopt;
  const Eigen::Vector3d moment_s = loss.stiffness / length * s, moment_a = 3 * loss.stiffness / length * a;
  Softening result;
  result.energy = loss.energy * length;
  result.force << (2 / length) * moment_a, moment_s + moment_a, (-2 / length) * moment_a, moment_a - moment_s;
  return result;
}

std::optional<Softening> full_softening(const InflatedSection& section, double length, const ElementCoordinates& q) {
  Softening result;
  for (const auto& [xi, weight] : kGauss3) {
    const NodalWeights slope = shape_p(xi, length), bend = shape_pp(xi, length);
    const SquaredCurvature curvature(combine(q, slope), combine(q, bend), FullElementOptions());
    const Loss loss(section, std::sqrt(curvature.value));
    if (loss.stiffness == 0) continue;
    result.energy += weight * length / 2 * loss.energy;
    // Because d(kappa^2)/2 = kappa d(kappa), the factor contains the secant stiffness.
    const double factor = weight * length / 4 * loss.stiffness;
    for (int i = 0; i < 4; ++i) {
      result.force.col(i) += factor * (slope[i] * curvature.gradient_a + bend[i] * curvature.gradient_b);
    }
  }
  if (result.energy == 0) return std::nullopt;
  return result;
}

}  // namespace netpocket
