// V3: dynamics against published and closed-form motions; order of the integrator; energy audit.

#include <array>

#include "tests/engine/dynamics/models.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using namespace test;

constexpr double kGravity = 9.81;

// The flexible pendulum of verification.md V3: 1.2 m, released from the horizontal.
Cable flexible_pendulum(int elements, double damping = 0) {
  CableMaterial material = plain_cable(0.7e6 * 0.0018, 0.7e6 * 1.215e-8, 5540 * 0.0018);
  material.section.axial_damping = material.section.bending_damping = damping;
  Cable cable = straight_cable(material, {0, 0, 0}, {1.2, 0, 0}, elements);
  cable.model.fix_node(cable.nodes.front());
  cable.model.gravity = {0, -kGravity, 0};
  return cable;
}
constexpr double kPendulumWeight = 5540 * 0.0018 * 1.2 * kGravity;  // N

struct PendulumError {
  double position = 0;  // m, largest of the tip at the published times
  double energy = 0;    // of the weight times half the length
};

PendulumError pendulum_error(ElementEvaluation evaluation, int elements) {
  const Cable cable = flexible_pendulum(elements);
  CableSystem system(cable.model, {.evaluation = evaluation});
  const double dt = std::min(0.5 * system.stable_step().step, 2e-4);
  PendulumError error;
  for (const auto& [time, x, y] : {std::array{.2, 1.17992, -.19618}, {.4, .85285, -.78447}, {.6, -.33489, -1.25154}}) {
    advance(system, time, dt);
    const Eigen::Vector3d tip = system.position(cable.nodes.back());
    error.position = std::max(error.position, (tip - Eigen::Vector3d(x, y, 0)).norm());
    error.energy = std::max(error.energy, std::abs(system.audit().error) / (kPendulumWeight * 0.6));
  }
  return error;
}

class VerificationDynamics : public VerificationTest {};

TEST_F(VerificationDynamics, FlexiblePendulum) {
  const std::string source = "verification.md V3: tip at t = 0.2, 0.4, 0.6 s, five digits given";
  const PendulumError full = pendulum_error(ElementEvaluation::full, 20);
  expect_below("flexible pendulum, 20 full elements: tip, m", full.position, 5e-4, source);
  expect_below("flexible pendulum, 20 full elements: energy error / m g L/2", full.energy, 1e-4,
               "no damping: the error of leapfrog is of second order in the step");
  const double coarse = pendulum_error(ElementEvaluation::mean_strain, 20).position;
  const double medium = pendulum_error(ElementEvaluation::mean_strain, 40).position;
  const PendulumError fine = pendulum_error(ElementEvaluation::mean_strain, 80);
  expect_below("flexible pendulum, 20 mean-strain elements: tip, m", coarse, 2e-2,
               source + "; one strain per element and lumped mass: second order");
  expect_below("flexible pendulum, 40 mean-strain elements: tip, m", medium, 5e-3, source);
  expect_below("flexible pendulum, 80 mean-strain elements: tip, m", fine.position, 2e-3, source);
  expect_value("order of convergence of the mean-strain pendulum, 20 to 40 elements", std::log2(coarse / medium), 2,
               0.5, "lumped mass and one strain per element are of second order");
}

// Frequency (Hz) of mode n of the pinned net cord of 5.78 m under 50 N, from the zero crossings of its amplitude.
double cord_frequency(ElementEvaluation evaluation, int elements, int mode) {
  const double length = 5.78, tension = 50, amplitude = 1e-4;
  CableMaterial material = net_cord();
  // Green strain eps with EA eps |r'| = T.
  double stretch = tension / material.section.EA;
  for (int i = 0; i < 20; ++i) {
    stretch = tension / material.section.EA / ((1 + stretch / 2) * (1 + stretch));
  }
  material.section.mass_per_length *= 1 + stretch;  // so that the stretched cord has the formula's
  Cable cable = straight_cable(material, {0, 0, 0}, {length, 0, 0}, elements);
  Model& model = cable.model;
  for (auto& element : model.elements) element.length /= 1 + stretch;
  const double wave = mode * M_PI / length;
  std::vector<double> shape;
  for (int i = 0; i <= elements; ++i) {
    const double x = length * i / elements;
    shape.push_back(std::sin(wave * x));
    model.nodes[cable.nodes[i]].position.y() = amplitude * shape.back();
    model.gradients[cable.gradients[i]].value =
        (1 + stretch) * Eigen::Vector3d(1, amplitude * wave * std::cos(wave * x), 0);
  }
  model.fix_node(cable.nodes.front());
  model.fix_node(cable.nodes.back());
  CableSystem system(model, {.evaluation = evaluation});
  const double dt = 0.8 * system.stable_step().step;
  double before = 1, first = 0, last = 0;
  int crossings = 0;
  while (crossings < 9 && system.time() < 10) {
    system.step(dt);
    double now = 0;
    for (int i = 0; i <= elements; ++i) now += shape[i] * system.position(cable.nodes[i]).y();
    if (now * before < 0) {
      last = system.time() - dt * now / (now - before);
      if (++crossings == 1) first = last;
    }
    before = now;
  }
  return 4 / (last - first);  // eight half periods
}

