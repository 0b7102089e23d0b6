// Gravity against its potential, and its gradient against differences of gravity.

#include "engine/orbit/gravity.h"

#include <gtest/gtest.h>

#include <cmath>

namespace netpocket {
namespace {

// m^2/s^2; the potential of the zonal harmonic J2 by its Legendre polynomial.
double potential(const Eigen::Vector3d& r, double j2) {
  const double radius = r.norm(), sine = r.z() / radius, part = kEarthRadius / radius;
  return kEarthMu / radius * (1 - j2 * part * part * 0.5 * (3 * sine * sine - 1));
}

const Eigen::Vector3d kPlace(3.1e6, -4.7e6, 4.2e6);

TEST(Gravity, IsTheSlopeOfItsPotential) {
  const double step = 100;
  for (const double j2 : {0.0, 0.01, kEarthJ2}) {
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d d = step * Eigen::Vector3d::Unit(i);
      const auto at = [&](double part) { return potential(kPlace + part * d, j2); };
      const double slope = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * step);
      EXPECT_NEAR(gravity_at(kPlace, j2)[i], slope, 2e-9);
    }
  }
}

TEST(Gravity, HasTheGradientThatDifferencesHave) {
  const double step = 1000;
  for (const double j2 : {0.0, 0.01, kEarthJ2}) {
    const Eigen::Matrix3d gradient = gravity_gradient_at(kPlace, j2);
    for (int j = 0; j < 3; ++j) {
      const Eigen::Vector3d d = step * Eigen::Vector3d::Unit(j);
      const auto at = [&](double part) { return gravity_at(kPlace + part * d, j2); };
      const Eigen::Vector3d slope = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * step);
      EXPECT_LT((gradient.col(j) - slope).norm(), 1e-9 * gradient.norm());
    }
    EXPECT_LT((gradient - gradient.transpose()).norm(), 1e-15 * gradient.norm());
    EXPECT_NEAR(gradient.trace(), 0, 1e-12 * gradient.norm()) << "Laplace's equation";
  }
}

TEST(Gravity, OfOblatenessVanishesNowhereButItsRatioIsKnown) {
  // On the equator J2 adds 3/2 J2 (R/r)^2 of the point mass's, on the axis it takes twice that away.
  const double r = 7e6, part = 1.5 * kEarthJ2 * kEarthRadius * kEarthRadius / (r * r), mass = kEarthMu / (r * r);
  EXPECT_NEAR(gravity_at({r, 0, 0}, kEarthJ2).x(), -mass * (1 + part), 1e-14 * mass);
  EXPECT_NEAR(gravity_at({0, 0, r}, kEarthJ2).z(), -mass * (1 - 2 * part), 1e-14 * mass);
}

}  // namespace
}  // namespace netpocket
