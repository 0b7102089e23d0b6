// The tide of an orbit on free masses, rigid bodies and cables, against closed formulas and against satellites that are
// followed one by one round the Earth.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/orbit/gravity.h"
#include "tests/engine/dynamics/models.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

using test::advance;

constexpr OrbitElements kOrbit{.perigee_radius = 6.778e6, .inclination = 0.9, .argument_of_perigee = 0.4};
constexpr double kPi = std::numbers::pi;
const double kRate = std::sqrt(kEarthMu / std::pow(kOrbit.perigee_radius, 3));  // rad/s
const double kPeriod = 2 * kPi / kRate;

class VerificationTide : public test::VerificationTest {};

// x away from the Earth, y ahead, z along the orbit's angular momentum: the axes of most books.
Orbit up_and_ahead(OrbitField field, const OrbitElements& elements = kOrbit) {
  return orbit_of(elements, field, LocalAxis::minus_r_bar, LocalAxis::v_bar);
}

std::int32_t add_mass(Model& model, const Eigen::Vector3d& position, const Eigen::Vector3d& velocity, double mass) {
  const std::int32_t node = model.add_node(position);
  model.nodes[static_cast<std::size_t>(node)].velocity = velocity;
  model.nodes[static_cast<std::size_t>(node)].point_mass = mass;
  return node;
}

// Clohessy & Wiltshire: position at `t` in axes that turn with the orbit, from r and v in these axes.
Eigen::Vector3d clohessy_wiltshire(const Eigen::Vector3d& r, const Eigen::Vector3d& v, double t) {
  const double n = kRate, c = std::cos(n * t), s = std::sin(n * t);
  return {(4 - 3 * c) * r.x() + s / n * v.x() + 2 / n * (1 - c) * v.y(),
          6 * (s - n * t) * r.x() + r.y() - 2 / n * (1 - c) * v.x() + (4 * s - 3 * n * t) / n * v.y(),
          c * r.z() + s / n * v.z()};
}

Eigen::Vector3d in_turning_axes(const Eigen::Vector3d& fixed, double time) {
  return Eigen::AngleAxisd(-kRate * time, Eigen::Vector3d::UnitZ()) * fixed;
}

TEST_F(VerificationTide, FreeMassesFollowClohessyAndWiltshire) {
  const Eigen::Vector3d r(12, -7, 5), v(0.01, -0.03, 0.02), turning(0, 0, kRate);
  Model model;
  model.orbit = up_and_ahead(OrbitField::hill);
  const auto node = add_mass(model, r, v + turning.cross(r), 3);
  model.add_body({.name = "ball",
                  .shape = Sphere{1},
                  .mass = 5,
                  .inertia = 2 * Eigen::Matrix3d::Identity(),
                  .state = {.position = r, .velocity = v + turning.cross(r)}});
  CableSystem system(model);
  double worst = 0, of_body = 0, size = 0;
  for (int part = 1; part <= 24; ++part) {
    const double time = kPeriod * part / 24;
    advance(system, time, 0.5);
    const Eigen::Vector3d expected = clohessy_wiltshire(r, v, system.time());
    worst = std::max(worst, (in_turning_axes(system.position(node), system.time()) - expected).cwiseAbs().maxCoeff());
    of_body = std::max(of_body, (system.body(0).position - system.position(node)).norm());
    size = std::max(size, expected.norm());
  }
  EXPECT_GT(size, 50);
  expect_below("Hill's equations for one orbit: largest error of a component / distance", worst / size, 1e-6,
               "Clohessy & Wiltshire (1960), doi:10.2514/8.8704: the same linear equation, steps of 0.5 s");
  EXPECT_LT(of_body, 1e-9 * size);
  const EnergyAudit energy = system.audit();
  EXPECT_GT(std::abs(energy.tidal), 1e-3);
  EXPECT_EQ(energy.tidal, energy.input);
  expect_below("energy error of two free masses in an orbit / work of the tide", std::abs(energy.error / energy.tidal),
               1e-11, "the account takes what leapfrog does: round-off only");
}

// Order 4 with steps of 0.5 s: errs by less than 1e-5 m.
Eigen::Vector3d fly(Eigen::Vector3d r, Eigen::Vector3d v, double time, double j2) {
  const int count = static_cast<int>(std::lround(time / 0.5));
  const double h = time / count;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d a1 = gravity_at(r, j2), a2 = gravity_at(r + 0.5 * h * v, j2);
    const Eigen::Vector3d v2 = v + 0.5 * h * a1, v3 = v + 0.5 * h * a2;
    const Eigen::Vector3d a3 = gravity_at(r + 0.5 * h * v2, j2), v4 = v + h * a3, a4 = gravity_at(r + h * v3, j2);
    r += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return r;
}

