#include "gui/workbench/editor/toml_edit.h"

#include <gtest/gtest.h>

#include "engine/scenario/read_scenario.h"
#include "engine/scenario/write_scenario.h"
#include "gui/workbench/editor/presets.h"
#include "temporary_document.h"

namespace netpocket {
namespace {

TEST(TomlEdit, KeepsCommentsAndTheirColumns) {
  const std::string text = "# mine\n[target]\nradius = 4.5   # m\nmass = 200\n";
  EXPECT_EQ(with_value(text, parameter("target.radius"), 4.25), "# mine\n[target]\nradius = 4.25  # m\nmass = 200\n");
  EXPECT_EQ(with_value(text, parameter("target.radius"), 123.4567),
            "# mine\n[target]\nradius = 123.4567 # m\nmass = 200\n");
  EXPECT_EQ(with_value(text, parameter("target.mass"), 5.0), "# mine\n[target]\nradius = 4.5   # m\nmass = 5\n");
}

TEST(TomlEdit, AddsAMissingKeyToItsTable) {
  const std::string text = "[target]\nradius = 4.5\n\n[closing]\nduration = 5\n";
  EXPECT_EQ(with_value(text, parameter("target.mass"), 150.0),
            "[target]\nradius = 4.5\nmass = 150\n\n[closing]\nduration = 5\n");
}

TEST(TomlEdit, AddsAMissingTableAtTheEnd) {
  EXPECT_EQ(with_value("[target]\nradius = 4.5", parameter("contact.friction"), 0.2),
            "[target]\nradius = 4.5\n\n[contact]\nfriction = 0.2\n");
  EXPECT_EQ(with_value("", parameter("contact.friction"), 0.2), "[contact]\nfriction = 0.2\n");
}

TEST(TomlEdit, AddsATopLevelKeyBeforeTheTables) {
  const auto text = with_value("[target]\nradius = 4.5\n", parameter("name"), std::string("new"));
  ASSERT_TRUE(text);
  EXPECT_EQ(read_scenario_text(*text, "t").scenario.name, "new");
}

TEST(TomlEdit, CountsCharactersNotBytes) {
  const std::string text = "name = \"täöü 网\" # ü\n[target]\nmass = 1 # µ\n";
  const auto changed = with_value(text, parameter("name"), std::string("x"));
  ASSERT_TRUE(changed);
  EXPECT_EQ(*changed, "name = \"x\"      # ü\n[target]\nmass = 1 # µ\n");
}

TEST(TomlEdit, ReplacesValuesOverSeveralLines) {
  const std::string text = "[rods]\nprofile = [\n  [0.6, 0], # root\n  [4.8, 5.3],\n  [7.56, 12]\n]\ndensity = 164\n";
  const std::vector<Eigen::Vector2d> profile = {{0.5, 0}, {5, 5}, {7, 11}};
  const auto changed = with_value(text, parameter("rods.profile"), profile);
  ASSERT_TRUE(changed);
  const ScenarioResult result = read_scenario_text(*changed, "t");
  ASSERT_TRUE(result.ok()) << result.diagnostics.text();
  EXPECT_EQ(result.scenario.rods.profile, profile);
  EXPECT_EQ(result.scenario.rods.density, 164);
}

TEST(TomlEdit, KeepsKeysOfATableOutOfTheListsInIt) {
  const Parameter& box = parameter("actuators.most_force");
  const Eigen::Vector3d force(1, 2, 3);
  EXPECT_EQ(
      with_value("[actuators]\nkind = \"thrusters\"\n\n[[actuators.thruster]]\nposition = [0, 1, 0]\n", box, force),
      "[actuators]\nkind = \"thrusters\"\nmost_force = [1, 2, 3]\n\n[[actuators.thruster]]\nposition = [0, 1, 0]\n");
  EXPECT_EQ(with_value("[[actuators.wheel]]\naxis = [1, 0, 0]\n", box, force),
            "[[actuators.wheel]]\naxis = [1, 0, 0]\n\n[actuators]\nmost_force = [1, 2, 3]\n");
}

// Items of lists are edited in their own table.
TEST(TomlEdit, EditsItemsOfLists) {
  const std::string text =
      "[[controller]]\nkind = \"tow\"\n\n# the second\n[[controller]]\nslope = 1 # 1/s\n\n[net]\ndiameter = 0.004\n";
  const ParameterList& list = *find_parameter_list("controller");
  const auto item = [&](std::size_t index, std::string_view name) -> const Parameter& {
    return *std::ranges::find(parameters_of(list, index), name, &Parameter::name);
  };
  EXPECT_TRUE(states(text, item(1, "slope")));
  EXPECT_FALSE(states(text, item(0, "slope")));
  EXPECT_EQ(with_value(text, item(1, "slope"), 2.5),
            "[[controller]]\nkind = \"tow\"\n\n# the second\n[[controller]]\nslope = 2.5 # 1/s\n\n[net]\ndiameter = "
            "0.004\n");
  EXPECT_EQ(with_value(text, item(0, "wanted"), 0.5),
            "[[controller]]\nkind = \"tow\"\nwanted = 0.5\n\n# the second\n[[controller]]\nslope = 1 # "
            "1/s\n\n[net]\ndiameter = 0.004\n");
  EXPECT_FALSE(with_value(text, item(2, "slope"), 1.0)) << "there is no third";
  const Parameter& thruster = parameters_of(*find_parameter_list("actuators.thruster"), 0)[2];
  EXPECT_EQ(with_value("[[actuators.thruster]]\nthrust = 1\n", thruster, 3.0), "[[actuators.thruster]]\nthrust = 3\n");
}

TEST(TomlEdit, LeavesInlineTablesAlone) {
  EXPECT_FALSE(with_value("target = { radius = 4 }\n", parameter("target.mass"), 1.0));
}

TEST(TomlEdit, RefusesBrokenText) { EXPECT_FALSE(with_value("[target\n", parameter("target.mass"), 1.0)); }

// Every parameter of every scenario that comes with the program, edited in place, reads back and leaves the rest alone.
TEST(TomlEdit, EveryParameterOfEveryPreset) {
  ASSERT_GE(presets().size(), 5u);
  for (const Preset& preset : presets()) {
    const std::string text = preset.text.toStdString();
    const std::string system = read_scenario_text(text, "t").scenario.system;
    for (const Parameter& p : parameters(system)) {
      Scenario target = read_scenario_text(text, "t").scenario;
      const Scenario other = [&] {
        Scenario s = target;
        s.net.diameter *= 1.5;
        s.target.position.x() += 0.125;
        s.pocket.rod_count += 1;
        s.description += " \"quoted\"";
        s.closing.law = ClosingLaw::linear;
        s.closing.table = {{0, 5.5}, {3, 2}};
        return s;
      }();
      p.set(target, p.get(other));
      const auto changed = with_value(text, p, p.get(other));
      ASSERT_TRUE(changed) << p.key;
      const ScenarioResult result = read_scenario_text(*changed, "t");
      ASSERT_TRUE(result.ok()) << result.diagnostics.text();
      for (const Parameter& q : parameters(system)) {
        EXPECT_TRUE(q.get(result.scenario) == q.get(target))
            << preset.name.toStdString() << ": " << p.key << ", " << q.key;
      }
    }
  }
}

}  // namespace
}  // namespace netpocket
