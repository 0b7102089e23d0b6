// V5 at system level: contact of whole cables with bodies.

#include "engine/contact/force_law.h"
#include "tests/engine/dynamics/models.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using namespace test;
using Eigen::Vector3d;

ModelBody free_sphere(double radius, double mass) {
  return {.name = "target",
          .shape = Sphere{radius},
          .mass = mass,
          .inertia = 0.4 * mass * radius * radius * Eigen::Matrix3d::Identity(),
          .state = {}};
}

// A cord of 3 m that flies at `speed` (m/s, -y) onto a free sphere of 1 m that spins.
Cable cord_onto_sphere(double speed, double friction, double height = 1.01) {
  CableMaterial cord = net_cord();
  cord.section.axial_damping = 1e-5;
  cord.section.bending_damping = 1e-2;
  Cable cable = straight_cable(cord, {-1.4, height, 0.2}, {1.6, height, 0.2}, 12);
  for (ModelNode& node : cable.model.nodes) node.velocity = {0, -speed, 0};
  cable.model.add_body(free_sphere(1, 2));
  cable.model.bodies[0].state.angular_velocity = {1, 2, 3};
  cable.model.contact.friction = friction;
  return cable;
}

class VerificationContact : public VerificationTest {};

TEST_F(VerificationContact, ActionEqualsReaction) {
  for (const double friction : {0.0, 0.4}) {
    const Cable cable = cord_onto_sphere(3, friction);
    CableSystem system(cable.model);
    const double dt = 0.8 * system.stable_step().step;
    Momentum last = step_and_measure_momentum(system, dt);
    double linear = 0, angular = 0, force = 0;
    while (system.time() < 0.3) {
      const Eigen::Vector3d impulse = system.contact_impulse(0);
      const Momentum now = step_and_measure_momentum(system, dt);
      linear = std::max(linear, (now.linear - last.linear).norm() / dt);
      angular = std::max(angular, (now.angular - last.angular).norm() / dt);
      force = std::max(force, (system.contact_impulse(0) - impulse).norm() / dt);
      last = now;
    }
    ASSERT_GT(force, 1);
    const std::string with = friction > 0 ? ", with friction" : ", without friction";
    expect_below("sum of forces on both partners / largest contact force" + with, linear / force, 1e-8,
                 "round-off of momentum differences over a step (1e-16/dt^2)");
    expect_below("sum of moments on both partners / largest contact force x 1 m" + with, angular / force, 1e-8,
                 "both partners' forces act along one line: round-off of momentum differences over a step");
  }
}

// Shoots a cord at the sphere with the step that a Simulation would use; returns the deepest penetration (m).
double shoot(double speed, double height) {
  const Cable cable = cord_onto_sphere(speed, 0.4, height);
  CableSystem system(cable.model);
  const double dt = 0.8 * system.stable_step().step;
  double deepest = 0;
  while (system.time() < 3 * height / speed) {
    system.step(dt);
    deepest = std::max(deepest, system.take_deepest_contacts().penetration);
  }
  EXPECT_FALSE(system.fault()) << *system.fault();
  // The middle of the cord, which came from above, may not be below the sphere.
  EXPECT_GT(system.position(cable.nodes[cable.nodes.size() / 2]).y(), system.body(0).position.y())
      << speed << " m/s from " << height << " m";
  return deepest;
}

TEST_F(VerificationContact, NoTunnelling) {
  // At 100 m/s the cord itself is strained by v/c = 3 %. Faster ones leave the range of the chosen step: the run ends
  // as diverged, with its reason.
  for (const double speed : {1.0, 10.0, 100.0}) {
    const double deepest = std::max({shoot(speed, 1.1), shoot(speed, 2.3), shoot(speed, 5.7)});
    expect_below("deepest penetration of a cord at " + std::to_string(static_cast<int>(speed)) + " m/s, m", deepest,
                 2e-4 + 3 * speed * 6e-5,
                 "three steps' way of 6e-5 s (an impact lasts eight steps or less), and 0.2 mm; the sphere's radius is "
                 "1 m");
  }
}

// A straight rod of one stiff element above a large box that cannot move.
struct RodOnTable {
  RodOnTable(double modulus, double restitution, double friction)
      : cable(straight_cable({.section = {.EA = 1e6, .EI = 1e4, .mass_per_length = 1},
                              .radius = 0.01,
                              .youngs_modulus = modulus,
                              .poisson_ratio = 0.3},
                             {-0.5, 0.51, 0}, {0.5, 0.51, 0}, 1)) {
    Model& model = cable.model;
    model.add_body({.name = "table",
                    .shape = Box{{20, 1, 20}},
                    .mass = 1e9,
                    .inertia = 1e9 * Eigen::Matrix3d::Identity(),
                    .state = {},
                    .youngs_modulus = 1e15});
    model.contact.restitution = restitution;
    model.contact.friction = friction;
  }
  Eigen::Vector3d centre_velocity(const CableSystem& system) const {
    return 0.5 * (system.velocity(cable.nodes[0]) + system.velocity(cable.nodes[1]));
  }
  static void hold(CableSystem& system) { system.control(0, {.velocity = {0.0, 0.0, 0.0}, .hold_attitude = true}); }
  Cable cable;
};

