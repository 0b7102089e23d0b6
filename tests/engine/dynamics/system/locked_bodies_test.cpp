// Bodies that are locked to each other move as one until they are released, which keeps all momenta and the energy.

#include "engine/dynamics/system/cable_system.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using namespace test;

// Two cubes side by side, spinning about their common centre of mass, with a line between them and a mass on a line.
struct TwoCubes {
  Model model;
  std::int32_t first, second;

  TwoCubes() {
    const Eigen::Vector3d spin(0.3, -0.2, 0.5), drift(0.1, 0.02, 0);
    const auto add = [&](const char* name, double mass, const Eigen::Vector3d& place) {
      return model.add_body(
          {.name = name,
           .role = BodyRole::other,
           .shape = Box{{1, 1, 1}},
           .mass = mass,
           .inertia = Eigen::Vector3d(mass / 6, mass / 4, mass / 5).asDiagonal(),
           .state = {.position = place, .velocity = drift + spin.cross(place), .angular_velocity = spin}});
    };
    first = add("first", 30, {-0.25, 0, 0});
    second = add("second", 10, {0.75, 0, 0});
    model.locks = {{first, second}};
    const std::int32_t eye = model.add_node({0.75, 0.5, 0});
    model.nodes.back().support = Support::body;
    model.nodes.back().body = second;
    const std::int32_t mass = model.add_node({0.75, 3, 0});
    model.nodes.back().point_mass = 2;
    model.lines = {{eye, mass, 2, 50, 1}};
  }
};

struct Momenta {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = Eigen::Vector3d::Zero();
};

Momenta momenta_of(const CableSystem& system) {
  Momenta sum;
  for (const std::int32_t body : {0, 1}) {
    const BodyState state = system.body(body);
    const ModelBody& given = system.model().bodies[static_cast<std::size_t>(body)];
    const Eigen::Matrix3d axes = state.attitude.toRotationMatrix();
    sum.linear += given.mass * state.velocity;
    sum.angular += axes * given.inertia * axes.transpose() * state.angular_velocity +
                   given.mass * state.position.cross(state.velocity);
  }
  sum.linear += 2 * system.velocity(1);
  sum.angular += 2 * system.position(1).cross(system.velocity(1));
  return sum;
}

class VerificationLock : public VerificationTest {};

TEST_F(VerificationLock, ReleaseKeepsMomentaAndEnergy) {
  CableSystem system(TwoCubes().model);
  const double dt = 1e-3;
  system.step(dt);
  const Momenta start = momenta_of(system);
  const double energy = system.audit().kinetic + system.audit().strain;
  double apart = 0;
  while (system.time() < 2) {
    system.step(dt);
    const BodyState a = system.body(0), b = system.body(1);
    apart = std::max(apart, (a.attitude.conjugate() * (b.position - a.position) - Eigen::Vector3d(1, 0, 0)).norm());
    apart = std::max(apart, (a.attitude.conjugate() * b.attitude).vec().norm());
  }
  EXPECT_TRUE(system.is_held(1));
  const double before = system.audit().kinetic;
  system.release(1);
  EXPECT_FALSE(system.is_held(1));
  const double after = system.audit().kinetic;
  while (system.time() < 4) system.step(dt);
  const Momenta end = momenta_of(system);
  expect_below("two locked bodies: motion against each other in 2 s, m and rad", apart, 1e-13, "stepped as one body");
  expect_below("momentum error, locked for 2 s and free for 2 s", (end.linear - start.linear).norm(), 1e-12,
               "round-off of 40 kg at 0.1 m/s");
  expect_relative("kinetic energy after release / before", after / before, 1, 1e-3,
                  "half a step of the line's pull differs");
  EXPECT_LT((end.angular - start.angular).norm(), 2e-3 * start.angular.norm()) << "velocities lag by half a step";
  EXPECT_LT(std::abs(system.audit().error), 1e-3 * energy);
  const BodyState a = system.body(0), b = system.body(1);
  EXPECT_GT((b.position - a.position).norm(), 1.05) << "they part";
}

TEST(LockedBodies, FaultsAreNamed) {
  Model model = TwoCubes().model;
  model.locks.push_back({0, 1});
  EXPECT_EQ(model.find_fault(), "lock 1 joins a body that is locked already");
  model.locks = {{0, 2}};
  EXPECT_EQ(model.find_fault(), "lock 0 joins a body that does not exist");
}

}  // namespace
}  // namespace netpocket
