// Controllers, sensors, actuators and winches in scenarios: read, written, set and checked.

#include <gtest/gtest.h>

#include "engine/scenario/check_scenario.h"
#include "engine/scenario/parameter_text.h"
#include "engine/scenario/parameters.h"
#include "engine/scenario/read_scenario.h"
#include "engine/scenario/strategy.h"
#include "engine/scenario/write_scenario.h"

namespace netpocket {
namespace {

constexpr const char* kControlled = R"([actuators]
kind = "thrusters"
impulse_bit = 0.01

[[actuators.thruster]]
position = [0, 1, 0]
direction = [1, 0, 0]

[[actuators.thruster]]
position = [0, -1, 0]
direction = [-1, 0, 0]
thrust = 5

[[actuators.wheel]]
axis = [0, 0, 1]

[[controller]]
kind = "attitude_sliding_mode"
rate = 50
slope = 0.25

[[controller]]
kind = "position_pd"
axes = "lateral"

[[sensor]]
kind = "angular_velocity"
noise = 1e-4
bias = [1e-5, 0, -1e-5]
delay = 0.05

[winch]
drive = "length"
jammed = [[3, 4.5]]

[[disturbance]]
body = "target"
torque = [0, 5, 0]
start = 2
duration = 0.5
)";

ScenarioResult read(const std::string& text) { return read_scenario_text(text, "own.toml"); }

// The problems of a scenario, with lines.
std::string problems_of(const std::string& text) {
  const ScenarioResult result = read(text);
  if (!result.ok()) return result.diagnostics.text();
  return result.with_lines(check_scenario(result.scenario), "own.toml").text();
}

TEST(ControlTables, AreRead) {
  const ScenarioResult result = read(kControlled);
  ASSERT_TRUE(result.ok()) << result.diagnostics.text();
  const Scenario& s = result.scenario;
  ASSERT_EQ(s.controllers.size(), 2u);
  EXPECT_EQ(s.controllers[0].kind, ControllerKind::attitude_sliding_mode);
  EXPECT_EQ(s.controllers[0].slope, 0.25);
  EXPECT_EQ(s.controllers[0].reaching, ControllerParameters().reaching);
  EXPECT_EQ(s.controllers[1].axes, ControlledAxes::lateral);
  ASSERT_EQ(s.thrusters.size(), 2u);
  EXPECT_EQ(s.thrusters[1].thrust, 5);
  EXPECT_EQ(s.wheels.size(), 1u);
  ASSERT_EQ(s.sensors.size(), 1u);
  EXPECT_EQ(s.sensors[0].bias, Eigen::Vector3d(1e-5, 0, -1e-5));
  EXPECT_EQ(s.winch.jammed, (std::vector<Eigen::Vector2d>{{3, 4.5}}));
  EXPECT_EQ(check_scenario(s).text(), "");
}

TEST(ControlTables, AreWrittenAndReadBackTheSame) {
  const Scenario written = read(kControlled).scenario;
  const std::string text = write_scenario_text(written);
  const ScenarioResult result = read(text);
  ASSERT_TRUE(result.ok()) << result.diagnostics.text();
  EXPECT_EQ(result.scenario.controllers, written.controllers);
  EXPECT_EQ(result.scenario.sensors, written.sensors);
  EXPECT_EQ(result.scenario.thrusters, written.thrusters);
  EXPECT_EQ(result.scenario.wheels, written.wheels);
  EXPECT_EQ(result.scenario.winch, written.winch);
  ASSERT_EQ(written.disturbances.size(), 1u);
  EXPECT_EQ(written.disturbances[0].body, DisturbedBody::target);
  EXPECT_EQ(result.scenario.disturbances, written.disturbances);
  EXPECT_EQ(result.scenario.actuators, written.actuators);
  EXPECT_EQ(write_scenario_text(result.scenario), text);
}

// A row that leads to the member of another row, or to another item, would go unseen when all are read.
TEST(ControlTables, EveryRowChangesItsOwnMemberOnly) {
  Scenario defaults;
  for (const ParameterList& list : parameter_lists()) list.resize(defaults, 2);
  for (const ParameterList& list : parameter_lists()) {
    for (const Parameter& p : parameters_of(list, 1)) {
      SCOPED_TRACE(p.key);
      EXPECT_FALSE(p.help.empty());
      EXPECT_FALSE(p.source.empty());
      EXPECT_EQ(limit_problem(p, p.get(defaults)), std::nullopt);
      Scenario changed = defaults;
      ParameterValue value = p.get(defaults);
      if (auto* number = std::get_if<double>(&value)) {
        *number = *number == 0.75 ? 0.5 : 0.75;
      } else if (auto* whole = std::get_if<std::int64_t>(&value)) {
        ++*whole;
      } else if (auto* flag = std::get_if<bool>(&value)) {
        *flag = !*flag;
      } else if (auto* choice = std::get_if<Choice>(&value)) {
        choice->index = 1 - choice->index;
      } else {
        std::get<Eigen::Vector3d>(value) += Eigen::Vector3d(0.25, 0, 0.5);
      }
      p.set(changed, value);
      for (const Parameter* other : parameters_of(defaults)) {
        EXPECT_EQ(other->get(changed) != other->get(defaults), other == &p) << other->key;
      }
    }
  }
}

TEST(ControlTables, SettingsReachItems) {
  Scenario s = read(kControlled).scenario;
  EXPECT_TRUE(apply_setting(s, "controller.0.slope=0.5").ok());
  EXPECT_EQ(s.controllers[0].slope, 0.5);
  EXPECT_TRUE(apply_setting(s, "actuators.thruster.1.thrust = 7").ok());
  EXPECT_EQ(s.thrusters[1].thrust, 7);
  EXPECT_EQ(apply_setting(s, "controller.2.slope=0.5").text(),
            "\"controller.2.slope\" belongs to a table that the scenario does not have; numbers begin with 0");
  EXPECT_NE(apply_setting(s, "controller.0.slop=0.5").text().find("did you mean 'controller.0.slope'"),
            std::string::npos);
}

TEST(ControlTables, GainsActAtOnceAndKindsDoNot) {
  EXPECT_TRUE(acts_at_once("controller.3.slope"));
  EXPECT_TRUE(acts_at_once("winch.jammed"));
  EXPECT_TRUE(acts_at_once("target.thrust"));
  EXPECT_TRUE(acts_at_once("disturbance"));
  EXPECT_FALSE(acts_at_once("controller.3.kind"));
  EXPECT_FALSE(acts_at_once("controller.3.observer"));
  EXPECT_FALSE(acts_at_once("sensor.0.noise"));
  EXPECT_FALSE(acts_at_once("actuators.kind"));
}

struct BadInput {
  const char* text;
  const char* message;
};

TEST(ControlTables, BadInputGetsOneSentenceWithItsLine) {
  const std::vector<BadInput> cases = {
      {"[[controller]]\nkind = \"atitude_pd\"", "own.toml:2: controller.0.kind: expects one of \"attitude_pd\""},
      {"[[controller]]\nkind = \"atitude_pd\"", "did you mean \"attitude_pd\"?"},
      {"[[controller]]\nrate = 0", "own.toml:2: controller.0.rate: must be > 0"},
      {"[[controller]]\nslope = nan", "own.toml:2: controller.0.slope: must be finite"},
      {"[[controller]]\ngian = 1", "own.toml:2: controller.0.gian: is not a parameter"},
      {"[controller]\nkind = \"tow\"", "own.toml:1: controller: is a list of tables: write [[controller]]"},
      {"[[controler]]\nkind = \"tow\"",
       "own.toml:1: controler: is not a table of a scenario; did you mean 'controller'?"},
      {"[[sensor]]\nkind = \"attitude\"", "own.toml:2: sensor.0.kind: nothing reads a sensor of \"attitude\""},
      {"[[controller]]\n[[sensor]]\n[[sensor]]", "own.toml:3: sensor.1.kind: sensor.0 measures \"attitude\" already"},
      {"[actuators]\nkind = \"thrusters\"\n[[actuators.thruster]]\ndirection = [0, 0, 0]",
       "own.toml:4: actuators.thruster.0.direction: a thruster needs a direction"},
      {"[actuators]\nkind = \"thrusters\"", "own.toml:2: actuators.kind: there are no thrusters"},
      {"[[actuators.thruster]]", "own.toml:1: actuators.thruster: nothing fires the thrusters"},
      {"[[actuators.wheel]]\naxis = [0, 0, 0]", "own.toml:2: actuators.wheel.0.axis: a reaction wheel needs an axis"},
      {"[[controller]]\nphase = \"open\"", "own.toml:2: controller.0.phase: the phase \"open\" never comes"},
      {"[towing]\nmode = \"none\"\n[[controller]]\nphase = \"towing\"", "own.toml:4: controller.0.phase: the phase"},
      {"[towing]\nmode = \"controlled\"", "own.toml:2: towing.mode: \"controlled\" needs a [[controller]]"},
      {"[[controller]]\nkind = \"tow\"", "own.toml:2: controller.0.kind: \"tow\" needs towing.mode"},
      {"[spacecraft]\nstation_keeping = \"attitude\"\n[[controller]]", "own.toml:3: controller.0.kind: has no effect"},
      {"[winch]\njammed = [[3, 1]]", "own.toml:2: winch.jammed: needs a winch.drive other than"},
      {"[winch]\ndrive = \"length\"\njammed = [[9, 1]]", "own.toml:3: winch.jammed: row 1 names rope 9"},
      {"[[disturbance]]", "own.toml:1: disturbance.0.force: a disturbance needs a force or a torque"},
      {"[[disturbance]]\nduration = 0", "own.toml:2: disturbance.0.duration: must be > 0"},
      {"[target]\nthrust = [1, 0, 0]\nacts_until = 0", "own.toml:3: target.acts_until: must be later"},
      {"[target]\nthrust = [1, 0, 0]\nacts_from = 20",
       "own.toml:3: target.acts_from: thrust and torque never act: the "},
      {"[deflation]\nstarts_at = \"open\"", "own.toml:2: deflation.starts_at: expects one of \"never\", \"time\""},
      {"[deflation]\nstarts_at = \"closing\"",
       "deflation.pressure: must be below rods.pressure = 0 Pa, or there is nothing to let out"},
      {"[deflation]\nrate = 0", "own.toml:2: deflation.rate: must be > 0"},
      {"[rods]\npressure = 2e5\n[deflation]\nstarts_at = \"closed\"\nstart = 10",
       "own.toml:4: deflation.starts_at: the rods are never deflated: that starts at 20 s, but the run ends at 20 s"},
      {"[closing]\nstarts_at = \"contact\"", "own.toml:2: closing.starts_at: expects one of \"time\""},
      {"[closing]\nstarts_at = \"distance\"\nstart = 20",
       "own.toml:3: closing.start: the closing never starts: it waits for its event from 20 s on, but the run ends at "
       "20 s"},
      {"[towing]\nstarts_at = \"closed\"\n[closing]\nstarts_at = \"target_inside\"\nstart = 12",
       "own.toml:2: towing.starts_at: the towing never starts: the mouth is closed at 22 s at the earliest, but"},
      {"[towing]\nstarts_at = \"closed\"\n[output]\nend_time = 10",
       "own.toml:2: towing.starts_at: the towing never starts: the mouth is closed at 10 s, but the run ends at 10 s"},
      {"[towing]\nmode = \"none\"\nabort_force = 10", "own.toml:3: towing.abort_force: there is no towing"},
      {"[[controller]]\nphase = \"closing\"\n[closing]\nstart = 30",
       "own.toml:2: controller.0.phase: the phase never comes: it begins at 30 s, but the run ends at 20 s"},
      {"[[controller]]\nphase = \"towing\"\n[towing]\nstart = 25", "own.toml:2: controller.0.phase: the phase never"},
  };
  for (const BadInput& bad : cases) {
    const std::string text = problems_of(bad.text);
    EXPECT_NE(text.find(bad.message), std::string::npos) << bad.text << "\ngives\n" << text;
  }
}

// The end of a recorded run may move when it is resumed, and a run without closing is a run.
TEST(ControlTables, WhatComesInTimeIsNotRefused) {
  EXPECT_EQ(problems_of("[closing]\nstarts_at = \"distance\"\nstart = 19.9\n[towing]\nmode = \"none\""), "");
  EXPECT_EQ(problems_of("[closing]\nstart = 30"), "");
  EXPECT_EQ(problems_of("[towing]\nstarts_at = \"closed\"\n[output]\nend_time = 10.1"), "");
  Scenario waiting = read("[closing]\nstarts_at = \"distance\"").scenario;
  waiting.closing.start = waiting.output.end_time;
  EXPECT_FALSE(check_scenario(waiting).ok());
  EXPECT_TRUE(check_scenario(waiting, RunEnd::open).ok());
}

TEST(ControlTables, MoreItemsThanAllowedAreRefused) {
  std::string text;
  for (std::size_t i = 0; i <= kMostItems; ++i) text += "[[controller]]\n";
  EXPECT_NE(problems_of(text).find("own.toml:1: controller: has 33 tables; 32 are allowed"), std::string::npos)
      << problems_of(text);
}

}  // namespace
}  // namespace netpocket