// Two satellites that do not know of each other, about the Earth; ours as masses near the reference orbit.
TEST_F(VerificationTide, TwoSatellitesKeepTheDistanceThatTheyHaveAboutTheEarth) {
  OrbitElements elements = kOrbit;
  elements.eccentricity = 0.02;
  for (const OrbitField field : {OrbitField::two_body, OrbitField::two_body_j2}) {
    const double j2 = field == OrbitField::two_body_j2 ? kEarthJ2 : 0;
    const Orbit orbit = up_and_ahead(field, elements);
    const Eigen::Vector3d up = orbit.position.normalized(), across = orbit.position.cross(orbit.velocity).normalized();
    Eigen::Matrix3d axes;
    axes << up, across.cross(up), across;
    const std::vector<Eigen::Vector3d> places = {{4, 9, -6}, {-8, 3, 7}},
                                       speeds = {{0.004, -0.007, 0.01}, {0, 0.008, 0}};
    Model model;
    model.orbit = orbit;
    for (int i = 0; i < 2; ++i) add_mass(model, places[i], speeds[i], 1);
    CableSystem system(model);
    advance(system, 5500, 0.5);
    std::vector<Eigen::Vector3d> far;
    for (int i = 0; i < 2; ++i) {
      far.push_back(fly(orbit.position + axes * places[i], orbit.velocity + axes * speeds[i], system.time(), j2));
    }
    const Eigen::Vector3d ours = system.position(1) - system.position(0);
    const Eigen::Vector3d theirs = axes.transpose() * (far[1] - far[0]);
    expect_below(j2 == 0 ? "two satellites after 5500 s, point mass: error of their distance vector / distance"
                         : "two satellites after 5500 s, with J2: error of their distance vector / distance",
                 (ours - theirs).norm() / theirs.norm(), 1e-4,
                 "both integrated about the Earth; second order of gravity, 3 r/(2 R) of the tide for r up to 50 m, "
                 "grows with the drift");
    EXPECT_GT(theirs.norm(), 40);
  }
}

ModelBody dumbbell(double tilt) {
  const Eigen::Vector3d moments(1, 1000, 1000);  // long along x, up
  return {.name = "dumbbell",
          .shape = Sphere{1},
          .mass = 10,
          .inertia = moments.asDiagonal(),
          .state = {.attitude = Eigen::Quaterniond(Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitZ())),
                    .angular_velocity = {0, 0, kRate}}};
}

TEST_F(VerificationTide, ALongBodyLibratesAboutTheVertical) {
  Model model;
  model.orbit = up_and_ahead(OrbitField::hill);
  model.add_body(dumbbell(0.05));
  CableSystem system(model);
  const auto pitch = [&] {
    const Eigen::Vector3d axis = in_turning_axes(system.body(0).attitude * Eigen::Vector3d::UnitX(), system.time());
    return std::atan2(axis.y(), axis.x());
  };
  // From one crossing of the vertical downwards to the third after it.
  std::vector<double> crossings;
  const double dt = 0.5;
  double before = pitch();
  while (crossings.size() < 4 && system.time() < 3 * kPeriod) {
    system.step(dt);
    const double now = pitch();
    if (before > 0 && now <= 0) crossings.push_back(system.time() - dt * now / (now - before));
    before = now;
  }
  ASSERT_EQ(crossings.size(), 4u);
  const double ratio = (1000.0 - 1.0) / 1000.0, swing = 1 - 0.05 * 0.05 / 4;
  expect_relative("pitch of a long body in a circular orbit, rad/s", 2 * kPi * 3 / (crossings[3] - crossings[0]),
                  std::sqrt(3 * ratio) * kRate * swing, 1e-4,
                  "n sqrt(3 (I_roll - I_yaw)/I_pitch), Schaub & Junkins section 4.4, with the amplitude's 1 - a^2/4");
  const EnergyAudit energy = system.audit();
  EXPECT_LT(std::abs(energy.error), 1e-11 * energy.kinetic);
}

// The torque for a body in any attitude, against 3 mu/R^3 r x I r.
TEST(TidalField, TurnsABodyAsTheClosedFormulaSays) {
  Model model;
  model.orbit = up_and_ahead(OrbitField::hill);
  const Eigen::Vector3d moments(3, 5, 7);
  const Eigen::Quaterniond attitude(Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, -1).normalized()));
  model.add_body({.name = "block",
                  .shape = Sphere{1},
                  .mass = 1,
                  .inertia = moments.asDiagonal(),
                  .state = {.attitude = attitude}});
  CableSystem system(model);
  system.step(0.02);
  const Eigen::Matrix3d inertia =
      attitude.toRotationMatrix() * moments.asDiagonal() * attitude.toRotationMatrix().transpose();
  const Eigen::Vector3d up = Eigen::Vector3d::UnitX(), expected = 3 * kRate * kRate * up.cross(inertia * up);
  const Eigen::Vector3d change = inertia * system.body(0).angular_velocity / 0.01;  // the first kick is half a step
  EXPECT_LT((change - expected).norm(), 1e-9 * expected.norm());
}

