// A pocket that the spacecraft lets go and tows on a tether.

#include "engine/scenario/pocket_tether.h"

#include <bit>

#include "engine/capture/simulation.h"
#include "engine/scenario/check_scenario.h"
#include "engine/scenario/read_scenario.h"
#include "engine/systems/capture_system.h"
#include "engine/systems/pocket/pocket.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

Scenario tethered(const std::string& more) {
  const ScenarioResult result =
      read_scenario_text("[pocket]\nmesh_columns = 3\nmesh_rows = 2\n[closing]\nduration = 2\n" + more, "tether.toml");
  EXPECT_TRUE(result.ok()) << result.diagnostics.text();
  EXPECT_EQ(check_scenario(result.scenario).text(), "");
  return result.scenario;
}

// Let go at once, 1 m of tether, towed by 400 N.
constexpr const char* kTow =
    "[tether]\nattached = true\nreleased_at = \"time\"\nrelease_time = 2.5\nlength = 1\nelements = 4\n"
    "[towing]\nmode = \"force\"\nstart = 2.5\nsize = 400\nduration = 10\n";

double pocket_channel(const Snapshot& snapshot, const char* name) {
  return snapshot.channels[snapshot.channel_list->find(name).value()];
}

// By the model's masses, in kg m/s. Cords carry half of their mass at each end.
Eigen::Vector3d momentum_of(const Model& model, const Snapshot& snapshot) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t b = 0; b < model.bodies.size(); ++b) sum += model.bodies[b].mass * snapshot.bodies[b].velocity;
  for (const ModelElement& element : model.elements) {
    const double half =
        0.5 * model.materials[static_cast<std::size_t>(element.material)].section.mass_per_length * element.length;
    sum += half * (snapshot.velocities.col(element.node1) + snapshot.velocities.col(element.node2));
  }
  for (std::size_t n = 0; n < model.nodes.size(); ++n) {
    sum += model.nodes[n].point_mass * snapshot.velocities.col(static_cast<Eigen::Index>(n));
  }
  return sum;
}

TEST(PocketTether, IsHeldThenTowedOnTheLine) {
  const Scenario scenario = tethered(kTow);
  const Model model = build_capture_system(scenario).model;
  Simulation simulation(scenario);
  ASSERT_EQ(simulation.advance(2.45).reason, RunReason::finished);
  const Snapshot held = simulation.snapshot();
  EXPECT_EQ(pocket_channel(held, "hub_held"), 1);
  EXPECT_NEAR(pocket_channel(held, "tether_distance"), 0.09, 1e-9) << "stowed";
  double tautest = 0, farthest = 0;
  for (double time = 2.6; time < 6; time += 0.02) {
    ASSERT_EQ(simulation.advance(time).reason, RunReason::finished);
    const Snapshot towed = simulation.snapshot();
    EXPECT_EQ(pocket_channel(towed, "hub_held"), 0);
    tautest = std::max(tautest, pocket_channel(towed, "tether_tension"));
    farthest = std::max(farthest, pocket_channel(towed, "tether_distance"));
  }
  EXPECT_GT(tautest, 200) << "pulls more than the tow while the pocket is jerked along";
  EXPECT_NEAR(farthest, 1, 0.05) << "strained by a few parts in a thousand";
  const Snapshot end = simulation.snapshot();
  EXPECT_LT(end.bodies[2].velocity.y(), -0.05) << "the hub follows";
  EXPECT_LT(std::abs(pocket_channel(end, "energy_error")),
            0.02 * (pocket_channel(end, "energy_dissipated") + pocket_channel(end, "energy_kinetic")));
}

// Nothing acts from outside: rods, ropes and the release only exchange momentum.
TEST(PocketTether, ReleaseKeepsMomentum) {
  const Scenario scenario =
      tethered("[tether]\nattached = true\nreleased_at = \"closed\"\nrelease_delay = 0.1\n[towing]\nmode = \"none\"\n");
  const Model model = build_capture_system(scenario).model;
  Simulation simulation(scenario);
  double moved = 0, largest = 0;
  for (double time = 0.5; time < 4; time += 0.1) {
    ASSERT_EQ(simulation.advance(time).reason, RunReason::finished);
    const Snapshot snapshot = simulation.snapshot();
    largest = std::max(largest, momentum_of(model, snapshot).norm());
    moved = std::max(moved, scenario.spacecraft.mass * snapshot.bodies[0].velocity.norm());
  }
  EXPECT_EQ(pocket_channel(simulation.snapshot(), "hub_held"), 0);
  EXPECT_GT(moved, 0.1);
  EXPECT_LT(largest, 0.02 * moved) << "but for the mass that flows in the closing ropes";
}

