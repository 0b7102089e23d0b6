// Rigid bodies that touch each other: rebound, momenta, energy, rest, friction, resuming.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "engine/contact/force_law.h"
#include "engine/dynamics/system/cable_system.h"
#include "tests/engine/bodies/mesh_samples.h"
#include "tests/engine/dynamics/models.h"

namespace netpocket {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using test::net_cord;
using test::straight_cable;

ModelBody solid(const Shape& shape, double mass, const Vector3d& position, const Vector3d& velocity = {0, 0, 0}) {
  ModelBody body{.name = "body", .shape = shape, .mass = mass, .inertia = solid_inertia(shape, mass), .state = {}};
  body.state.position = position;
  body.state.velocity = velocity;
  return body;
}

Model model_of(const std::vector<ModelBody>& bodies, double restitution = 0.5, double friction = 0) {
  Model model = straight_cable(net_cord(), {50, 0, 0}, {51, 0, 0}, 1).model;  // far from all of them, at rest
  for (const ModelBody& body : bodies) model.add_body(body);
  model.contact.bodies = true;
  model.contact.restitution = restitution;
  model.contact.friction = friction;
  return model;
}

// At the end of the last step, velocities over it: what leapfrog conserves.
struct BodyMomentum {
  Vector3d linear = Vector3d::Zero(), angular = Vector3d::Zero();
};
BodyMomentum momentum(const CableSystem& system) {
  BodyMomentum sum;
  for (std::size_t b = 0; b < system.model().bodies.size(); ++b) {
    const ModelBody& body = system.model().bodies[b];
    const BodyState state = system.body(static_cast<std::int32_t>(b));
    const Matrix3d rotation = state.attitude.toRotationMatrix();
    sum.linear += body.mass * state.velocity;
    sum.angular += body.mass * state.position.cross(state.velocity) +
                   rotation * body.inertia * rotation.transpose() * state.angular_velocity;
  }
  return sum;
}

struct Course {
  double greatest_error = 0;                                 // J, of the energy account, once no body touches another
  double deepest = 0;                                        // m
  double drift = 0;                                          // of linear and angular momentum
  double least_friction_power = 0, least_damping_power = 0;  // W, mean over a step
  int touching_steps = 0;
};

Course run(CableSystem& system, double time, double dt) {
  Course course;
  const BodyMomentum start = momentum(system);
  const double initial = system.audit().kinetic;
  while (system.time() < time) {
    system.step(dt);
    const BodyContactSum contact = system.body_contacts();
    course.touching_steps += contact.count > 0 ? 1 : 0;
    course.deepest = std::max(course.deepest, contact.penetration);
    course.least_friction_power = std::min(course.least_friction_power, contact.friction_power);
    const EnergyAudit energy = system.audit();
    if (system.body_contacts().count == 0)
      course.greatest_error = std::max(course.greatest_error, std::abs(energy.error));
    const BodyMomentum now = momentum(system);
    course.drift = std::max({course.drift, (now.linear - start.linear).norm(), (now.angular - start.angular).norm()});
  }
  EXPECT_FALSE(system.fault()) << *system.fault();
  EXPECT_GT(initial, 0);
  return course;
}

// Rebound of the law itself, its adhesive tail cut off, by many small steps.
double rebound_of_law(double restitution, double speed) {
  const NormalLaw law = make_normal_law(1e6, restitution, 1);
  double depth = 0, separation = -speed;
  const double dt = 1e-6;
  do {
    separation += dt * repulsive_normal_force(law, depth, separation);
    depth -= dt * separation;
  } while (depth > 0);
  return separation / speed;
}

TEST(BodyContact, SpheresReboundAsTheLawSays) {
  for (const double restitution : {1.0, 0.8, 0.5, 0.2}) {
    for (const double speed : {0.1, 1.0, 8.0}) {
      const Vector3d way = Vector3d(1, 2, -2) / 3.0;
      CableSystem system(model_of({solid(Sphere{1}, 2, Vector3d(0, 0, 0), 0.4 * speed * way),
                                   solid(Sphere{0.5}, 3, 1.6 * way, -0.6 * speed * way)},
                                  restitution));
      const Course course = run(system, 0.4 / speed, 1e-4 / speed);
      EXPECT_GT(course.touching_steps, 4);
      const double parting = (system.body(1).velocity - system.body(0).velocity).dot(way);
      EXPECT_NEAR(parting / speed, rebound_of_law(restitution, speed), 0.025) << restitution << ", " << speed;
      EXPECT_LT(course.drift, 1e-13 * speed);
      EXPECT_LT(course.greatest_error, 0.01 * 0.5 * 1.2 * speed * speed) << restitution << ", " << speed;
      // Friction has nothing to act on, and the normal force no arm.
      EXPECT_LT(system.body(0).angular_velocity.norm(), 1e-12 * speed);
    }
  }
}

// A contact without damping gives back what it took, also where the step changes meanwhile: its stiffness stays.
TEST(BodyContact, ChangesOfTheStepCreateNoEnergy) {
  CableSystem system(model_of({solid(Sphere{1}, 2, {0, 0, 0}, {0, 1, 0}), solid(Sphere{1}, 2, {0, 2.001, 0})}, 1));
  const double initial = system.audit().kinetic;
  double dt = 1e-4;
  int touching = 0;
  while (system.time() < 0.02) {
    system.step(dt);
    if (system.body_contacts().count == 0) continue;
    dt = ++touching % 2 == 0 ? 1e-4 : 0.7e-4;
    EXPECT_NEAR(system.audit().error, 0, 0.02 * initial);
  }
  EXPECT_GT(touching, 8);
  EXPECT_NEAR(system.audit().kinetic, initial, 2e-3 * initial);
}

// Every shape against every other, thrown at each other askew: momenta to round-off, the energy account closes, neither
// passes through the other.
TEST(BodyContact, AllShapesKeepMomentaAndEnergy) {
  const std::vector<Shape> shapes = {Sphere{0.8},
                                     Box{{1, 1.5, 2}},
                                     Cylinder{0.7, 1.6},
                                     Satellite({{1, 1, 1}, 4, 0.6, 0.8}),
                                     MeshShape{samples::checked_mesh(samples::box({1, 1.5, 2}))},
                                     MeshShape{samples::checked_mesh(samples::geodesic_sphere(0.8, 3))}};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t j = i; j < shapes.size(); ++j) {
      ModelBody one = solid(shapes[i], 3, {0, 0, 0}, {0, 0.5, 0}),
                two = solid(shapes[j], 5, {0.1, 3.5, 0.2}, {0, -2, 0});
      one.state.attitude = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized());
      two.state.attitude = Eigen::AngleAxisd(1.1, Vector3d(3, -1, 2).normalized());
      one.state.angular_velocity = {0.3, 1, -0.5};
      CableSystem system(model_of({one, two}, 0.5, 0.3));
      const double initial = system.audit().kinetic;
      const Course course = run(system, 2.5, 2e-4);
      EXPECT_GT(course.touching_steps, 4) << i << ", " << j;
      EXPECT_LT(course.deepest, 0.02) << i << ", " << j;
      EXPECT_LT(course.drift, 1e-11) << i << ", " << j;
      // Of prisms' edges that roll over each other, normals change in steps.
      EXPECT_LT(course.greatest_error, (i == 2 && j == 2 ? 0.03 : 0.02) * initial) << i << ", " << j;
      EXPECT_EQ((system.body_contact_impulse(0) + system.body_contact_impulse(1)).norm(), 0) << i << ", " << j;
      EXPECT_LT(system.audit().kinetic, initial) << i << ", " << j;
    }
  }
}

