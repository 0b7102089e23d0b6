// V1 for the mean-strain evaluation.

#include "engine/ancf/mean_strain_element.h"

#include "element_checks.h"
#include "engine/ancf/quadrature.h"
#include "engine/ancf/shape_functions.h"

namespace netpocket {
namespace {

using namespace test;

class VerificationMeanStrainElement : public VerificationTest {};

constexpr double kLength = 0.7;
constexpr int kStates = 200;
const ElementCoordinates kAtRest = ElementCoordinates::Zero();

// Axial and bending parts of similar size, so that neither hides an error of the other.
CableSection balanced_section() {
  return {.EA = 50, .EI = 2, .mass_per_length = 0.1, .axial_damping = 0.3, .bending_damping = 0.2, .compression = 0.4};
}

TEST_F(VerificationMeanStrainElement, IsTheIntegralOfGreenStrainAndCurvature) {
  RandomStates random;
  const CableSection section = balanced_section();
  const MeanStrainElement element(section, {.length = kLength});
  double strain_error = 0, energy_error = 0;
  for (int i = 0; i < kStates; ++i) {
    const ElementCoordinates q = random.deformed(kLength);
    double strain = 0, energy = 0;
    for (const auto& [xi, weight] : kGauss4) {
      strain += weight / 2 * (squared_norm(combine(q, shape_p(xi, kLength))) - 1) / 2;
      energy += weight * kLength / 2 * section.EI / 2 * squared_norm(combine(q, shape_pp(xi, kLength)));
    }
    strain_error = std::max(strain_error, std::abs(element.strain(q) - strain));
    energy_error = std::max(energy_error, std::abs(element.bending_energy(q) / energy - 1));
  }
  // Round-off of positions of 5 m over an element of 0.7 m.
  expect_error_below("mean strain, against quadrature", strain_error, 1e-14);
  expect_error_below("bending energy, against quadrature", energy_error, 1e-13);
}

TEST_F(VerificationMeanStrainElement, ForceIsTheGradientOfTheEnergy) {
  RandomStates random;
  const MeanStrainElement element(balanced_section(), {.length = kLength});
  double force_error = 0, tangent_error = 0, asymmetry = 0;
  for (int i = 0; i < kStates; ++i) {
    const ElementCoordinates q = random.deformed(kLength);
    if (std::abs(element.strain(q)) < 0.02) continue;  // differences across the change of stiffness mean nothing
    auto energy = [&](const ElementCoordinates& x) { return element.axial_energy(x) + element.bending_energy(x); };
    auto force = [&](const ElementCoordinates& x) { return element.internal_force(x, kAtRest); };
    force_error = std::max(force_error, relative_error(force(q), numerical_gradient(energy, q, kLength, 1e-3)));
    const ElementTangent tangent = element.tangent(q);
    tangent_error = std::max(tangent_error, relative_error(tangent, numerical_tangent(force, q, kLength, 1e-3)));
    asymmetry = std::max(asymmetry, relative_error(tangent, tangent.transpose()));
  }
  expect_error_below("force, against differences of the energy", force_error, 1e-7);
  expect_error_below("tangent, against differences of the force", tangent_error, 1e-7);
  expect_error_below("asymmetry of the tangent", asymmetry, 1e-15);
}

TEST_F(VerificationMeanStrainElement, HasTheForcesWrittenOut) {
  // Force of axial tension N alone on r1, g1 and of bending alone, from the closed form in the header's symbols.
  RandomStates random;
  const ElementCoordinates q = random.deformed(kLength);
  const Eigen::Vector3d e = (q.col(2) - q.col(0)) / kLength, h1 = q.col(1) - e, h2 = q.col(3) - e;
  const CableSection cord{.EA = 100, .EI = 0}, beam{.EA = 0, .EI = 3};
  const MeanStrainElement axial(cord, {.length = kLength}), bending(beam, {.length = kLength});
  const double N = axial.tension(q, kAtRest);
  ElementCoordinates expected;
  expected << N * (-e + (h1 + h2) / 10), N * kLength * (4 * h1 - h2) / 30, N * (e - (h1 + h2) / 10),
      N * kLength * (4 * h2 - h1) / 30;
  EXPECT_LT(relative_error(axial.internal_force(q, kAtRest), expected), 1e-15);
  const double k = beam.EI / kLength;
  expected << 6 * k / kLength * (h1 + h2), k * (4 * h1 + 2 * h2), -6 * k / kLength * (h1 + h2), k * (2 * h1 + 4 * h2);
  EXPECT_LT(relative_error(bending.internal_force(q, kAtRest), expected), 1e-15);
}

TEST_F(VerificationMeanStrainElement, RigidMotionMakesNoForce) {
  RandomStates random;
  const CableSection section = net_cord();
  const MeanStrainElement element(section, {.length = kLength});
  double largest = 0;
  for (int i = 0; i < kStates; ++i) {
    const ElementCoordinates q = random.straight(kLength);
    largest = std::max(largest, element.internal_force(q, random.rigid_velocity(q)).norm() / section.EA);
  }
  // Round-off of positions of 5 m over 0.7 m.
  expect_error_below("force of a rigid motion / EA", largest, 1e-14);
}

TEST_F(VerificationMeanStrainElement, DampingOnlyTakesEnergyAndIgnoresRigidMotion) {
  RandomStates random;
  const MeanStrainElement element(balanced_section(), {.length = kLength});
  double least = 1, identity = 0, rigid = 0;
  for (int i = 0; i < kStates; ++i) {
    const ElementCoordinates q = random.deformed(kLength);
    const ElementCoordinates velocity = random.columns(1, 1);
    const double dissipated = element.dissipated_power(q, velocity);
    const ElementCoordinates damping = element.internal_force(q, velocity) - element.internal_force(q, kAtRest);
    least = std::min(least, dissipated);
    identity = std::max(identity, std::abs(work(damping, velocity) / dissipated - 1));
    const ElementCoordinates spin = random.rigid_velocity(q);
    const ElementCoordinates resistance = element.internal_force(q, spin) - element.internal_force(q, kAtRest);
    rigid = std::max(rigid, resistance.norm() / element.internal_force(q, kAtRest).norm());
  }
  EXPECT_GE(least, 0);
  expect_error_below("damping force . velocity = dissipated power", identity, 1e-12);
  expect_error_below("damping force of a rigid motion / elastic force", rigid, 1e-13);
}

TEST_F(VerificationMeanStrainElement, DampsBendingAtItsOwnRate) {
  // Motion along the bent shape itself, as in a plane vibration: the damping force is then c d(elastic force)/dt.
  RandomStates random;
  const CableSection beam{.EA = 0, .EI = 3, .bending_damping = 0.2};
  const MeanStrainElement element(beam, {.length = kLength});
  const ElementCoordinates straight = random.straight(kLength);
  const Eigen::Vector3d normal = Eigen::Vector3d(straight.col(1)).unitOrthogonal();
  for (const auto& [h1, h2] : {std::pair{1e-9, -1e-9}, {1e-9, 1e-9}, {0.1, -0.3}}) {
    ElementCoordinates bent = ElementCoordinates::Zero();
    bent.col(1) = h1 * normal;
    bent.col(3) = h2 * normal;
    const double rate = 7;
    const ElementCoordinates q = straight + bent, elastic = element.internal_force(q, kAtRest);
    const ElementCoordinates damping = element.internal_force(q, rate * bent) - elastic;
    // Round-off of h, which is the small difference of two gradients of length one.
    const double tolerance = 1e-13 + 1e-14 / std::abs(h1);
    EXPECT_LT(relative_error(damping, beam.bending_damping * rate * elastic), tolerance) << h1;
  }
}

TEST_F(VerificationMeanStrainElement, CompressionActsAsTheFractionSays) {
  const double L = 1;
  ElementCoordinates q = ElementCoordinates::Zero();
  q.col(2).x() = 0.9;
  q.col(1).x() = q.col(3).x() = 0.9;
  const double eps = (0.81 - 1) / 2;
  for (const double fraction : {0.0, 0.1, 1.0}) {
    const MeanStrainElement element({.EA = 200, .compression = fraction}, {.length = L});
    EXPECT_NEAR(element.tension(q, kAtRest), fraction * 200 * eps, 1e-13);
    EXPECT_NEAR(element.axial_energy(q), fraction * 200 * eps * eps / 2, 1e-14);
  }
}

TEST_F(VerificationMeanStrainElement, TurnsWithThePocketToTheLastBit) {
  // Rotation by 90 degrees about Y.
  RandomStates random;
  const MeanStrainElement element(balanced_section(), {.length = kLength});
  auto turn = [](const ElementCoordinates& q) {
    ElementCoordinates turned;
    turned << q.row(2), q.row(1), -q.row(0);
    return turned;
  };
  for (int i = 0; i < kStates; ++i) {
    const ElementCoordinates q = random.deformed(kLength), velocity = random.columns(1, 1);
    EXPECT_EQ(turn(element.internal_force(q, velocity)), element.internal_force(turn(q), turn(velocity)));
  }
}

}  // namespace
}  // namespace netpocket
