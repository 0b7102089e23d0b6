// V3, V5: linear and angular momentum of free systems; rigid bodies with clamped cables.

#include <random>

#include "tests/engine/dynamics/models.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using namespace test;

const char* const kRoundOff =
    "internal forces sum to zero: what is left is round-off, here of velocities taken as "
    "differences of positions (1e-16/dt)";

// A soft cable in a tangle, flying and tumbling.
Cable tumbling_cable() {
  CableMaterial material = plain_cable(500, 0.2, 0.1);
  material.section.axial_damping = material.section.bending_damping = 1e-3;
  Cable cable = straight_cable(material, {0, 0, 0}, {2, 0, 0}, 8);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (ModelNode& node : cable.model.nodes) {
    node.velocity = Eigen::Vector3d(uniform(generator), uniform(generator), uniform(generator));
    node.point_mass = 0.01;
  }
  return cable;
}

class VerificationMomentum : public VerificationTest {};

TEST_F(VerificationMomentum, TumblingCable) {
  for (const auto& [evaluation, name] :
       {std::pair{ElementEvaluation::mean_strain, "mean-strain"}, {ElementEvaluation::full, "full"}}) {
    const Cable cable = tumbling_cable();
    CableSystem system(cable.model, {.evaluation = evaluation});
    const MomentumDrift drift = run_and_measure_drift(system, 2, 0.5 * system.stable_step().step, evaluation);
    expect_below(std::string("linear momentum, tumbling cable, relative drift, ") + name, drift.linear, 1e-11,
                 kRoundOff);
    expect_below(std::string("angular momentum, tumbling cable, relative drift, ") + name, drift.angular, 1e-11,
                 kRoundOff);
  }
}

// A free body of 5 kg with a flexible rod clamped to it, off its centre of mass.
Cable body_with_rod(double mass, const Eigen::Matrix3d& inertia, int elements) {
  const double EI = 20, length = 2;
  Cable cable = straight_cable(plain_cable(2e4, EI, 0.4), {0.3, 0.1, 0}, {0.3 + length, 0.1, 0}, elements);
  cable.model.add_body({.name = "hub", .shape = Sphere{0.2}, .mass = mass, .inertia = inertia, .state = {}});
  cable.model.clamp_to_body(cable.nodes.front(), cable.gradients.front(), 0);
  return cable;
}

TEST_F(VerificationMomentum, RodOnFreeBody) {
  for (const auto& [evaluation, name] :
       {std::pair{ElementEvaluation::mean_strain, "mean-strain"}, {ElementEvaluation::full, "full"}}) {
    Cable cable = body_with_rod(5, Eigen::Vector3d(0.3, 0.4, 0.5).asDiagonal(), 8);
    cable.model.bodies[0].state.angular_velocity = {0.3, 1, 2};
    cable.model.bodies[0].state.velocity = {0.1, 0.2, 0.3};
    for (std::size_t i = 1; i < cable.nodes.size(); ++i) {
      cable.model.nodes[cable.nodes[i]].velocity = {0, 0.3 * static_cast<double>(i), 0.2};
    }
    CableSystem system(cable.model, {.evaluation = evaluation});
    const MomentumDrift drift = run_and_measure_drift(system, 2, 0.5 * system.stable_step().step, evaluation);
    expect_below(std::string("linear momentum, rod clamped to a free body, relative drift, ") + name, drift.linear,
                 1e-10, kRoundOff);
    expect_below(std::string("angular momentum, rod clamped to a free body, relative drift, ") + name, drift.angular,
                 1e-10, kRoundOff);
    const EnergyAudit audit = system.audit();
    expect_below(std::string("energy error / energy, rod clamped to a free body, ") + name,
                 std::abs(audit.error) / (audit.kinetic + audit.strain), 1e-3,
                 "no damping: bounded error of second order in the step");
  }
}

