// The reference orbit against Kepler's equation, an integration of another kind, and the drift of nodes.

#include "engine/orbit/reference_orbit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/orbit/gravity.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using State = ReferenceOrbit::State;
constexpr OrbitElements kLow{.perigee_radius = 6.778e6, .inclination = 0.9, .argument_of_perigee = 0.3};

class VerificationOrbit : public test::VerificationTest {};

double period_of(double semi_major_axis) {
  return 2 * std::numbers::pi * std::sqrt(std::pow(semi_major_axis, 3) / kEarthMu);
}

// Position on an ellipse in its plane `time` after the perigee, by Kepler's equation.
Eigen::Vector2d kepler(double a, double e, double time) {
  const double mean = 2 * std::numbers::pi * time / period_of(a);
  double eccentric = mean;
  for (int i = 0; i < 50; ++i) {
    eccentric -= (eccentric - e * std::sin(eccentric) - mean) / (1 - e * std::cos(eccentric));
  }
  return {a * (std::cos(eccentric) - e), a * std::sqrt(1 - e * e) * std::sin(eccentric)};
}

// Classical Runge-Kutta of order 4 in steps of `step` (s): another method than the orbit's.
State integrate(State s, double time, double step, double j2) {
  const auto f = [j2](const Eigen::Vector3d& r) { return gravity_at(r, j2); };
  const int count = static_cast<int>(std::lround(time / step));
  const double h = time / count;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d v1 = s.velocity, a1 = f(s.position);
    const Eigen::Vector3d v2 = s.velocity + 0.5 * h * a1, a2 = f(s.position + 0.5 * h * v1);
    const Eigen::Vector3d v3 = s.velocity + 0.5 * h * a2, a3 = f(s.position + 0.5 * h * v2);
    const Eigen::Vector3d v4 = s.velocity + h * a3, a4 = f(s.position + h * v3);
    s.position += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    s.velocity += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return s;
}

TEST_F(VerificationOrbit, FollowsKeplersEquation) {
  for (const double e : {0.0, 0.3, 0.9}) {
    const OrbitElements elements{.perigee_radius = 7e6, .eccentricity = e};
    const double a = elements.perigee_radius / (1 - e), period = period_of(a);
    ReferenceOrbit orbit(orbit_of(elements, OrbitField::two_body, LocalAxis::h_bar, LocalAxis::v_bar));
    double worst = 0;
    for (int i = 1; i <= 97; ++i) {
      const double time = period * i / 97;
      const Eigen::Vector3d place = orbit.at(time).position;
      worst = std::max(worst, (place.head<2>() - kepler(a, e, time)).norm() / a);
      EXPECT_EQ(place.z(), 0);
    }
    expect_below(e == 0     ? "two-body orbit, circular: largest error in one period / a"
                 : e == 0.3 ? "two-body orbit, e = 0.3: largest error in one period / a"
                            : "two-body orbit, e = 0.9: largest error in one period / a",
                 worst, 1e-8, "Kepler's equation, solved by Newton's method; 1e-12 per step allowed, some 100 steps");
  }
}

TEST(ReferenceOrbit, OnACircleIsTheSameInClosedForm) {
  ReferenceOrbit hill(orbit_of(kLow, OrbitField::hill, LocalAxis::h_bar, LocalAxis::v_bar));
  ReferenceOrbit other(orbit_of(kLow, OrbitField::two_body, LocalAxis::h_bar, LocalAxis::v_bar));
  for (double time = 0; time < 6000; time += 333) {
    EXPECT_LT((hill.at(time).position - other.at(time).position).norm(), 0.02);
    EXPECT_LT((hill.at(time).velocity - other.at(time).velocity).norm(), 2e-5);
    EXPECT_LT((hill.tide(time) - other.tide(time)).norm(), 1e-8 * hill.tide(time).norm());
  }
}

TEST_F(VerificationOrbit, AboutAnOblateEarthAgreesWithAnotherMethod) {
  OrbitElements elements = kLow;
  elements.eccentricity = 0.05;
  const Orbit orbit = orbit_of(elements, OrbitField::two_body_j2, LocalAxis::h_bar, LocalAxis::v_bar);
  ReferenceOrbit ours(orbit);
  const double time = 5800;
  const State other = integrate({orbit.position, orbit.velocity}, time, 0.5, kEarthJ2);
  expect_below("J2 orbit after 5800 s: distance from another integration, m",
               (ours.at(time).position - other.position).norm(), 0.05,
               "classical Runge-Kutta with steps of 0.5 s, error below 1e-5 m; ours may err by 1e-12 R a step");
}

