// Symmetric captures (solver.symmetry): the run of one sector against that of all, what makes it leave, and that it
// leaves without a jump.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "engine/capture/simulation.h"
#include "engine/control/controller.h"
#include "engine/scenario/read_scenario.h"
#include "tests/engine/capture/state_validator.h"

namespace netpocket {
namespace {

Scenario case_1() {
  ScenarioResult result = read_scenario_file(NETPOCKET_SOURCE_DIR "/scenarios/case1.toml");
  EXPECT_TRUE(result.ok()) << result.diagnostics.text();
  return result.scenario;
}

// Case 1 with coarse meshes, in a third of the time: the mouth meets the target at 1.9 s.
Scenario coarse(Symmetry symmetry) {
  Scenario scenario = case_1();
  scenario.pocket.mesh_columns = scenario.pocket.mesh_rows = 2;
  scenario.closing.duration = 3;
  scenario.towing.start = 3;
  scenario.solver.symmetry = symmetry;
  return scenario;
}

struct Difference {
  double node = 0, body = 0, force = 0, energy = 0;  // m, m, N, J
};

double largest_distance(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
  return (a - b).colwise().norm().maxCoeff();
}

Difference difference(const Snapshot& a, const Snapshot& b) {
  Difference result;
  result.node = largest_distance(a.positions, b.positions);
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    result.body = std::max(result.body, (a.bodies[i].position - b.bodies[i].position).norm());
  }
  const auto gap = [&](Channel channel) { return std::abs(a.channel(channel) - b.channel(channel)); };
  result.force = gap(Channel::contact_fy);
  for (const Channel energy : {Channel::energy_kinetic, Channel::energy_strain, Channel::energy_dissipated,
                               Channel::energy_input, Channel::energy_error}) {
    result.energy = std::max(result.energy, gap(energy));
  }
  return result;
}

void advance(Simulation& simulation, double until) {
  const RunStatus status = simulation.advance(until);
  ASSERT_EQ(status.reason, RunReason::finished) << status.message;
}

// Pushes the spacecraft across the axis from a time (s) on, by a force too small to move it.
class Nudge : public Controller {
 public:
  explicit Nudge(double start) : start_(start) {}
  void update(const Measurements& measurements, double /*interval*/, Commands& commands) override {
    if (measurements.time() >= start_) commands.body(0).at_centre.force.x() = 1e-200;
  }
  void visit_state(const std::function<void(double&)>& /*visit*/) override {}

