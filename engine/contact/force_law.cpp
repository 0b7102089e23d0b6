#include "engine/contact/force_law.h"

#include <numbers>

#include "engine/math/power.h"

namespace netpocket {

double effective_modulus(const ElasticMaterial& a, const ElasticMaterial& b) {
  const auto compliance = [](const ElasticMaterial& m) {
    return (1 - m.poisson_ratio * m.poisson_ratio) / m.youngs_modulus;
  };
  return 1 / (compliance(a) + compliance(b));
}

double effective_radius(double r1, double r2) { return 1 / (1 / r1 + 1 / r2); }

double effective_mass(double m1, double m2) { return 1 / (1 / m1 + 1 / m2); }

double hertz_stiffness(double effective_modulus, double effective_radius) {
  return 4.0 / 3.0 * effective_modulus * std::sqrt(effective_radius);
}

double restitution_damping(double restitution) {
  const double c = std::clamp(restitution, 0.0, 1.0);
  if (c == 0) return std::sqrt(5.0);
  const double log_c = logarithm(c);
  return -std::sqrt(5.0) * log_c / hypotenuse(log_c, std::numbers::pi);
}

NormalLaw make_normal_law(double hertz_stiffness, double restitution, double effective_mass) {
  return {hertz_stiffness, restitution_damping(restitution) * std::sqrt(hertz_stiffness * effective_mass)};
}

}  // namespace netpocket
