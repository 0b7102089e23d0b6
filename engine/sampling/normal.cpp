#include "engine/sampling/normal.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/math/power.h"

namespace netpocket {
namespace {

using Coefficients = std::array<double, 8>;  // of a polynomial, lowest power first

double polynomial(const Coefficients& coefficients, double x) {
  double value = 0;
  for (std::size_t i = coefficients.size(); i-- > 0;) value = value * x + coefficients[i];
  return value;
}

// The coefficients are those of AS 241.
double central_quantile(double offset) {
  constexpr Coefficients kNumerator = {3.3871328727963666080e0, 1.3314166789178437745e2, 1.9715909503065514427e3,
                                       1.3731693765509461125e4, 4.5921953931549871457e4, 6.7265770927008700853e4,
                                       3.3430575583588128105e4, 2.5090809287301226727e3};
  constexpr Coefficients kDenominator = {1.0,
                                         4.2313330701600911252e1,
                                         6.8718700749205790830e2,
                                         5.3941960214247511077e3,
                                         2.1213794301586595867e4,
                                         3.9307895800092710610e4,
                                         2.8729085735721942674e4,
                                         5.2264952788528545610e3};
  const double x = 0.180625 - offset * offset;
  return offset * polynomial(kNumerator, x) / polynomial(kDenominator, x);
}

// `distance`: sqrt(-ln of the smaller tail), at most 5.
double tail_quantile(double distance) {
  constexpr Coefficients kNumerator = {1.42343711074968357734e0,  4.63033784615654529590e0, 5.76949722146069140550e0,
                                       3.64784832476320460504e0,  1.27045825245236838258e0, 2.41780725177450611770e-1,
                                       2.27238449892691845833e-2, 7.74545014278341407640e-4};
  constexpr Coefficients kDenominator = {1.0,
                                         2.05319162663775882187e0,
                                         1.67638483018380384940e0,
                                         6.89767334985100004550e-1,
                                         1.48103976427480074590e-1,
                                         1.51986665636164571966e-2,
                                         5.47593808499534494600e-4,
                                         1.05075007164441684324e-9};
  return polynomial(kNumerator, distance - 1.6) / polynomial(kDenominator, distance - 1.6);
}

// The same beyond 5.
double far_tail_quantile(double distance) {
  constexpr Coefficients kNumerator = {6.65790464350110377720e0,  5.46378491116411436990e0,  1.78482653991729133580e0,
                                       2.96560571828504891230e-1, 2.65321895265761230930e-2, 1.24266094738807843860e-3,
                                       2.71155556874348757815e-5, 2.01033439929228813265e-7};
  constexpr Coefficients kDenominator = {1.0,
                                         5.99832206555887937690e-1,
                                         1.36929880922735805310e-1,
                                         1.48753612908506148525e-2,
                                         7.86869131145613259100e-4,
                                         1.84631831751005468180e-5,
                                         1.42151175831644588870e-7,
                                         2.04426310338993978564e-15};
  return polynomial(kNumerator, distance - 5) / polynomial(kDenominator, distance - 5);
}

double density(double x) { return power(std::numbers::e, -x * x / 2) / std::sqrt(2 * std::numbers::pi); }

// Probability between 0 and x, for small |x|: Abramowitz & Stegun (1964), eq. 26.2.11.
double probability_from_middle(double x) {
  double term = x, sum = 0;
  for (int odd = 3; sum + term != sum; odd += 2) {
    sum += term;
    term *= x * x / odd;
  }
  return density(x) * sum;
}

// Probability above x, for x >= 2: Laplace's continued fraction, Abramowitz & Stegun (1964), eq. 26.2.14.
double upper_tail(double x) {
  constexpr int kTerms = 150;  // enough for 1e-16 at x = 2
  double fraction = x;
  for (int i = kTerms; i > 0; --i) fraction = x + i / fraction;
  return density(x) / fraction;
}

}  // namespace

double normal_cumulative(double x) {
  constexpr double kTail = 2;
  constexpr double kNothing = 38;  // where the density is no longer a normal number
  if (x < -kNothing) return 0;
  if (x > kNothing) return 1;
  if (x < -kTail) return upper_tail(-x);
  if (x > kTail) return 1 - upper_tail(x);
  return 0.5 + probability_from_middle(x);
}

double normal_quantile(double fraction) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (fraction == 0) return -kInfinity;
  if (fraction == 1) return kInfinity;
  if (!(fraction > 0 && fraction < 1)) return std::numeric_limits<double>::quiet_NaN();
  const double offset = fraction - 0.5;
  if (std::abs(offset) <= 0.425) return central_quantile(offset);
  const double distance = std::sqrt(-logarithm(offset < 0 ? fraction : 1 - fraction));
  const double size = distance <= 5 ? tail_quantile(distance) : far_tail_quantile(distance);
  return offset < 0 ? -size : size;
}

}  // namespace netpocket