// Two masses on a line, one above the other, turning with the orbit.
TEST_F(VerificationTide, AVerticalTetherIsTaut) {
  const double mass = 100, length = 80;
  Model model;
  model.orbit = up_and_ahead(OrbitField::hill);
  const auto low = add_mass(model, {-length / 2, 0, 0}, {0, -kRate * length / 2, 0}, mass);
  const auto high = add_mass(model, {length / 2, 0, 0}, {0, kRate * length / 2, 0}, mass);
  model.lines = {{low, high, length, 4, 4}};
  CableSystem system(model);
  advance(system, 400, 0.02);
  const double stretch = (system.position(high) - system.position(low)).norm() - length;
  expect_relative("tension of a vertical tether of 80 m between 100 kg and 100 kg, N", 4 * stretch,
                  3 * kRate * kRate * mass / 2 * length, 1e-3, "3 n^2 m L with the reduced mass m = 50 kg");
}

// A cable that hangs freely along the vertical: a tension that varies along it as a parabola.
TEST_F(VerificationTide, AVerticalCableCarriesItsOwnTide) {
  for (const auto evaluation : {ElementEvaluation::mean_strain, ElementEvaluation::full}) {
    const double length = 100, per_length = 0.1;
    CableMaterial material = test::plain_cable(50, 1e-3, per_length);
    material.section.axial_damping = 1;
    test::Cable cable = test::straight_cable(material, {-length / 2, 0, 0}, {length / 2, 0, 0}, 10);
    cable.model.orbit = up_and_ahead(OrbitField::hill);
    const Eigen::Vector3d turning(0, 0, kRate);
    for (ModelNode& node : cable.model.nodes) node.velocity = turning.cross(node.position);
    for (ModelGradient& gradient : cable.model.gradients) gradient.rate = turning.cross(gradient.value);
    CableSystem system(cable.model, {.evaluation = evaluation});
    advance(system, 60, 0.5 * system.stable_step().step);
    Snapshot snapshot;
    const EnergyAudit energy = system.capture(snapshot);
    const double middle = 0.5 * (snapshot.tension[cable.elements[4]] + snapshot.tension[cable.elements[5]]);
    const bool is_full = evaluation == ElementEvaluation::full;
    expect_relative(is_full ? "tension in the middle of a vertical cable of 100 m, full, N"
                            : "tension in the middle of a vertical cable of 100 m, mean strain, N",
                    middle, 3 * kRate * kRate * per_length * length * length / 8 * (is_full ? 1 - 1.0 / 75 : 1), 5e-3,
                    is_full ? "3 n^2 m' L^2/8, the integral of 3 n^2 m' x, less 1/75: mean over a tenth of the cable"
                            : "3 n^2 m' L^2/8, the integral of 3 n^2 m' x; lumped masses of gradients add a "
                              "300th for ten elements");
    EXPECT_LT(std::abs(energy.error), 1e-2 * energy.strain);
  }
}

TEST(TidalField, IsPartOfTheStateThatACheckpointKeeps) {
  test::Cable cable = test::straight_cable(test::net_cord(), {-5, 2, 0}, {5, 3, 1}, 4);
  cable.model.orbit = up_and_ahead(OrbitField::two_body_j2);
  cable.model.add_body(dumbbell(0.3));
  const auto state = [](CableSystem& system) {
    std::vector<double> values;
    system.visit_state([&](double& value) { values.push_back(value); });
    return values;
  };
  CableSystem one(cable.model), other(cable.model);
  const double dt = 0.5 * one.stable_step().step;
  for (int i = 0; i < 50; ++i) one.step(dt);
  const std::vector<double> kept = state(one);
  std::size_t next = 0;
  other.visit_state([&](double& value) { value = kept[next++]; });
  for (int i = 0; i < 50; ++i) {
    one.step(dt);
    other.step(dt);
  }
  EXPECT_EQ(state(one), state(other));
  EXPECT_EQ(one.audit().tidal, other.audit().tidal);
  EXPECT_NE(one.audit().tidal, 0);
}

TEST(TidalField, LeavesFixedNodesAndFarOffSystemsAlone) {
  Model model;
  const auto node = add_mass(model, {10, 0, 0}, {0, 0, 0}, 1);
  CableSystem far(model);
  far.step(1);
  EXPECT_EQ(far.position(node), Eigen::Vector3d(10, 0, 0));
  model.orbit = up_and_ahead(OrbitField::hill);
  model.fix_node(node);
  CableSystem fixed(model);
  fixed.step(1);
  EXPECT_EQ(fixed.position(node), Eigen::Vector3d(10, 0, 0));
}

TEST(TidalField, NeedsAClosedOrbit) {
  Model model;
  model.orbit = Orbit{.position = {7e6, 0, 0}, .velocity = {0, 12e3, 0}};
  EXPECT_EQ(model.find_fault(), "the orbit is not a closed one round the Earth");
}

}  // namespace
}  // namespace netpocket