BodyControl held() {
  BodyControl control;
  control.velocity = {0.0, 0.0, 0.0};
  control.hold_attitude = true;
  return control;
}

// A body above the top of a box of 4 m at y = 0 that is held, pressed down by 100 N.
CableSystem pressed_down(const ModelBody& body, double friction = 0, const Vector3d& force = {0, -100, 0}) {
  CableSystem system(model_of({solid(Box{{4, 2, 4}}, 1000, {0, -1, 0}), body}, 0.5, friction));
  system.control(0, held());
  BodyControl control;
  control.force = force;
  system.control(1, control);
  return system;
}

TEST(BodyContact, SphereRestsWhereItsSpringCarriesTheLoad) {
  CableSystem system = pressed_down(solid(Sphere{1}, 10, {0.3, 1.01, 0.2}));
  while (system.time() < 3) system.step(2e-4);
  const BodyContactSum contact = system.body_contacts();
  EXPECT_EQ(contact.count, 1);
  EXPECT_NEAR(contact.normal_force, 100, 1e-3);
  EXPECT_LT(system.body(1).velocity.norm(), 1e-6);
  EXPECT_NEAR(system.body(1).position.y(), 1 - contact.penetration, 1e-12);
  EXPECT_NEAR(contact.stored, 0.4 * contact.normal_force * contact.penetration, 1e-6 * contact.stored);
  EXPECT_EQ(system.body(0).position, Vector3d(0, -1, 0));
  EXPECT_NEAR(system.audit().error, 0, 0.01);  // of 1 J of work
}

