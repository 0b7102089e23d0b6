// A second kind of capture system goes through the whole program: check, run, info, plot, render, export, resume.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/capture/simulation.h"
#include "engine/recording/recording.h"
#include "engine/scenario/check_scenario.h"
#include "engine/scenario/read_scenario.h"
#include "engine/scenario/write_scenario.h"
#include "engine/systems/capture_system.h"
#include "tests/gui/program.h"
#include "tests/systems/falling_net/falling_net.h"

namespace netpocket {
namespace {

constexpr const char* kScenario = R"(system = "falling_net"

[falling_net]
cells = 5
side = 4
height = 1.4
speed = 3

[target]
radius = 0.7
mass = 40
inertia = [8, 8, 8]
position = [0, 0, 0]
spin = [0, 0.3, 0]

[output]
end_time = 1.2
frame_rate = 25
)";

class SecondSystem : public testing::Test {
 protected:
  static void SetUpTestSuite() { register_falling_net(); }

  static Scenario scenario(const std::string& more = "") {
    const ScenarioResult result = read_scenario_text(kScenario + more, "falling_net.toml");
    EXPECT_TRUE(result.ok()) << result.diagnostics.text();
    return result.scenario;
  }

  ProgramResult run(const std::vector<std::string>& arguments) {
    const ProgramResult result = run_program(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.error;
    return result;
  }

  std::string recorded(const std::vector<std::string>& more = {}) {
    const std::string path = folder_.file("net.h5");
    std::vector<std::string> words = {"run", folder_.write("net.toml", kScenario), "-o", path, "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    run(words);
    return path;
  }

  TestFolder folder_;
};

TEST_F(SecondSystem, HasParametersOfItsOwn) {
  const Scenario read = scenario();
  EXPECT_EQ(read.system, "falling_net");
  EXPECT_EQ(std::get<double>(find_parameter("falling_net.speed", "falling_net")->get(read)), 3);
  EXPECT_EQ(std::get<double>(find_parameter("falling_net.corner_mass", "falling_net")->get(read)), 0.5);
  EXPECT_EQ(find_parameter("closing.duration", "falling_net"), nullptr);
  EXPECT_EQ(find_parameter("falling_net.speed"), nullptr);
  EXPECT_TRUE(check_scenario(read).ok()) << check_scenario(read).text();
  // What is written is complete and reads as the same scenario.
  const ScenarioResult again = read_scenario_text(write_scenario_text(read), "again.toml");
  ASSERT_TRUE(again.ok()) << again.diagnostics.text();
  for (const Parameter& parameter : parameters("falling_net")) {
    EXPECT_EQ(parameter.get(again.scenario), parameter.get(read)) << parameter.key;
  }
}

TEST_F(SecondSystem, SaysWhatIsWrongInItsScenarios) {
  const auto problem = [](const std::string& text) {
    const ScenarioResult result = read_scenario_text(text, "n.toml");
    return result.ok() ? check_scenario(result.scenario).text() : result.diagnostics.text();
  };
  EXPECT_EQ(
      problem("system = \"faling_net\"\n"),
      "n.toml:1: system: expects one of \"pocket\", \"thrown_net\", \"falling_net\", not the text \"faling_net\"; did "
      "you mean \"falling_net\"?");
  EXPECT_EQ(problem("system = \"falling_net\"\n[closing]\nduration = 5\n"),
            "n.toml:2: closing: is not a table of a scenario of the system 'falling_net'; scenarios/REFERENCE.md lists "
            "them all");
  EXPECT_EQ(problem("system = \"falling_net\"\n[falling_net]\nsped = 5\n"),
            "n.toml:3: falling_net.sped: is not a parameter of the system 'falling_net'; did you mean "
            "'falling_net.speed'?");
  EXPECT_EQ(problem("system = \"falling_net\"\n[falling_net]\nheight = 0.5\n"),
            "falling_net.height: must be more than 4.504 m, or the net starts in the target");
}

// The net falls freely until it meets the sphere, then wraps round it.
TEST_F(SecondSystem, FallsOnTheSphere) {
  Simulation simulation(scenario());
  EXPECT_EQ(simulation.advance(0.2).reason, RunReason::finished);
  const Snapshot before = simulation.snapshot();
  const auto value = [](const Snapshot& snapshot, const char* name) {
    return snapshot.channels[snapshot.channel_list->find(name).value()];
  };
  EXPECT_NEAR(value(before, "corner_height"), 1.4 - 3 * 0.2, 1e-6);
  EXPECT_NEAR(value(before, "spread"), 4 * std::sqrt(2), 1e-6);
  EXPECT_EQ(before.channel(Channel::contact_count), 0);
  EXPECT_TRUE(std::isnan(before.channel(Channel::closing_length)));
  EXPECT_EQ(simulation.advance(1.2).reason, RunReason::finished);
  const Snapshot after = simulation.snapshot();
  EXPECT_GT(after.channel(Channel::contact_count), 0);
  EXPECT_LT(value(after, "corner_height"), 0);
  EXPECT_LT(value(after, "spread"), 4);
  // Momentum: what the net loses, the target gains.
  EXPECT_LT(after.channel(Channel::target_vy), -0.05);
  EXPECT_LT(std::abs(after.channel(Channel::energy_error)), 0.01 * after.channel(Channel::energy_kinetic));
}

// Its elements have no strain partners and fold. With the step bound of paired ones this run gained 20 kJ.
TEST_F(SecondSystem, KeepsItsEnergyAsItWraps) {
  Scenario fine = scenario();
  find_parameter("falling_net.cells", "falling_net")->set(fine, std::int64_t{10});
  Simulation simulation(fine);
  EXPECT_EQ(simulation.advance(1.6).reason, RunReason::finished);
  const Snapshot end = simulation.snapshot();
  EXPECT_LT(std::abs(end.channel(Channel::energy_error)), 0.01);  // J, of 16 J
  EXPECT_GT(end.channel(Channel::energy_kinetic), 5);
}

// The sampled controller: theta'' = -c/I theta' with steps of 0.02 s gives (1 - c T/I)^n of the spin after n samples.
TEST_F(SecondSystem, SampledControllerHoldsItsTorque) {
  Scenario damped = scenario("\n");
  find_parameter("falling_net.spin_damping", "falling_net")->set(damped, 20.0);
  Simulation simulation(damped);
  EXPECT_EQ(simulation.advance(0.2).reason, RunReason::finished);  // before any contact
  EXPECT_NEAR(simulation.snapshot().bodies[0].angular_velocity.y(), 0.3 * std::pow(1 - 20 * 0.02 / 8, 10), 1e-4);
  // Saved and restored between two samples, it continues to the last bit.
  EXPECT_EQ(simulation.advance(0.23).reason, RunReason::finished);
  Simulation restored(damped);
  restored.restore(simulation.checkpoint());
  for (Simulation* one : {&simulation, &restored}) EXPECT_EQ(one->advance(0.4).reason, RunReason::finished);
  EXPECT_EQ(simulation.checkpoint().size(), restored.checkpoint().size());
  EXPECT_EQ(simulation.snapshot().positions, restored.snapshot().positions);
  EXPECT_EQ(simulation.snapshot().bodies[0].angular_velocity, restored.snapshot().bodies[0].angular_velocity);
}

TEST_F(SecondSystem, ChangesItsStrategyInMidRun) {
  Simulation simulation(scenario());
  EXPECT_EQ(simulation.advance(0.1).reason, RunReason::finished);
  Scenario wanted = scenario();
  find_parameter("falling_net.spin_damping", "falling_net")->set(wanted, 50.0);
  find_parameter("falling_net.side", "falling_net")->set(wanted, 5.0);
  EXPECT_EQ(simulation.change_strategy(wanted), std::vector<std::string>{"falling_net.side"});
  EXPECT_EQ(simulation.advance(0.2).reason, RunReason::finished);
  EXPECT_LT(simulation.snapshot().bodies[0].angular_velocity.y(), 0.3);
}

TEST_F(SecondSystem, GoesThroughTheCommands) {
  const std::string recording = recorded();
  EXPECT_TRUE(contains(run({"check", folder_.file("net.toml")}).out, "net 60"));
  const auto info = nlohmann::json::parse(run({"info", recording, "--json"}).out);
  EXPECT_EQ(info["reason"], "finished");
  EXPECT_TRUE(contains(run({"info", recording}).out, "captured"));
  run({"plot", recording, "-o", folder_.file("figures")});
  EXPECT_TRUE(std::filesystem::exists(folder_.file("figures/own_channels.png")));
  EXPECT_TRUE(std::filesystem::exists(folder_.file("figures/energy.png")));
  EXPECT_FALSE(std::filesystem::exists(folder_.file("figures/figure03_closing.png")));
  EXPECT_FALSE(std::filesystem::exists(folder_.file("figures/tension.png")));
  run({"render", recording, "--sheet", folder_.file("sheet.png"), "--times", "0,0.4,0.8,1.2"});
  run({"export", recording, "--csv", folder_.file("net.csv")});
  run({"export", recording, "--vtp", folder_.file("vtp")});
  run({"report", recording, "-o", folder_.file("report.html")});
  EXPECT_TRUE(contains(run({"findings", recording}).out, "F1"));
}

// Faults of a kind are said before anything is stepped.
TEST_F(SecondSystem, FaultsOfAKindAreSaid) {
  static const SystemParameters kBroken = {.name = "broken", .title = "", .help = "", .shared_groups = {}};
  register_capture_system(
      {&kBroken,
       [](const Scenario& s) {
         CaptureSystem system;
         if (s.output.end_time > 1) {
           system.structure.channels = std::make_shared<const ChannelList>(std::vector<ChannelInfo>{{"time", "s", ""}});
         } else {
           system.model.ropes.push_back({});
         }
         return system;
       },
       [](const Scenario&) { return std::vector<Phase>(); }});
  const auto fault = [](double end) -> std::string {
    Scenario scenario;
    scenario.system = "broken";
    scenario.output.end_time = end;
    try {
      Simulation simulation(scenario);
    } catch (const SystemFault& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(fault(0.5), "the capture system broken builds a model with a fault: rope 0 has no elements");
  EXPECT_EQ(fault(2), "the capture system broken has no channel penetration_max");
  EXPECT_THROW(register_falling_net(), std::invalid_argument);
}

TEST_F(SecondSystem, RecordsItsOwnChannelsAndPhases) {
  const Recording recording(recorded());
  EXPECT_EQ(recording.channel(recording.channels()->find("spread").value()).size(), recording.frame_count());
  ASSERT_EQ(recording.origin().phases.size(), 2u);
  EXPECT_EQ(recording.origin().phases[1].name, "wrap");
}

TEST_F(SecondSystem, Resumes) {
  const std::string whole = recorded({"--until", "1.6"});
  const std::string part = folder_.file("part.h5");
  run({"run", folder_.file("net.toml"), "-o", part, "--quiet", "--until", "1.1"});
  run({"run", "--resume", part, "--until", "1.6", "--quiet"});
  const Recording a(whole), b(part);
  ASSERT_EQ(a.frame_count(), b.frame_count());
  EXPECT_EQ(a.frame(a.frame_count() - 1).positions, b.frame(b.frame_count() - 1).positions);
}

}  // namespace
}  // namespace netpocket
