// A slack cord that carries no compression, with the full evaluation, pushed together.

#include <vector>

#include "element_checks.h"
#include "engine/ancf/full_element.h"
#include "engine/ancf/mass.h"

namespace netpocket {
namespace {

using namespace test;

class VerificationSlackCord : public VerificationTest {};

// Free chain of net cord, 1 m long in 10 elements, stepped with the symplectic Euler rule and lumped masses.
class FreeCord {
 public:
  FreeCord(const CableSection& section, double smallest_stretch, RandomStates& random)
      : element_(section, {.length = kLength}, {.smallest_stretch = smallest_stretch}),
        nodes_(Nodes::Zero()),
        velocities_(Nodes::Zero()),
        masses_(Masses::Zero()) {
    const NodalWeights lumped = lumped_mass(section.mass_per_length, kLength);
    for (int i = 0; i < kElements; ++i) masses_.segment<4>(2 * i) += lumped;
    for (int i = 0; i <= kElements; ++i) {
      nodes_(0, 2 * i) = i * kLength;
      nodes_(0, 2 * i + 1) = 1;
      // Both ends fly towards each other at 1 m/s, nearly along the cord.
      velocities_.col(2 * i) = Eigen::Vector3d(1 - 2.0 * i / kElements, 0, 0) + random.vector(0.1);
    }
  }

  void step(double dt) {
    Nodes force = Nodes::Zero();
    for (int i = 0; i < kElements; ++i) {
      const ElementCoordinates q = nodes_.middleCols<4>(2 * i), velocity = velocities_.middleCols<4>(2 * i);
      force.middleCols<4>(2 * i) -= element_.internal_force(q, velocity);
    }
    velocities_ += dt * force * masses_.cwiseInverse().asDiagonal();
    nodes_ += dt * velocities_;
  }

  double energy() const {
    double energy = (velocities_ * masses_.cwiseSqrt().asDiagonal()).squaredNorm() / 2;
    for (int i = 0; i < kElements; ++i) {
      const ElementCoordinates q = nodes_.middleCols<4>(2 * i);
      energy += element_.axial_energy(q) + element_.bending_energy(q);
    }
    return energy;
  }

 private:
  static constexpr int kElements = 10;
  static constexpr double kLength = 0.1;
  using Nodes = Eigen::Matrix<double, 3, 2 * kElements + 2>;
  using Masses = Eigen::Vector<double, 2 * kElements + 2>;

  FullElement element_;
  Nodes nodes_, velocities_;
  Masses masses_;
};

// Change of the undamped cord's energy in 0.33 s, as a fraction: largest, and mean over the last third. Its ends would
// have met after 0.5 s.
struct EnergyError {
  double largest = 0, drift = 0;
};

EnergyError energy_error(double smallest_stretch) {
  CableSection section = net_cord();
  section.compression = section.axial_damping = section.bending_damping = 0;
  RandomStates random;
  FreeCord cord(section, smallest_stretch, random);
  const double start = cord.energy();
  EnergyError error;
  // The step is a twentieth of the travel time of an axial wave through an element.
  constexpr int kSteps = 220000, kInterval = 1000, kLast = 2 * kSteps / 3;
  for (int i = 0; i < kSteps; ++i) {
    cord.step(1.5e-6);
    if (i % kInterval != 0) continue;
    const double change = cord.energy() / start - 1;
    error.largest = std::max(error.largest, std::abs(change));
    if (i > kLast) error.drift += change * kInterval / (kSteps - kLast);
  }
  return error;
}

TEST_F(VerificationSlackCord, ContinuedCurvatureKeepsTheEnergy) {
  // Symplectic stepping: the energy swings with dt times force and speed when parts of the cord snap taut, and does not
  // drift.
  const EnergyError error = energy_error(FullElementOptions().smallest_stretch);
  expect_error_below("slack tension-only cord: energy, largest change", error.largest, 2e-2);
  expect_error_below("slack tension-only cord: energy, mean change at the end", std::abs(error.drift), 2e-3);
}

TEST_F(VerificationSlackCord, SingularCurvatureDoesNot) {
  const double error = energy_error(1e-6).largest;
  std::printf("  slack tension-only cord, exact curvature: energy error %.1e\n", error);
  EXPECT_GT(error, 1);
}

}  // namespace
}  // namespace netpocket
