// The bending law of inflated tubes against a section of fibres.

#include "engine/ancf/wrinkling.h"

#include <array>
#include <cmath>
#include <numbers>

#include "element_checks.h"
#include "engine/ancf/inflated_element.h"

namespace netpocket {
namespace {

using namespace test;

class VerificationWrinkling : public VerificationTest {};

constexpr double kPi = std::numbers::pi;

// A tube of r = 1, E t = 1 under p = 1 as 20000 fibres without compression: its axial strain is sought for which they
// carry p pi r^2. M_w = pi/2, kappa_w = p/(2 E t) = 1/2.
double fibre_moment(double k) {
  const int fibres = 20000;
  const double curvature = 0.5 * k;
  const auto sums = [&](double axial) {
    double force = 0, moment = 0;
    for (int i = 0; i < fibres; ++i) {
      const double height = std::cos(2 * kPi * (i + 0.5) / fibres);
      const double stress = std::max(axial + curvature * height, 0.0);
      force += stress * 2 * kPi / fibres;
      moment += stress * height * 2 * kPi / fibres;
    }
    return std::pair(force, moment);
  };
  double low = -curvature, high = 1;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (sums(middle).first < kPi ? low : high) = middle;
  }
  return sums(low).second / (kPi / 2);
}

TEST_F(VerificationWrinkling, MomentIsThatOfASectionOfFibres) {
  for (const double k : {0.5, 1.0, 1.2, 2.0, 5.0, 20.0}) {
    expect_relative("moment / wrinkling moment at " + std::to_string(k).substr(0, 4) + " times the wrinkling curvature",
                    InflatedBending(k).moment, fibre_moment(k), 1e-5,
                    "section of 20000 fibres that carry no compression under p pi r^2");
  }
  expect_relative("moment / wrinkling moment, wall slack half round", InflatedBending(kPi).moment, kPi / 2, 1e-12,
                  "Comer & Levy (1963) at theta_0 = 90 degrees: M = pi^2 p r^3/4");
  expect_relative("ultimate moment / wrinkling moment", InflatedBending(1e9).moment, 2, 1e-3,
                  "Comer & Levy (1963): pi p r^3 against pi p r^3/2");
  expect_relative("wrinkling moment of 50 kPa in 0.1 m, N m", wrinkling_moment(5e4, 0.05), 9.81747704, 1e-8,
                  "pi p r^3/2");
}

TEST_F(VerificationWrinkling, MomentIsTheSlopeOfTheEnergy) {
  double error = 0, jump = 0;
  for (const double k : {0.3, 1.05, 1.5, 3.0, 10.0, 300.0}) {
    const double slope = derivative([](double x) { return InflatedBending(x).energy; }, k, 1e-3 * k);
    error = std::max(error, std::abs(slope / InflatedBending(k).moment - 1));
  }
  for (const double k : {1.0, 1e4}) {
    jump = std::max({jump, std::abs(InflatedBending(k * (1 + 1e-9)).energy / InflatedBending(k).energy - 1),
                     std::abs(InflatedBending(k * (1 + 1e-9)).moment / InflatedBending(k).moment - 1)});
  }
  expect_error_below("slope of the energy / moment - 1", error, 1e-7);
  expect_error_below("jump where the formulas change", jump, 1e-8);
}

TEST_F(VerificationWrinkling, ElementsForceIsTheGradientOfItsEnergy) {
  const InflatedSection section{.EI = 3, .moment = 0.4};
  const double length = 0.7;
  RandomStates random;
  double mean = 0, full = 0;
  for (int i = 0; i < 50; ++i) {
    const ElementCoordinates q = random.deformed(length, 0.3);
    const auto worst = [&](double& error, auto softening) {
      const auto energy = [&](const ElementCoordinates& x) {
        const auto softer = softening(section, length, x);
        return softer ? softer->energy : 0;
      };
      const auto softer = softening(section, length, q);
      ASSERT_TRUE(softer);
      EXPECT_LT(softer->energy, 0);
      const ElementCoordinates gradient = numerical_gradient(energy, q, length, 1e-4);
      error = std::max(error, relative_error(ElementCoordinates(-softer->force), gradient));
    };
    worst(mean, mean_strain_softening);
    worst(full, full_softening);
  }
  // The third derivative of the energy jumps where wrinkling begins.
  expect_error_below("wrinkled element, mean-strain: force against differences of the energy", mean, 1e-6);
  expect_error_below("wrinkled element, full: force against differences of the energy", full, 1e-6);
}

}  // namespace
}  // namespace netpocket