TEST_F(VerificationContact, RestitutionOfARod) {
  for (const auto& [restitution, clipped] : {std::pair{0.5, 0.55028}, {1.0, 1.0}}) {
    RodOnTable rod(1e3, restitution, 0);
    for (ModelNode& node : rod.cable.model.nodes) {
      node.velocity = {0, -0.1, 0};
      node.position.y() += 1e-6;
    }
    CableSystem system(rod.cable.model);
    const double dt = 0.2 * system.stable_step().step;
    while (system.time() < 5 && rod.centre_velocity(system).y() < 0) RodOnTable::hold(system), system.step(dt);
    const double turned = system.time();
    while (system.time() < 3 * turned) system.step(dt);
    expect_relative(
        "rebound of a rod, c_r = " + std::to_string(restitution).substr(0, 3), rod.centre_velocity(system).y() / 0.1,
        clipped, 2e-2,
        "Antypov & Elliott (2011) with the adhesive tail cut off (verification case V5); the rod bends a little");
  }
}

// The audit in the middle of the step that stops a blow: what the first half of the step has taken is spent, not more.
TEST_F(VerificationContact, AuditWhileABlowIsStopped) {
  RodOnTable rod(1e7, 0.5, 0);
  const double speed = 60;
  for (ModelNode& node : rod.cable.model.nodes) node.velocity = {0, -speed, 0};
  CableSystem system(rod.cable.model);
  RodOnTable::hold(system);
  const double dt = 0.5 * system.stable_step().step, kinetic = system.audit().kinetic;
  double error = 0;
  while (system.time() < 0.002) {
    system.step(dt);
    error = std::max(error, std::abs(system.audit().error));
  }
  ASSERT_GT(system.safeguards().stopped_blows, 0);
  expect_below("energy error of any step while a blow of 60 m/s is stopped, of the kinetic energy", error / kinetic,
               0.02, "a stop takes nearly all of it in one step; an eighth of that is what half a step is worth");
}

TEST_F(VerificationContact, RodAtRestOnATable) {
  const double modulus = 1e9;
  RodOnTable rod(modulus, 0.5, 0.4);
  rod.cable.model.gravity = {0, -9.81, 0};
  rod.cable.model.materials[0].section.bending_damping = 1e-3;
  CableSystem system(rod.cable.model);
  RodOnTable::hold(system);
  const double largest = 0.5 * system.stable_step().step;
  advance(system, 2, largest);
  const double first_step = 2 / std::ceil(2 / largest);
  Snapshot snapshot;
  system.capture(snapshot);
  double force = 0;
  for (const ContactPoint& contact : snapshot.contacts) force -= contact.force.y();
  const std::string source = "weight of 1 kg; ";
  expect_relative("contact force of a rod at rest, N", force, 9.81, 1e-6, source + "equilibrium");
  expect_below("speed of a rod at rest, m/s", system.velocity(rod.cable.nodes[0]).norm(), 1e-9, "equilibrium");
  // Of the first step, until steps are much shorter.
  const double depth = system.penetration();
  const auto stiffness = [&](double mass) {
    return std::min(hertz_stiffness(effective_modulus({modulus, 0.3}, {1e15, 0.33}), effective_radius(0.01, 0.5)),
                    resolved_stiffness(mass, first_step));
  };
  expect_relative("penetration of a rod at rest, m", depth,
                  std::pow(9.81 / (stiffness(0.5) + 2 * stiffness(0.25)), 2. / 3), 0.15,
                  "K d^1.5 at its middle and its two ends; the rod bends, and the middle presses deeper");
  advance(system, 2.2, 1e-5);
  expect_relative("penetration of a rod at rest in shorter steps, m", system.penetration(), depth, 0.1,
                  "the spring in the middle is that of the materials; those at the ends become stiffer");
}

