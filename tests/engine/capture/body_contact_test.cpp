// Target and spacecraft of a capture touch each other.

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/capture/simulation.h"
#include "engine/scenario/check_scenario.h"
#include "engine/state/channels.h"

namespace netpocket {
namespace {

// A light target within the open pocket that flies at the spacecraft.
Scenario thrown_at_the_spacecraft(TargetShape shape) {
  Scenario scenario;
  scenario.pocket.mesh_columns = scenario.pocket.mesh_rows = 1;
  scenario.pocket.elements_per_side = 1;
  scenario.closing.start = 50;
  scenario.towing.mode = TowingMode::none;
  scenario.target.shape = shape;
  scenario.target.radius = 0.4;
  scenario.target.length = 0.8;
  scenario.target.size = {0.6, 0.6, 0.6};
  scenario.target.span = 1.6;
  scenario.target.panel_width = 0.4;
  scenario.target.dish_diameter = 0.3;
  scenario.target.mass = 5;
  scenario.target.inertia = {0.4, 0.4, 0.4};
  scenario.target.position = {0.05, 2, 0.1};
  scenario.target.velocity = {0, -2, 0};
  scenario.target.spin = {0, 0.3, 0};
  EXPECT_TRUE(check_scenario(scenario).ok()) << check_scenario(scenario).text();
  return scenario;
}

TEST(TargetMeetsSpacecraft, AndDoesNotPassThroughIt) {
  for (const TargetShape shape :
       {TargetShape::sphere, TargetShape::box, TargetShape::cylinder, TargetShape::satellite}) {
    Scenario scenario = thrown_at_the_spacecraft(shape);
    Simulation simulation(scenario);
    double lowest = 10;
    bool touched = false;
    for (int i = 1; i <= 60; ++i) {
      ASSERT_EQ(simulation.advance(0.025 * i).reason, RunReason::finished);
      const Snapshot snapshot = simulation.snapshot();
      lowest = std::min(lowest, snapshot.channel(Channel::target_y) - snapshot.channel(Channel::spacecraft_y));
      touched = touched || snapshot.channel(Channel::target_vy) > 0;
      // By cords, of which it has met none.
      EXPECT_EQ(snapshot.channel(Channel::contact_fy), 0);
    }
    const Snapshot end = simulation.snapshot();
    const int which = static_cast<int>(shape);
    EXPECT_TRUE(touched) << which;
    EXPECT_GT(lowest, 1.1) << which;  // half the bus, and more
    EXPECT_GT(end.channel(Channel::target_vy), 0.3) << which;
    EXPECT_LT(end.channel(Channel::spacecraft_vy), 0) << which;
    EXPECT_LT(std::abs(end.channel(Channel::energy_error)), 0.01 * 0.5 * 5 * 4) << which;

    scenario.contact.bodies = false;
    Simulation through(scenario);
    ASSERT_EQ(through.advance(1.5).reason, RunReason::finished);
    EXPECT_LT(through.snapshot().channel(Channel::target_y), 0) << which;
  }
}

// While they are apart nothing of a run depends on it.
TEST(TargetMeetsSpacecraft, ApartTheyChangeNoBit) {
  Scenario scenario;
  scenario.pocket.mesh_columns = scenario.pocket.mesh_rows = 2;
  Simulation with(scenario);
  scenario.contact.bodies = false;
  Simulation without(scenario);
  ASSERT_EQ(with.advance(0.3).reason, RunReason::finished);
  ASSERT_EQ(without.advance(0.3).reason, RunReason::finished);
  const Snapshot a = with.snapshot(), b = without.snapshot();
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.velocities, b.velocities);
  EXPECT_EQ(a.channels, b.channels);
}

// The elements of a finely divided rod are shorter than the rod is thick. Where it stands on the spacecraft, its second
// element lies in the face, which is no contact.
TEST(RodsOnTheSpacecraft, DoNotTouchTheFaceTheyStandOn) {
  Scenario scenario;
  scenario.pocket.mesh_columns = scenario.pocket.mesh_rows = 2;
  scenario.rods.elements_per_side = 70;
  Simulation simulation(scenario);
  const Structure& structure = simulation.structure();
  const auto rod = std::ranges::find(structure.elements, 0.05, &StructureElement::radius);
  ASSERT_NE(rod, structure.elements.end());
  ASSERT_LT(rod->length, 0.06);
  const double step = simulation.statistics().time_step;
  ASSERT_EQ(simulation.advance(200 * step).reason, RunReason::finished);
  EXPECT_EQ(simulation.snapshot().contacts.size(), 0U);
  EXPECT_EQ(simulation.snapshot().channel(Channel::penetration_max), 0);
  EXPECT_LE(simulation.statistics().steps, 210);  // none was shortened
}

TEST(TargetMeetsSpacecraft, ResumesInTheMidstOfIt) {
  const Scenario scenario = thrown_at_the_spacecraft(TargetShape::box);
  Simulation simulation(scenario);
  std::vector<double> saved;
  double time = 0;
  for (int i = 1; saved.empty() && i < 2000; ++i) {
    time = 0.001 * i;
    ASSERT_EQ(simulation.advance(time).reason, RunReason::finished);
    if (!simulation.snapshot().contacts.empty()) saved = simulation.checkpoint();
  }
  ASSERT_FALSE(saved.empty());
  Simulation resumed(scenario);
  resumed.restore(saved);
  ASSERT_EQ(simulation.advance(time + 0.3).reason, RunReason::finished);
  ASSERT_EQ(resumed.advance(time + 0.3).reason, RunReason::finished);
  const Snapshot a = simulation.snapshot(), b = resumed.snapshot();
  EXPECT_EQ(a.positions, b.positions);
  for (const std::size_t body : {0, 1}) {
    EXPECT_EQ(a.bodies[body].position, b.bodies[body].position);
    EXPECT_EQ(a.bodies[body].attitude.coeffs(), b.bodies[body].attitude.coeffs());
    EXPECT_EQ(a.bodies[body].velocity, b.bodies[body].velocity);
  }
}

}  // namespace
}  // namespace netpocket
