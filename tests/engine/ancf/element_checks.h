#pragma once
// Random states and finite differences for the tests of the cable elements.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstdio>
#include <random>
#include <string>

#include "engine/ancf/cable_section.h"
#include "engine/math/vector.h"
#include "tests/engine/verification_table.h"

namespace netpocket::test {

// Checks an error and keeps it in tests/VERIFICATION.md.
inline void expect_error_below(const std::string& what, double error, double tolerance,
                               const std::string& source = "an identity: round-off, or the error of the differences") {
  VerificationTest::current().expect_below(what, error, tolerance, source);
}

class RandomStates {
 public:
  Eigen::Vector3d vector(double size) {
    return size * Eigen::Vector3d(uniform_(generator_), uniform_(generator_), uniform_(generator_));
  }

  Eigen::Matrix3d rotation() {
    return Eigen::AngleAxisd(3.1 * uniform_(generator_), vector(1).normalized()).toRotationMatrix();
  }

  ElementCoordinates columns(double position, double gradient) {
    ElementCoordinates q;
    q << vector(position), vector(gradient), vector(position), vector(gradient);
    return q;
  }

  // Straight and unstrained, anywhere, in any direction.
  ElementCoordinates straight(double length) {
    const Eigen::Vector3d start = vector(5), direction = vector(1).normalized();
    ElementCoordinates q;
    q << start, direction, start + length * direction, direction;
    return q;
  }

  // Strained and bent by the order of `size`.
  ElementCoordinates deformed(double length, double size = 0.3) {
    return straight(length) + columns(size * length, size);
  }

  // Velocities of a rigid motion of q: translation, and spin with an own share about the chord, which no curvature
  // sees.
  ElementCoordinates rigid_velocity(const ElementCoordinates& q) {
    const Eigen::Vector3d translation = vector(2);
    const Eigen::Vector3d spin = vector(3) + 5 * uniform_(generator_) * (q.col(2) - q.col(0)).normalized();
    ElementCoordinates velocity;
    velocity << translation + spin.cross(q.col(0)), spin.cross(q.col(1)), translation + spin.cross(q.col(2)),
        spin.cross(q.col(3));
    return velocity;
  }

 private:
  std::mt19937 generator_{12345};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

// Central difference of fourth order, of anything that can be added and scaled.
template <class Function>
auto derivative(Function&& f, double x, double step) {
  using Value = std::decay_t<decltype(f(x))>;
  auto difference = [&](double h) { return Value((f(x + h) - f(x - h)) / (2 * h)); };
  const Value coarse = difference(2 * step), fine = difference(step);
  return Value((4 * fine - coarse) / 3);
}

// d(energy)/dq by differences. Positions differ by `step` times the length, gradients by `step`.
template <class Energy>
ElementCoordinates numerical_gradient(Energy&& energy, const ElementCoordinates& q, double length, double step) {
  ElementCoordinates gradient;
  for (int i = 0; i < 12; ++i) {
    auto along = [&](double x) {
      ElementCoordinates moved = q;
      moved.data()[i] += x;
      return energy(moved);
    };
    gradient.data()[i] = derivative(along, 0, i / 3 % 2 == 0 ? step * length : step);
  }
  return gradient;
}

// d(force)/dq by differences.
template <class Force>
ElementTangent numerical_tangent(Force&& force, const ElementCoordinates& q, double length, double step) {
  ElementTangent tangent;
  for (int i = 0; i < 12; ++i) {
    auto along = [&](double x) {
      ElementCoordinates moved = q;
      moved.data()[i] += x;
      return ElementCoordinates(force(moved));
    };
    const ElementCoordinates column = derivative(along, 0, i / 3 % 2 == 0 ? step * length : step);
    tangent.col(i) = Eigen::Map<const Eigen::Matrix<double, 12, 1>>(column.data());
  }
  return tangent;
}

template <class A, class B>
double relative_error(const A& value, const B& reference) {
  return (value - reference).norm() / reference.norm();
}

// The paper's net cord: d = 4 mm, E = 12 GPa, rho = 1430 kg/m^3.
inline CableSection net_cord() {
  return {.EA = 150796, .EI = 0.150796, .mass_per_length = 0.0179699, .axial_damping = 1e-4, .bending_damping = 1e-2};
}

}  // namespace netpocket::test