// The springs become 2^2.5 times as stiff at once.
TEST_F(VerificationContact, StifferSpringsKeepTheirEnergy) {
  RodOnTable rod(1e12, 0.5, 0.4);  // far stiffer than steps resolve
  rod.cable.model.gravity = {0, -9.81, 0};
  rod.cable.model.materials[0].section.bending_damping = 1e-3;
  CableSystem system(rod.cable.model);
  RodOnTable::hold(system);
  const double first = 0.9 * system.stable_step().step;
  while (system.time() < 2) system.step(first);
  const EnergyAudit before = system.audit();
  const double depth = system.penetration();
  ASSERT_GT(before.contact, 0);
  system.step(first / 5);
  const EnergyAudit after = system.audit();
  EXPECT_NEAR(after.contact, before.contact, 0.1 * before.contact);  // the rod moves
  EXPECT_NEAR(after.error, before.error, 0.02 * before.contact);
  while (system.time() < 4) system.step(first / 5);
  EXPECT_LT(system.penetration(), depth) << "no stiffer";
  EXPECT_GT(system.penetration(), 0.4 * depth);
  EXPECT_NEAR(system.audit().error, before.error, 0.1 * before.contact);
}

// Stiffness, and so the squared phase, of a spring F = K s^1.5 grows with the cube root of the load. Four times that is
// asked for where it bears much: the steps are then halved.
TEST_F(VerificationContact, SpringsThatBearMuchAskForFinerSteps) {
  const auto at_rest = [](double gravity) {
    RodOnTable rod(1e12, 0.5, 0.4);
    rod.cable.model.gravity = {0, -gravity, 0};
    rod.cable.model.materials[0].section.bending_damping = 1e-3;
    CableSystem system(rod.cable.model);
    RodOnTable::hold(system);
    const double step = 0.5 * system.stable_step().step;
    while (system.time() < 2) system.step(step);
    return std::pair(system.contact_load(), system.contact_squared_phase());
  };
  const auto [little, phase] = at_rest(10);
  const auto [more, larger_phase] = at_rest(80);
  const auto [much, finer_phase] = at_rest(80e3);
  EXPECT_LT(more, 0.2);
  EXPECT_GT(much, 0.5);
  EXPECT_NEAR(larger_phase / phase, 2, 0.1) << "loads " << little << ", " << more;
  EXPECT_NEAR(finer_phase / phase, 4 * 20, 4) << "load " << much;
}

TEST_F(VerificationContact, RodOnAnIncline) {
  for (const double angle : {10.0, 30.0}) {
    RodOnTable rod(1e9, 0.5, 0.3);
    const double slope = angle * M_PI / 180;
    // Along z, across the rod.
    rod.cable.model.gravity = 9.81 * Eigen::Vector3d(0, -std::cos(slope), std::sin(slope));
    rod.cable.model.materials[0].section.bending_damping = 1e-3;
    CableSystem system(rod.cable.model);
    RodOnTable::hold(system);
    const double dt = 1e-5;
    advance(system, 0.5, dt);
    const double start = rod.centre_velocity(system).z();
    advance(system, 1, dt);
    const double end = rod.centre_velocity(system).z();
    if (angle < 15) {
      expect_relative("creep of a rod that sticks at 10 degrees, mu = 0.3, m/s", end, 1e-3 * std::tan(slope) / 0.3, 0.1,
                      "regularised friction, v_f tan(slope)/mu; of the speed before friction acts, which is about two "
                      "steps of gravity (1.7e-5 m/s each) larger");
    } else {
      expect_relative("acceleration of a rod that slides at 30 degrees, mu = 0.3, m/s^2", (end - start) / 0.5,
                      9.81 * (std::sin(slope) - 0.3 * std::cos(slope)), 1e-3, "g (sin - mu cos)");
    }
    EXPECT_NEAR(rod.centre_velocity(system).x(), 0, 1e-9);
  }
}

// A cord on the end of a light, slender body, whose inertia there is a hundredth of its mass: springs are as soft as
// that asks for.
TEST_F(VerificationContact, EndOfALightSlenderBody) {
  CableMaterial cord = net_cord();
  Cable cable = straight_cable(cord, {2.2, 0.45, -1.5}, {2.2, 0.45, 1.5}, 12);
  for (ModelNode& node : cable.model.nodes) node.velocity = {0, -5, 0};
  ModelBody body{
      .name = "target", .shape = Cylinder{0.43, 4.6}, .mass = 0.2, .inertia = Eigen::Matrix3d::Zero(), .state = {}};
  body.inertia.diagonal() = Vector3d(0.36, 0.018, 0.36);
  body.state.attitude = Eigen::AngleAxisd(0.5 * M_PI, Vector3d::UnitZ());
  cable.model.add_body(body);
  cable.model.contact.restitution = 1;
  CableSystem system(cable.model);
  const double dt = 0.9 * system.stable_step().step, start = system.audit().kinetic;
  advance(system, 0.05, dt);
  EXPECT_GT(system.contact_impulse(0).norm(), 0.05);
  EXPECT_EQ(system.safeguards().unresolved_contacts, 0);
  expect_below("energy error of a cord on the end of a light, slender body, of the kinetic energy",
               std::abs(system.audit().error) / start, 1e-2, "conservation of energy, c_r = 1");
}

}  // namespace
}  // namespace netpocket