 private:
  double start_;
};

constexpr double kNever = std::numeric_limits<double>::infinity();

TEST(SectorRun, AgreesWithTheRunOfAllSectorsToRoundOff) {
  Simulation whole(coarse(Symmetry::off)), sector(coarse(Symmetry::automatic));
  EXPECT_FALSE(whole.symmetry().is_symmetric);
  for (const double time : {0.1, 0.5, 1.0, 1.5, 1.75}) {
    advance(whole, time);
    advance(sector, time);
    ASSERT_TRUE(sector.symmetry().is_symmetric) << sector.symmetry().reason;
    const Difference by = difference(whole.snapshot(), sector.snapshot());
    EXPECT_LT(by.node, 1e-11) << "m, at " << time << " s";
    EXPECT_LT(by.body, 1e-13) << "m, at " << time << " s";
    EXPECT_LT(by.energy, 1e-9) << "J, at " << time << " s";
  }
}

// Slack cords amplify round-off, and so does contact. So the bound is how far two runs of all sectors are apart that
// differ by 1e-14 m at the start.
TEST(SectorRun, IsAsNearInCase1AsARunDisplacedByRoundOff) {
  Scenario scenario = case_1();
  Simulation whole(scenario);
  scenario.solver.perturbation = 1e-14;
  Simulation displaced(scenario);
  scenario.solver.perturbation = 0;
  scenario.solver.symmetry = Symmetry::automatic;
  Simulation sector(scenario);
  constexpr double kMore = 5;  // the two are random
  for (const double time : {0.5, 2.0, 5.0, 7.5, 10.0}) {
    for (Simulation* simulation : {&whole, &displaced, &sector}) advance(*simulation, time);
    ASSERT_TRUE(sector.symmetry().is_symmetric) << sector.symmetry().reason;
    const Snapshot one = whole.snapshot();
    const Difference by = difference(one, sector.snapshot()), chance = difference(one, displaced.snapshot());
    EXPECT_LT(by.node, kMore * chance.node) << "m, at " << time << " s";
    EXPECT_LT(by.body, kMore * chance.body + 1e-12) << "m, at " << time << " s";
    EXPECT_LT(by.force, kMore * chance.force + 1e-9) << "N, at " << time << " s";
    EXPECT_LT(by.energy, kMore * chance.energy + 1e-9) << "J, at " << time << " s";
  }
}

// Steps from one state, in contact: nothing but the sums' order differs.
TEST(SectorRun, LeavesInContactWithoutAJump) {
  Simulation goes_on(coarse(Symmetry::automatic)), leaves(coarse(Symmetry::automatic));
  goes_on.add_controller(std::make_unique<Nudge>(kNever));
  leaves.add_controller(std::make_unique<Nudge>(1.0));
  advance(goes_on, 2.0);
  leaves.restore(goes_on.checkpoint());
  ASSERT_TRUE(leaves.symmetry().is_symmetric);
  for (const int steps : {1, 1, 20}) {
    ASSERT_EQ(goes_on.advance_steps(steps).reason, RunReason::finished);
    ASSERT_EQ(leaves.advance_steps(steps).reason, RunReason::finished);
    ASSERT_TRUE(goes_on.symmetry().is_symmetric);
    ASSERT_FALSE(leaves.symmetry().is_symmetric);
    const Snapshot one = goes_on.snapshot(), other = leaves.snapshot();
    ASSERT_GT(one.contacts.size(), 0u);
    EXPECT_EQ(one.contacts.size(), other.contacts.size());
    EXPECT_EQ(one.step, other.step);
    const Difference by = difference(one, other);
    EXPECT_LT(by.node, 1e-12);
    EXPECT_LT(by.body, 1e-14);
    EXPECT_LT(by.force, 1e-5);
    EXPECT_LT(by.energy, 1e-8);
    EXPECT_LT((one.tension - other.tension).cwiseAbs().maxCoeff(), 1e-5);
  }
  EXPECT_NE(leaves.symmetry().reason.find("spacecraft"), std::string::npos) << leaves.symmetry().reason;
}

TEST(SectorRun, ContactsOfASnapshotAreThoseOfAllSectors) {
  Simulation simulation(coarse(Symmetry::automatic));
  advance(simulation, 2.0);
  ASSERT_TRUE(simulation.symmetry().is_symmetric);
  const Snapshot snapshot = simulation.snapshot();
  ASSERT_GT(snapshot.contacts.size(), 0u);
  EXPECT_EQ(snapshot.contacts.size() % 8, 0u);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double size = 0;
  for (const ContactPoint& contact : snapshot.contacts) {
    const Eigen::Vector3d centre = snapshot.bodies[static_cast<std::size_t>(contact.body)].position;
    EXPECT_NEAR((contact.position - centre).norm(), 4.755, 1e-9);  // the target's radius
    sum += contact.force;
    size += contact.force.norm();
  }
  EXPECT_LT(std::hypot(sum.x(), sum.z()), 1e-12 * size);
}

TEST(SectorRun, GoesOnBitwiseFromItsCheckpoints) {
  Simulation simulation(coarse(Symmetry::automatic));
  test::advance_validated(simulation, 2.1, 0.7);
  EXPECT_TRUE(simulation.symmetry().is_symmetric);
  test::advance_validated(simulation, 3.2, 0.55);  // the tow begins at 3 s
  EXPECT_FALSE(simulation.symmetry().is_symmetric);
}

// Leaves for the tow, whose line is off the axis.
TEST(SectorRun, IsLeftForTheTow) {
  Scenario scenario = coarse(Symmetry::automatic);
  scenario.towing.start = 0.5;
  scenario.towing.offset_angle = 0.3;
  Simulation simulation(scenario);
  advance(simulation, 0.49);
  EXPECT_TRUE(simulation.symmetry().is_symmetric);
  advance(simulation, 0.6);
  EXPECT_FALSE(simulation.symmetry().is_symmetric);
  EXPECT_NEAR(simulation.symmetry().since, 0.5, 0.01);
  EXPECT_EQ(simulation.symmetry().reason, "the spacecraft is pushed across the axis or turned about another one");
}

TEST(SectorRun, IsKeptForATowAlongTheAxis) {
  Scenario scenario = coarse(Symmetry::automatic);
  scenario.towing.start = 0.5;
  scenario.towing.offset = 0;
  Simulation simulation(scenario);
  scenario.solver.symmetry = Symmetry::off;
  Simulation whole(scenario);
  advance(simulation, 1);
  advance(whole, 1);
  EXPECT_TRUE(simulation.symmetry().is_symmetric) << simulation.symmetry().reason;
  const Difference by = difference(whole.snapshot(), simulation.snapshot());
  EXPECT_LT(by.node, 1e-11);
  EXPECT_LT(by.energy, 1e-9);
}

TEST(SectorRun, IsRefusedWhereAnythingIsNotQuiteSymmetric) {
  const auto reason = [](const std::function<void(Scenario&)>& change) {
    Scenario scenario = coarse(Symmetry::automatic);
    change(scenario);
    Simulation simulation(scenario);
    EXPECT_EQ(simulation.advance_steps(1).reason, RunReason::finished);
    EXPECT_EQ(simulation.symmetry().is_symmetric, simulation.symmetry().reason.empty());
    return simulation.symmetry().reason;
  };
  EXPECT_EQ(reason([](Scenario&) {}), "");
  EXPECT_EQ(reason([](Scenario& s) { s.target.position.x() = 1e-6; }),
            "the target is not on the axis or does not move along it");
  EXPECT_EQ(reason([](Scenario& s) { s.target.velocity.z() = 1e-6; }),
            "the target is not on the axis or does not move along it");
  EXPECT_EQ(reason([](Scenario& s) { s.target.velocity.y() = 1e-3; }), "");
  EXPECT_EQ(reason([](Scenario& s) { s.solver.perturbation = 1e-10; }), "nodes are displaced");
  EXPECT_EQ(reason([](Scenario& s) { s.solver.evaluation = Evaluation::full; }),
            "only mean-strain elements are computed by sectors");
  EXPECT_EQ(reason([](Scenario& s) { s.solver.gravity = {0, -9.81, 0}; }), "");
  EXPECT_EQ(reason([](Scenario& s) { s.solver.gravity = {1e-3, 0, 0}; }), "gravity acts across the axis");
}

// Steps until cords touch, then goes on with all sectors.
TEST(SectorRun, IsLeftWhenCordsTouch) {
  Scenario scenario = coarse(Symmetry::automatic);
  scenario.closing.closed_length = 0.3;
  scenario.closing.duration = 2;
  scenario.target.radius = 0.5;
  Simulation simulation(scenario);
  for (double time = 0.1; time < 2.5 && simulation.symmetry().is_symmetric; time += 0.1) advance(simulation, time);
  EXPECT_FALSE(simulation.symmetry().is_symmetric);
  EXPECT_EQ(simulation.symmetry().reason, "cords touch each other") << simulation.symmetry().since;
  EXPECT_GT(simulation.symmetry().since, 0);
}

// Cords of an odd number of elements, cut rods with strain partners, no strain partners at all.
TEST(SectorRun, AgreesForAnyDivisionOfCords) {
  const std::vector<std::function<void(Scenario&)>> divisions = {
      [](Scenario& s) { s.rods.elements_per_side = 2; },   [](Scenario& s) { s.rods.elements_per_side = 3; },
      [](Scenario& s) { s.pocket.elements_per_side = 1; }, [](Scenario& s) { s.pocket.elements_per_side = 3; },
      [](Scenario& s) { s.closing.elements = 3; },         [](Scenario& s) { s.solver.pair_strains = false; }};
  for (std::size_t i = 0; i < divisions.size(); ++i) {
    Scenario scenario = coarse(Symmetry::off);
    divisions[i](scenario);
    Simulation whole(scenario);
    scenario.solver.symmetry = Symmetry::automatic;
    Simulation sector(scenario);
    advance(whole, 0.15);
    advance(sector, 0.15);
    ASSERT_TRUE(sector.symmetry().is_symmetric) << sector.symmetry().reason;
    const Difference by = difference(whole.snapshot(), sector.snapshot());
    EXPECT_LT(by.node, 1e-10) << "m, division " << i;
    EXPECT_LT(by.energy, 1e-8) << "J, division " << i;
  }
}

class SectorRunOfRods : public testing::TestWithParam<int> {};

TEST_P(SectorRunOfRods, AgreesWithTheRunOfAllSectors) {
  Scenario scenario = coarse(Symmetry::off);
  scenario.pocket.rod_count = GetParam();
  scenario.target.radius = 2;
  scenario.closing.closed_length = 1.5;
  Simulation whole(scenario);
  scenario.solver.symmetry = Symmetry::automatic;
  Simulation sector(scenario);
  for (const double time : {0.1, 0.6}) {
    advance(whole, time);
    advance(sector, time);
    ASSERT_TRUE(sector.symmetry().is_symmetric) << sector.symmetry().reason;
    const Difference by = difference(whole.snapshot(), sector.snapshot());
    EXPECT_LT(by.node, 1e-11) << "m, at " << time << " s";
    EXPECT_LT(by.energy, 1e-9) << "J, at " << time << " s";
  }
}

INSTANTIATE_TEST_SUITE_P(Rods, SectorRunOfRods, testing::Values(3, 4, 6, 7, 12));

}  // namespace
}  // namespace netpocket
