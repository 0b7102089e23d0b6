// V1 for the full evaluation, with both strain measures.

#include "engine/ancf/full_element.h"

#include "element_checks.h"

namespace netpocket {
namespace {

using namespace test;

constexpr double kLength = 0.7;
constexpr int kStates = 200;
const ElementCoordinates kAtRest = ElementCoordinates::Zero();

// Axial and bending parts of similar size, so that neither hides an error of the other.
CableSection balanced_section() {
  return {.EA = 50, .EI = 2, .mass_per_length = 0.1, .axial_damping = 0.3, .bending_damping = 0.2};
}

double energy(const FullElement& element, const ElementCoordinates& q) {
  return element.axial_energy(q) + element.bending_energy(q);
}

class VerificationFullElement : public VerificationTest, public testing::WithParamInterface<StrainMeasure> {
 protected:
  FullElement element(const CableSection& section, double smallest_stretch = 0.5) const {
    return {section, {.length = kLength}, {.measure = GetParam(), .smallest_stretch = smallest_stretch}};
  }

  RandomStates random_;
};

INSTANTIATE_TEST_SUITE_P(Measures, VerificationFullElement,
                         testing::Values(StrainMeasure::green, StrainMeasure::material),
                         [](const auto& test) { return test.param == StrainMeasure::green ? "green" : "material"; });

TEST_P(VerificationFullElement, ForceIsTheGradientOfTheEnergy) {
  const FullElement cable = element(balanced_section());
  double force_error = 0, tangent_error = 0, asymmetry = 0;
  for (int i = 0; i < kStates; ++i) {
    const ElementCoordinates q = random_.deformed(kLength, 0.2);
    auto potential = [&](const ElementCoordinates& x) { return energy(cable, x); };
    auto force = [&](const ElementCoordinates& x) { return cable.internal_force(x, kAtRest); };
    force_error = std::max(force_error, relative_error(force(q), numerical_gradient(potential, q, kLength, 5e-4)));
    const ElementTangent tangent = cable.tangent(q);
    tangent_error = std::max(tangent_error, relative_error(tangent, numerical_tangent(force, q, kLength, 5e-4)));
    asymmetry = std::max(asymmetry, relative_error(tangent, tangent.transpose()));
  }
  expect_error_below("force, against differences of the energy", force_error, 1e-7);
  expect_error_below("tangent, against differences of the force", tangent_error, 1e-7);
  expect_error_below("asymmetry of the tangent", asymmetry, 1e-14);
}

TEST_P(VerificationFullElement, ForceAndTangentHoldWhereTheSlopeCollapses) {
  // Slack element, gradients nearly zero: the continued curvature must still have its own exact derivatives.
  const FullElement cable = element(balanced_section());
  double force_error = 0, tangent_error = 0;
  for (int i = 0; i < kStates; ++i) {
    ElementCoordinates q = random_.columns(0.1 * kLength, 0.1);
    auto potential = [&](const ElementCoordinates& x) { return energy(cable, x); };
    auto force = [&](const ElementCoordinates& x) { return cable.internal_force(x, kAtRest); };
    // Smaller steps: the material strain |r'| - 1 has a kink at r' = 0, which they must not reach.
    force_error = std::max(force_error, relative_error(force(q), numerical_gradient(potential, q, kLength, 1e-4)));
    tangent_error =
        std::max(tangent_error, relative_error(cable.tangent(q), numerical_tangent(force, q, kLength, 1e-5)));
  }
  expect_error_below("collapsed slope: force", force_error, 1e-7);
  expect_error_below("collapsed slope: tangent", tangent_error, 1e-7);
}

TEST_P(VerificationFullElement, CollapseIsBounded) {
  // r' -> 0 with r'' kept: the exact curvature's force grows without bound, the continued one's does not.
  const CableSection beam{.EA = 0, .EI = 1};
  auto force_at = [&](double slope, double smallest_stretch) {
    ElementCoordinates q = ElementCoordinates::Zero();
    q.col(2).x() = slope * kLength;
    q.col(1) << slope, 0.1, 0;
    q.col(3) << slope, -0.1, 0;
    return element(beam, smallest_stretch).internal_force(q, kAtRest).norm();
  };
  EXPECT_EQ(force_at(0.9, 0.5), force_at(0.9, 1e-9)) << "exact above the smallest stretch";
  EXPECT_LT(force_at(1e-6, 0.5), 100);
  EXPECT_GT(force_at(1e-6, 1e-9), 1e6);
}

TEST_P(VerificationFullElement, GatheredMaterialIsNoHinge) {
  // r' = 0 everywhere and r'' = B/L: what is left is n (n+1)/2 A0^(1-n) B.B, not |r' x r''|^2 = 0.
  const CableSection beam{.EA = 0, .EI = 1};
  const double size = 1e-9, stretch = 0.9;
  ElementCoordinates q = ElementCoordinates::Zero();
  q.col(1).y() = size;
  q.col(3).y() = -size;
  const double linear = 0.5 * (2 * size / kLength) * (2 * size / kLength) * kLength;  // EI/2 int r''.r'' dp
  const double expected = GetParam() == StrainMeasure::green ? 6 / std::pow(stretch, 4) : 3 / std::pow(stretch, 2);
  expect_value("bending energy of gathered material / EI/2 int r''.r'' dp",
               element(beam, stretch).bending_energy(q) / linear, expected, 1e-9, "full_element.h at A = 0");
}

TEST_P(VerificationFullElement, RigidMotionMakesNoForce) {
  const CableSection section = net_cord();
  const FullElement cable = element(section);
  double largest = 0;
  for (int i = 0; i < kStates; ++i) {
    const ElementCoordinates q = random_.straight(kLength);
    largest = std::max(largest, cable.internal_force(q, random_.rigid_velocity(q)).norm() / section.EA);
  }
  // Round-off of positions of 5 m over 0.7 m.
  expect_error_below("force of a rigid motion / EA", largest, 2e-14);
}

TEST_P(VerificationFullElement, EnergyDoesNotSeeRotation) {
  const FullElement cable = element(balanced_section());
  double error = 0;
  for (int i = 0; i < kStates; ++i) {
    const ElementCoordinates q = random_.deformed(kLength, 0.2);
    const ElementCoordinates turned = random_.rotation() * q;
    error = std::max(error, std::abs(energy(cable, turned) / energy(cable, q) - 1));
  }
  expect_error_below("energy of a rotated state", error, 1e-11);
}

TEST_P(VerificationFullElement, DampingOnlyTakesEnergyAndIgnoresRigidMotion) {
  const FullElement cable = element(balanced_section());
  double least = 1, identity = 0, rigid = 0;
  for (int i = 0; i < kStates; ++i) {
    const ElementCoordinates q = random_.deformed(kLength, 0.2);
    const ElementCoordinates velocity = random_.columns(1, 1), elastic = cable.internal_force(q, kAtRest);
    const double dissipated = cable.dissipated_power(q, velocity);
    least = std::min(least, dissipated);
    const ElementCoordinates damping = cable.internal_force(q, velocity) - elastic;
    identity = std::max(identity, std::abs(work(damping, velocity) / dissipated - 1));
    const ElementCoordinates resistance = cable.internal_force(q, random_.rigid_velocity(q)) - elastic;
    rigid = std::max(rigid, resistance.norm() / elastic.norm());
  }
  EXPECT_GE(least, 0);
  expect_error_below("damping force . velocity = dissipated power", identity, 1e-12);
  expect_error_below("damping force of a rigid motion / elastic force", rigid, 1e-12);
}

TEST_P(VerificationFullElement, ExactCircleHasItsCurvature) {
  // An arc of 0.1 rad with the radius and unit gradients of a circle: kappa = 1/R up to interpolation, angle^4/720.
  const double R = kLength / 0.1, angle = 0.1, EI = 3;
  ElementCoordinates q;
  q << Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(), R * Eigen::Vector3d(std::sin(angle), 1 - std::cos(angle), 0),
      Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
  const double arc = EI * kLength / (2 * R * R);
  expect_error_below("energy of an arc", std::abs(element({.EA = 0, .EI = EI}).bending_energy(q) / arc - 1), 1e-6);
}

TEST_P(VerificationFullElement, TurnsWithThePocketToTheLastBit) {
  // Rotation by 90 degrees about Y.
  const FullElement cable = element(balanced_section());
  auto turn = [](const ElementCoordinates& q) {
    ElementCoordinates turned;
    turned << q.row(2), q.row(1), -q.row(0);
    return turned;
  };
  for (int i = 0; i < kStates; ++i) {
    const ElementCoordinates q = random_.deformed(kLength), velocity = random_.columns(1, 1);
    EXPECT_EQ(turn(cable.internal_force(q, velocity)), cable.internal_force(turn(q), turn(velocity)));
  }
}

}  // namespace
}  // namespace netpocket