// A drum of the mass m = J/r^2 is caught up at the speed v by a line of the stiffness k: beyond the tension at which
// its clutch slips there is v sqrt(k m) at most, until the drum runs as fast as the line.
TEST(PocketTether, ClutchOfItsWinchLimitsTheJerk) {
  constexpr double kSlip = 60;
  const std::string winch = "winch = true\ndrive = \"brake\"\nslip_tension = 60\nreserve = 5\n";
  std::string text = kTow;
  text.insert(text.find("released_at"), winch);
  const Scenario scenario = tethered(text);
  const PocketTether tether = pocket_tether(scenario);
  const Model model = build_capture_system(scenario).model;
  ASSERT_EQ(model.ring_ropes.size(), 1u);
  const double stiffness = model.ring_ropes[0].stiffness / tether.length;
  const double drum = tether.drum.inertia / (tether.drum.radius * tether.drum.radius);
  Simulation simulation(scenario);
  ASSERT_EQ(simulation.advance(2.45).reason, RunReason::finished);
  EXPECT_EQ(pocket_channel(simulation.snapshot(), "tether_length"), 1);
  double speed = 0, largest = 0, longest = 0;
  bool is_taut = false;
  for (double time = 3.5; time < 6; time += 0.002) {
    ASSERT_EQ(simulation.advance(time).reason, RunReason::finished);
    const Snapshot towed = simulation.snapshot();
    is_taut = is_taut || pocket_channel(towed, "tether_tension") > 0;
    if (!is_taut) speed = (towed.bodies[0].velocity - towed.bodies[2].velocity).norm();
    largest = std::max(largest, pocket_channel(towed, "tether_tension"));
    longest = std::max(longest, pocket_channel(towed, "tether_length"));
  }
  EXPECT_GT(largest, kSlip);
  EXPECT_LT(largest, kSlip + 1.1 * speed * std::sqrt(stiffness * drum));
  EXPECT_GT(longest, 1.02) << "it has slipped";
  const Snapshot end = simulation.snapshot();
  EXPECT_LT(std::abs(pocket_channel(end, "energy_error")),
            0.02 * (pocket_channel(end, "energy_dissipated") + pocket_channel(end, "energy_kinetic")));
}

// Reeled in at a given rate once it is let go, then braked: the length stays.
TEST(PocketTether, WinchReelsInAndHolds) {
  Simulation simulation(
      tethered("[tether]\nattached = true\nreleased_at = \"time\"\nrelease_time = 2.1\nlength = 3\nwinch = true\n"
               "drive = \"rate\"\nrate = -0.4\nbrake_at = 4\n[towing]\nmode = \"none\"\n"));
  ASSERT_EQ(simulation.advance(3.9).reason, RunReason::finished);
  EXPECT_NEAR(pocket_channel(simulation.snapshot(), "tether_rate"), -0.4, 1e-3);
  ASSERT_EQ(simulation.advance(4.2).reason, RunReason::finished);
  const double held = pocket_channel(simulation.snapshot(), "tether_length");
  EXPECT_NEAR(held, 3 - 0.4 * 1.9, 0.02);
  ASSERT_EQ(simulation.advance(5).reason, RunReason::finished);
  EXPECT_EQ(pocket_channel(simulation.snapshot(), "tether_length"), held);
}

TEST(PocketTether, WithoutItThePocketIsAsEver) {
  const Pocket pocket = build_pocket(tethered(""));
  EXPECT_EQ(pocket.hub, -1);
  EXPECT_EQ(pocket.base(), pocket.spacecraft);
  EXPECT_TRUE(pocket.model.locks.empty());
  EXPECT_EQ(pocket.model.bodies.size(), 2u);
}

TEST(PocketTether, StateIsComplete) {
  Simulation simulation(tethered(kTow)), other(tethered(kTow));
  for (const double time : {2.4, 2.6}) {  // held, and let go
    ASSERT_EQ(simulation.advance(time).reason, RunReason::finished);
    other.restore(simulation.checkpoint());
    ASSERT_EQ(simulation.advance_steps(200).reason, RunReason::finished);
    ASSERT_EQ(other.advance_steps(200).reason, RunReason::finished);
    const std::vector<double> one = simulation.checkpoint(), two = other.checkpoint();
    ASSERT_EQ(one.size(), two.size());
    for (std::size_t i = 0; i + 2 < one.size(); ++i) {  // the last two are the time that the run has taken
      EXPECT_TRUE(std::bit_cast<std::uint64_t>(one[i]) == std::bit_cast<std::uint64_t>(two[i]))
          << i << " of " << one.size() << ": " << one[i] << " and " << two[i];
    }
  }
}

TEST(PocketTether, SaysWhatIsWrong) {
  const auto problem = [](const std::string& text) {
    return check_scenario(read_scenario_text("[tether]\nattached = true\n" + text, "t.toml").scenario).text();
  };
  EXPECT_EQ(problem(""), "");
  EXPECT_EQ(problem("[[controller]]\nkind = \"attitude_pd\"\n").substr(0, 15), "tether.attached");
  EXPECT_EQ(problem("elements = 1000\ndiameter = 0.02\n"),
            "tether.elements: elements of 0.01 m are shorter than the tether is thick");
}

}  // namespace
}  // namespace netpocket