// The ascending node moves between two passages by what the theory of first order has.
TEST_F(VerificationOrbit, NodeDriftsAsTheFirstOrderTheorySays) {
  OrbitElements elements{.perigee_radius = 7e6, .eccentricity = 0.01, .inclination = 0.9};
  ReferenceOrbit orbit(orbit_of(elements, OrbitField::two_body_j2, LocalAxis::h_bar, LocalAxis::v_bar));
  const auto height = [&](double time) { return orbit.at(time).position.z(); };
  const auto passage = [&](double low, double high) {
    for (int i = 0; i < 60; ++i) (height(0.5 * (low + high)) < 0 ? low : high) = 0.5 * (low + high);
    return 0.5 * (low + high);
  };
  const auto longitude = [&](double time) {
    const Eigen::Vector3d r = orbit.at(time).position;
    return std::atan2(r.y(), r.x());
  };
  const double a = elements.perigee_radius / (1 - elements.eccentricity), period = period_of(a);
  const double first = passage(0.9 * period, 1.1 * period), last = passage(10.9 * period, 11.1 * period);
  const double p = a * (1 - elements.eccentricity * elements.eccentricity);
  const double theory = -1.5 * (2 * std::numbers::pi / period) * kEarthJ2 * std::pow(kEarthRadius / p, 2) *
                        std::cos(elements.inclination);
  expect_relative("drift of the ascending node by J2 over ten orbits, rad/s",
                  (longitude(last) - longitude(first)) / (last - first), theory, 6e-3,
                  "-3/2 n J2 (R/p)^2 cos i, Vallado (2013), eq. 9-37; terms of order J2 (0.1 %), with osculating for "
                  "mean elements, are left out");
}

TEST(ReferenceOrbit, TurnsItsLocalAxesAsItSays) {
  OrbitElements elements = kLow;
  elements.eccentricity = 0.2;
  ReferenceOrbit orbit(orbit_of(elements, OrbitField::two_body_j2, LocalAxis::minus_r_bar, LocalAxis::v_bar));
  EXPECT_LT((orbit.local_axes(0).col(1) + Eigen::Vector3d::UnitX()).norm(), 1e-14);
  EXPECT_LT((orbit.local_axes(0).col(0) - Eigen::Vector3d::UnitY()).norm(), 1e-14);
  for (const double time : {100.0, 2000.0}) {
    const double h = 0.5;
    const Eigen::Matrix3d slope = (orbit.local_axes(time + h) - orbit.local_axes(time - h)) / (2 * h);
    const Eigen::Matrix3d axes = orbit.local_axes(time);
    EXPECT_LT((axes.transpose() * axes - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_NEAR(axes.determinant(), -1, 1e-14) << "V-bar x H-bar is R-bar";
    const Eigen::Vector3d turning = orbit.turning(time);
    for (int i = 0; i < 3; ++i) EXPECT_LT((turning.cross(axes.col(i)) - slope.col(i)).norm(), 1e-9);
    EXPECT_GT(turning.norm(), 7e-4);
  }
}

TEST(ReferenceOrbit, DoesNotDependOnWhatWasAskedBefore) {
  const Orbit orbit = orbit_of(kLow, OrbitField::two_body_j2, LocalAxis::h_bar, LocalAxis::v_bar);
  ReferenceOrbit often(orbit), once(orbit), back(orbit);
  for (double time = 0; time < 1000; time += 0.37) often.at(time);
  back.at(5000);
  const State expected = once.at(777.7);
  EXPECT_EQ(often.at(777.7).position, expected.position);
  EXPECT_EQ(back.at(777.7).position, expected.position);
  EXPECT_EQ(back.at(777.7).velocity, expected.velocity);
}

TEST(ReferenceOrbit, RefusesParallelAxes) {
  const Orbit orbit = orbit_of(kLow, OrbitField::hill, LocalAxis::v_bar, LocalAxis::minus_v_bar);
  EXPECT_THROW(ReferenceOrbit{orbit}, std::invalid_argument);
}

}  // namespace
}  // namespace netpocket
