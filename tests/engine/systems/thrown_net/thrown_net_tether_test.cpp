// A thrown net whose tether runs off a drum: what it is made of, its brake by time and by event, its limit of tension,
// the energy of the whole, and the shipped scenario against a fixed tether.

#include <bit>
#include <cmath>

#include "engine/capture/simulation.h"
#include "engine/scenario/check_scenario.h"
#include "engine/scenario/read_scenario.h"
#include "engine/systems/capture_system.h"
#include "engine/systems/thrown_net/thrown_net.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

// A net of 4 m with few meshes on a drum, thrown past a target that is out of reach.
Scenario on_drum(const std::string& of_tether, const std::string& more = "") {
  const ScenarioResult result = read_scenario_text(
      "system = \"thrown_net\"\n[net]\nside = 4\ncells = 4\n[contact]\ncords = false\n"
      "[tether]\n" +
          (of_tether.starts_with("winch") ? "" : std::string("winch = true\n")) + of_tether +
          (more.empty() ? "[towing]\nmode = \"none\"\n[target]\nposition = [0, 300, 0]\n" : more),
      "drum.toml");
  EXPECT_TRUE(result.ok()) << result.diagnostics.text();
  EXPECT_EQ(check_scenario(result.scenario).text(), "");
  return result.scenario;
}

double channel_of(const Snapshot& snapshot, const char* name) {
  return snapshot.channels[snapshot.channel_list->find(name).value()];
}

Snapshot state_at(Simulation& simulation, double time) {
  const RunStatus status = simulation.advance(time);
  EXPECT_EQ(status.reason, RunReason::finished) << status.message;
  return simulation.snapshot();
}

TEST(ThrownNetTether, RopeOfItsDrumFollowsThoseOfTheDrawstring) {
  const ThrownNet plain = build_thrown_net(on_drum("length = 1\n"));
  EXPECT_EQ(plain.tether_rope, 0);
  EXPECT_EQ(plain.tether_end, -1);
  EXPECT_EQ(plain.drawstring_count(), 0u);
  const char* closes = "[drawstring]\nstarts_at = \"time\"\nclosed_length = 1\npassage = ";
  const std::string still = "[towing]\nmode = \"none\"\n[target]\nposition = [0, 300, 0]\n";
  for (const std::string passage : {"\"even\"\n", "\"rings\"\n"}) {
    const ThrownNet net = build_thrown_net(on_drum("length = 1\n", closes + passage + still));
    EXPECT_EQ(net.tether_rope, 4) << passage;
    EXPECT_EQ(net.drawstring_count(), 4u);
    const RingRope& tether = net.model.ring_ropes.back();
    EXPECT_EQ(tether.nodes.back(), net.node_of(net.pattern.middle));
    EXPECT_EQ(net.model.nodes[static_cast<std::size_t>(tether.nodes.front())].body, net.spacecraft);
    EXPECT_EQ(net.model.find_fault().value_or(""), "");
  }
}

// A tether on a light brake pulls with the brake's force once the drum runs: what the spacecraft and the net exchange.
TEST(ThrownNetTether, RunsOutUnderTheForceOfALightBrake) {
  Simulation simulation(on_drum("length = 1\ndrive = \"drag\"\ntension = 0.5\n"));
  double sum = 0;
  int count = 0;
  for (double time = 2; time < 5; time += 0.01) {
    sum += channel_of(state_at(simulation, time), "tether_tension");
    ++count;
  }
  const Snapshot running = simulation.snapshot();
  EXPECT_GT(channel_of(running, "tether_rate"), 0.5);
  // While the net is slowed down, the drum's mass of 1 kg gives back its own momentum.
  EXPECT_NEAR(sum / count, 0.5, 0.25);
  EXPECT_GT(channel_of(running, "tether_length"), 5);
  EXPECT_LT(std::abs(channel_of(running, "energy_error")), 0.15 * channel_of(running, "energy_dissipated"));
}

double peak_tension(Simulation& simulation, double from, double until) {
  double largest = 0;
  for (double time = from; time < until; time += 0.01) {
    largest = std::max(largest, channel_of(state_at(simulation, time), "tether_tension"));
  }
  return largest;
}