// Aligned, turned, and with another box of the same size below it: level all along, with the load on four corners.
TEST(BodyContact, BoxOnBoxStaysLevel) {
  for (const double turn : {0.0, 0.3}) {
    for (const double size : {1.0, 4.0}) {
      ModelBody box = solid(Box{{size, 1, size}}, 10, {0, 0.501, 0});
      box.state.attitude = Eigen::AngleAxisd(turn, Vector3d::UnitY());
      CableSystem system = pressed_down(box, 0.4);
      double steepest = 0;
      while (system.time() < 2) {
        system.step(2e-4);
        steepest = std::max(steepest, std::acos(std::min(1.0, (system.body(1).attitude * Vector3d::UnitY()).y())));
      }
      EXPECT_LT(steepest, 1e-6) << turn << ", " << size;
      EXPECT_NEAR(system.body_contacts().normal_force, 100, 0.01) << turn << ", " << size;
      EXPECT_LT(system.body(1).velocity.norm(), 1e-5) << turn << ", " << size;
      if (turn == 0 && size == 1) {  // symmetric, to the last bit
        EXPECT_EQ(system.body_contacts().count, 4);
        EXPECT_EQ(system.body(1).position.x(), 0);
        EXPECT_EQ(system.body(1).position.z(), 0);
        EXPECT_EQ(system.body(1).angular_velocity, Vector3d::Zero());
      }
    }
  }
}

TEST(BodyContact, CylindersRestOnEndAndFlank) {
  ModelBody standing = solid(Cylinder{0.5, 1}, 10, {0.2, 0.501, 0}), lying = standing;
  lying.state.attitude = Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX());
  for (const ModelBody& body : {standing, lying}) {
    CableSystem system = pressed_down(body, 0.4);
    while (system.time() < 2) system.step(2e-4);
    EXPECT_NEAR(system.body_contacts().normal_force, 100, 0.1);
    EXPECT_NEAR(system.body(1).position.y(), 0.5, 2e-3);
    EXPECT_LT(system.body(1).velocity.norm(), 1e-3);
    EXPECT_LT((system.body(1).attitude.toRotationMatrix() - body.state.attitude.toRotationMatrix()).norm(), 0.05);
  }
}

// Slides on a plane with friction: decelerated by mu g, then at rest, never pushed back.
TEST(BodyContact, FrictionBringsToRest) {
  ModelBody box = solid(Box{{1, 0.2, 1}}, 10, {-1, 0.1, 0}, {1, 0, 0});
  CableSystem system = pressed_down(box, 0.3);
  double last = 1;
  bool slides = true;
  double stop = 0;
  while (system.time() < 1) {
    system.step(2e-4);
    const double speed = system.body(1).velocity.x();
    if (slides && speed < 1e-3) {
      slides = false;
      stop = system.time();
    }
    EXPECT_LT(speed, last + 1e-3);
    EXPECT_GT(speed, -1e-3);
    last = speed;
  }
  EXPECT_NEAR(stop, 1 / (0.3 * 10), 0.02);
  EXPECT_LT(std::abs(last), 1e-6);
}

// Struck obliquely, spinning or not: friction opposes the sliding at every step, which it may stop but not turn round.
TEST(BodyContact, FrictionNeverPushesAlong) {
  for (const double spin : {0.0, 5.0, -20.0}) {
    ModelBody ball = solid(Sphere{0.5}, 2, {0, 0.55, 0}, {1, -2, 0.3});
    ball.state.angular_velocity = {0, 0.5, spin};
    CableSystem system(model_of({solid(Box{{4, 2, 4}}, 1000, {0, -1, 0}), ball}, 0.5, 0.3));
    const auto sliding = [&] {
      const BodyState state = system.body(1);
      Vector3d velocity = state.velocity + state.angular_velocity.cross(Vector3d(0, -0.5, 0)) - system.body(0).velocity;
      velocity.y() = 0;
      return velocity;
    };
    const Vector3d before = sliding();
    double power = 0, spent = 0;
    while (system.time() < 0.2) {
      system.step(1e-4);
      const EnergyAudit energy = system.audit();
      EXPECT_GE(energy.spent.total(), spent - 1e-9);
      spent = energy.spent.total();
      power = std::min(power, system.body_contacts().friction_power);
    }
    EXPECT_GE(power, -1e-9) << spin;
    const Vector3d after = sliding();
    EXPECT_GT(after.dot(before), -1e-3 * before.squaredNorm()) << spin;
    EXPECT_LT(after.norm(), before.norm()) << spin;
    // Coulomb: what slides all along changes by mu times the normal impulse.
    const Vector3d impulse = system.body_contact_impulse(1);
    EXPECT_LE(std::hypot(impulse.x(), impulse.z()), 0.3 * impulse.y() * (1 + 1e-9)) << spin;
    EXPECT_GT(impulse.y(), 5) << spin;
  }
}