TEST_F(VerificationDynamics, FrequenciesOfTheTensionedCord) {
  const std::array<double, 3> reference = {4.56507, 9.14233, 13.74389};
  const std::string source = "w_n^2 = (n pi/L)^4 EI/m + (n pi/L)^2 T/m (verification.md V3); ";
  for (int mode = 1; mode <= 3; ++mode) {
    const std::string what = "frequency " + std::to_string(mode) + " of the cord under 50 N, Hz, ";
    expect_relative(what + "32 mean-strain elements", cord_frequency(ElementEvaluation::mean_strain, 32, mode),
                    reference[mode - 1], 2e-3 * mode * mode, source + "lumped mass: (n pi/32)^2/24 low, and less");
  }
  expect_relative("frequency 1 of the cord under 50 N, Hz, 16 full elements",
                  cord_frequency(ElementEvaluation::full, 16, 1), reference[0], 5e-4, source + "consistent mass");
  expect_relative("frequency 3 of the cord under 50 N, Hz, 16 full elements",
                  cord_frequency(ElementEvaluation::full, 16, 3), reference[2], 5e-4, source + "consistent mass");
}

// Order of convergence in time from three steps, of the tip of a flexible pendulum.
double order_in_time(ElementEvaluation evaluation, double damping) {
  const Cable cable = flexible_pendulum(4, damping);
  const auto tip = [&](int steps) {
    CableSystem system(cable.model, {.evaluation = evaluation});
    for (int i = 0; i < steps; ++i) system.step(0.3 / steps);
    return system.position(cable.nodes.back());
  };
  const Eigen::Vector3d coarse = tip(1000), medium = tip(2000), fine = tip(4000);
  return std::log2((coarse - medium).norm() / (medium - fine).norm());
}

TEST_F(VerificationDynamics, OrderInTime) {
  const std::string source = "leapfrog; from steps of 3e-4, 1.5e-4, 7.5e-5 s, pendulum of 4 elements";
  expect_value("order in time, mean-strain", order_in_time(ElementEvaluation::mean_strain, 0), 2, 0.1, source);
  expect_value("order in time, full", order_in_time(ElementEvaluation::full, 0), 2, 0.1, source);
  expect_value("order in time, mean-strain with damping", order_in_time(ElementEvaluation::mean_strain, 1e-2), 1, 0.2,
               "damping forces use the velocity half a step earlier: first order");
}

TEST_F(VerificationDynamics, StableStepIsSharp) {
  // A slack net cord of 40 elements, excited in all modes: stable just below the bound for 20 000 steps, not above.
  for (const ElementEvaluation evaluation : {ElementEvaluation::mean_strain, ElementEvaluation::full}) {
    for (const double damping : {0.0, 1e-4}) {
      const bool full = evaluation == ElementEvaluation::full;
      CableMaterial material = net_cord();
      material.section.axial_damping = damping;
      const auto survives = [&](double factor) {
        Cable cable = straight_cable(material, {0, 0, 0}, {4, 0, 0}, 40);
        for (std::size_t i = 0; i < cable.nodes.size(); ++i) {
          cable.model.nodes[cable.nodes[i]].velocity = Eigen::Vector3d(i % 2, i % 3, i % 5) * 1e-6;
        }
        CableSystem system(cable.model, {.evaluation = evaluation});
        const double dt = factor * system.stable_step().step;
        for (int i = 0; i < (full ? 2000 : 20000); ++i) system.step(dt);
        return !system.fault() && system.audit().kinetic < 1e-9;
      };
      EXPECT_TRUE(survives(0.99)) << "full " << full << ", damping " << damping;
      // The full evaluation's bound is that of single elements, which is on the safe side.
      if (!full) {
        EXPECT_FALSE(survives(1.04)) << "damping " << damping;
      }
    }
  }
}

TEST_F(VerificationDynamics, EnergyAuditClosesWithDamping) {
  const auto error = [](ElementEvaluation evaluation, double dt) {
    const Cable cable = flexible_pendulum(10, 5e-3);
    CableSystem system(cable.model, {.evaluation = evaluation});
    advance(system, 2, dt);
    const EnergyAudit audit = system.audit();
    EXPECT_GT(audit.dissipated, 0.01 * kPendulumWeight * 0.6);
    return std::abs(audit.error) / audit.dissipated;
  };
  for (const auto& [evaluation, name] :
       {std::pair{ElementEvaluation::mean_strain, "mean-strain"}, {ElementEvaluation::full, "full"}}) {
    expect_below(std::string("energy error / dissipated energy, damped pendulum, 2 s, ") + name,
                 error(evaluation, 1e-4), 2e-2, "power at the velocities half a step earlier: first order in the step");
  }
}

}  // namespace
}  // namespace netpocket