TEST_F(VerificationMomentum, CompoundBody) {
  // A point mass of 2 kg clamped 1 m off the centre of a body of 3 kg with I = 0.5: a steady force on the body's
  // centre.
  Cable cable = straight_cable(plain_cable(1e-6, 1e-9, 1e-9), {1, 0, 0}, {2, 0, 0}, 1);
  Model& model = cable.model;
  model.nodes[cable.nodes.front()].point_mass = 2;
  model.add_body(
      {.name = "hub", .shape = Sphere{0.1}, .mass = 3, .inertia = 0.5 * Eigen::Matrix3d::Identity(), .state = {}});
  model.clamp_to_body(cable.nodes.front(), cable.gradients.front(), 0);
  CableSystem system(model);
  const double force = 1, time = 1e-3;
  system.control(0, {.force = {0, force, 0}});
  const int steps = 100;
  for (int i = 0; i < steps; ++i) system.step(time / steps);
  // Velocities are those of half a step before.
  const double elapsed = time - 0.5 * time / steps;
  const double total = 5, offset = 0.4, inertia = 0.5 + 3 * 0.4 * 0.4 + 2 * 0.6 * 0.6;
  const std::string source = "rigid body of 5 kg, centre of mass 0.4 m from the hub, I = 1.7 kg m^2; first order in t";
  const double spin = -force * offset / inertia;
  expect_relative("angular acceleration of a body with a clamped mass, 1/s^2",
                  system.body(0).angular_velocity.z() / elapsed, spin, 1e-5, source);
  expect_relative("acceleration of the body's own centre, m/s^2", system.body(0).velocity.y() / elapsed,
                  force / total - spin * offset, 1e-5, source);
}

// First frequency (Hz) of a rod clamped to a practically immovable body.
double clamped_frequency(ElementEvaluation evaluation, int elements) {
  Cable cable = body_with_rod(1e9, 1e9 * Eigen::Matrix3d::Identity(), elements);
  const double amplitude = 1e-5, length = 2;
  // The shape of the first mode, so that only it moves.
  const double beta = 1.875104068711961, ratio = 0.7340955137589127;
  for (int i = 0; i <= elements; ++i) {
    const double x = beta * i / elements;
    const double shape = std::cosh(x) - std::cos(x) - ratio * (std::sinh(x) - std::sin(x));
    const double slope = beta / length * (std::sinh(x) + std::sin(x) - ratio * (std::cosh(x) - std::cos(x)));
    cable.model.nodes[cable.nodes[i]].position.y() += amplitude * shape;
    cable.model.gradients[cable.gradients[i]].value.y() += amplitude * slope;
  }
  CableSystem system(cable.model, {.evaluation = evaluation});
  const double dt = 0.8 * system.stable_step().step;
  double before = amplitude, first = 0, last = 0;
  for (int crossings = 0; crossings < 7 && system.time() < 60;) {
    system.step(dt);
    const double now = system.position(cable.nodes.back()).y() - 0.1;
    if (now * before < 0) {
      last = system.time() - dt * now / (now - before);
      if (++crossings == 1) first = last;
    }
    before = now;
  }
  return 3 / (last - first);
}

TEST_F(VerificationMomentum, FrequencyOfAClampedRod) {
  const double reference = 1.875104068711961 * 1.875104068711961 / (2 * M_PI) * std::sqrt(20 / (0.4 * 16));
  const std::string source = "Euler-Bernoulli cantilever: (1.8751)^2/(2 pi) sqrt(EI/(m L^4)); ";
  expect_relative("frequency of a clamped rod, Hz, 8 full elements", clamped_frequency(ElementEvaluation::full, 8),
                  reference, 1e-3, source + "the clamped element's mass is lumped");
  expect_relative("frequency of a clamped rod, Hz, 8 mean-strain elements",
                  clamped_frequency(ElementEvaluation::mean_strain, 8), reference, 2e-2, source + "lumped mass");
  expect_relative("frequency of a clamped rod, Hz, 16 mean-strain elements",
                  clamped_frequency(ElementEvaluation::mean_strain, 16), reference, 5e-3, source + "lumped mass");
}

}  // namespace
}  // namespace netpocket