// Braked at a time, the drum gives way at its clutch's tension, but for the jerk of its own mass
// (PocketTether.ClutchOfItsWinchLimitsTheJerk), and then holds. A fixed tether of the same length stops the same net.
TEST(ThrownNetTether, BrakeHoldsUpToTheTensionOfItsClutch) {
  Simulation simulation(on_drum("length = 1\ndrive = \"drag\"\ntension = 0.1\nbrake_at = 3\nslip_tension = 3\n"));
  const double before = channel_of(state_at(simulation, 3), "tether_length");
  const double largest = peak_tension(simulation, 3.01, 8);
  const double held = channel_of(simulation.snapshot(), "tether_length");
  EXPECT_GT(held, before + 0.1) << "it slips while it stops the net";
  // Snaps of limp cords catch the drum of 1 kg again: 880 kN/6 m and 0.01 m/s make 4 N.
  EXPECT_LT(largest, 3 + 40);
  Simulation fixed(on_drum("winch = false\nlength = " + std::to_string(before) + "\n"));
  EXPECT_GT(peak_tension(fixed, 1, 8), 5 * largest);
  EXPECT_EQ(channel_of(state_at(simulation, 9), "tether_rate"), 0);
}

// Drive and brake by events: reeled in from the first touch on, braked a second after the end of the closing.
TEST(ThrownNetTether, DriveAndBrakeWaitForEvents) {
  const std::string target =
      "[target]\nshape = \"sphere\"\nradius = 1\nmass = 500\ninertia_from = \"shape\"\nposition = [0, 3, 0]\n"
      "[drawstring]\nstarts_at = \"contact\"\nduration = 1\nclosed_length = 2\n[towing]\nmode = \"none\"\n";
  Simulation simulation(
      on_drum("length = 3\ndrive = \"rate\"\nrate = -0.2\ndrive_starts_at = \"contact\"\n"
              "drive_delay = 0.5\nbrake_starts_at = \"closed\"\nbrake_delay = 1\n",
              target));
  double touch = 0, reels = 0, stops = 0;
  for (double time = 0.02; time < 8; time += 0.02) {
    const Snapshot now = state_at(simulation, time);
    const double rate = channel_of(now, "tether_rate");
    if (touch == 0 && channel_of(now, "contact_count") > 0) touch = time;
    if (reels == 0 && rate < -0.1) reels = time;
    if (reels > 0 && stops == 0 && rate == 0) stops = time;
  }
  ASSERT_GT(touch, 0);
  EXPECT_NEAR(reels, touch + 0.5, 0.1);
  EXPECT_NEAR(stops, touch + 1 + 1, 0.1);
  EXPECT_NEAR(channel_of(simulation.snapshot(), "tether_length"), 3 - 0.2 * 1.5, 0.03);
}

TEST(ThrownNet, SaysThatItsEventNeverCame) {
  const std::string far =
      "[target]\nposition = [0, 300, 0]\n[drawstring]\nstarts_at = \"contact\"\nclosed_length = 1\n";
  Simulation simulation(on_drum("length = 1\n", far + "[towing]\nstarts_at = \"closed\"\n"));
  state_at(simulation, 0.1);
  EXPECT_EQ(finished_run(simulation).message,
            "reached the end time; the closing never started, since nothing touched the target; nor did the towing");
}

TEST(ThrownNetTether, StateIsComplete) {
  const Scenario scenario = on_drum("length = 1\ndrive = \"drag\"\ntension = 0.5\nbrake_at = 2\n");
  Simulation simulation(scenario), other(scenario);
  for (const double time : {1.5, 2.5}) {
    state_at(simulation, time);
    other.restore(simulation.checkpoint());
    simulation.advance_steps(200);
    other.advance_steps(200);
    const std::vector<double> one = simulation.checkpoint(), two = other.checkpoint();
    ASSERT_EQ(one.size(), two.size());
    for (std::size_t i = 0; i + 2 < one.size(); ++i) {  // the last two are the time that the run has taken
      EXPECT_EQ(std::bit_cast<std::uint64_t>(one[i]), std::bit_cast<std::uint64_t>(two[i])) << i;
    }
  }
}

TEST(ThrownNetTether, SaysWhatIsWrong) {
  const auto problem = [](const std::string& text) {
    return check_scenario(read_scenario_text("system = \"thrown_net\"\n[target]\nposition = [0, 60, 0]\n[towing]\n"
                                             "mode = \"none\"\n[tether]\nwinch = true\n" +
                                                 text,
                                             "t.toml")
                              .scenario)
        .text();
  };
  EXPECT_EQ(problem(""), "");
  EXPECT_EQ(problem("length = 2\nleast_length = 3\n"),
            "tether.least_length: 3 m are more than the tether.length of 2 m at the start");
  EXPECT_EQ(problem("brake_starts_at = \"closed\"\n"),
            "tether.brake_starts_at: without a drawstring the net is never closed; use \"time\" or \"contact\"");
}

}  // namespace
}  // namespace netpocket