// Saved in the midst of a contact, with other steps before: goes on to the last bit.
TEST(BodyContact, GoesOnFromASavedStateToTheLastBit) {
  ModelBody one = solid(Box{{1, 1.5, 2}}, 3, {0, 0, 0}, {0, 0.5, 0}),
            two = solid(Cylinder{0.7, 1.6}, 5, {0.1, 1.9, 0.2});
  one.state.attitude = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized());
  two.state.velocity = {0, -2, 0};
  const Model model = model_of({one, two}, 0.5, 0.3);
  CableSystem system(model);
  const auto numbers = [](CableSystem& of) {
    std::vector<double> values;
    of.visit_state([&](double& value) { values.push_back(value); });
    return values;
  };
  while (system.body_contacts().count == 0 && system.time() < 1) system.step(2e-4);
  for (int i = 0; i < 3; ++i) system.step(1e-4);
  ASSERT_GT(system.body_contacts().count, 0);
  const std::vector<double> saved = numbers(system);
  CableSystem other(model);
  other.step(5e-5);  // and what it knew is forgotten
  std::size_t next = 0;
  other.visit_state([&](double& value) { value = saved[next++]; });
  for (int i = 0; i < 200; ++i) {
    system.step(1e-4);
    other.step(1e-4);
    if (i % 7 == 0) other.audit();  // looking changes nothing
  }
  EXPECT_EQ(numbers(system), numbers(other));
}

// A collision that is turned by a quarter turn about y gives the turned impulses, to the last bit, until quaternions of
// tilted bodies round differently.
TEST(BodyContact, TurnsWithItsBodies) {
  const Quaterniond quarter(Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitY()));
  const auto turned = [](const Vector3d& v) { return Vector3d(v.z(), v.y(), -v.x()); };
  const auto make = [&](bool turn) {
    std::vector<ModelBody> bodies = {solid(Box{{2, 1, 2}}, 3, {0, 0, 0}), solid(Box{{1, 1, 1}}, 2, {0.2, 1.2, 0.1})};
    bodies[1].state.velocity = {0.2, -2, 0.1};
    bodies[1].state.angular_velocity = {0, 1, 0};
    for (ModelBody& body : bodies) {
      if (!turn) continue;
      body.state.position = turned(body.state.position);
      body.state.velocity = turned(body.state.velocity);
    }
    return model_of(bodies, 0.5, 0.3);
  };
  CableSystem system(make(false)), other(make(true));
  int touching = 0;
  for (int i = 0; i < 3000 && touching < 5; ++i) {
    system.step(1e-4);
    other.step(1e-4);
    touching += system.body_contacts().count > 0 ? 1 : 0;
    for (const std::int32_t body : {0, 1}) {
      ASSERT_EQ(turned(system.body_contact_impulse(body)), other.body_contact_impulse(body)) << touching;
    }
  }
  EXPECT_EQ(touching, 5);
}

TEST(BodyContact, SnapshotsHoldBothSides) {
  CableSystem system = pressed_down(solid(Sphere{1}, 10, {0.3, 1.0, 0.2}));
  while (system.time() < 1) system.step(2e-4);
  Snapshot snapshot;
  system.capture(snapshot);
  ASSERT_EQ(snapshot.contacts.size(), 2);
  for (const ContactPoint& contact : snapshot.contacts) EXPECT_EQ(contact.element, -1);
  EXPECT_EQ(snapshot.contacts[0].body, 0);
  EXPECT_NEAR(snapshot.contacts[0].force.y(), -100, 1);
  EXPECT_EQ(snapshot.contacts[0].force, -snapshot.contacts[1].force);
  EXPECT_EQ(system.contact_impulse(1), Vector3d::Zero());  // of cords
}

}  // namespace
}  // namespace netpocket
