#include "gui/workbench/editor/parameter_words.h"

#include <gtest/gtest.h>

#include "temporary_document.h"

namespace netpocket {
namespace {

TEST(ParameterWords, Labels) {
  EXPECT_EQ(label(parameter("net.youngs_modulus")), "Young's modulus");
  EXPECT_EQ(label(parameter("rods.poisson_ratio")), "Poisson's ratio");
  EXPECT_EQ(full_label(parameter("closing.closed_length")), "Closing: closed length");
}

TEST(ParameterWords, NumbersAreShortAndExact) {
  EXPECT_EQ(number_words(12e9), "12e9");
  EXPECT_EQ(number_words(1e-5), "1e-5");
  EXPECT_EQ(number_words(0.004), "0.004");
  EXPECT_EQ(number_words(14498), "14498");
  EXPECT_EQ(number_words(-0.5), "-0.5");
  for (const double value : {0.1, 1.0 / 3, 1e-300, 123456789.123}) EXPECT_EQ(number_words(value).toDouble(), value);
}

TEST(ParameterWords, Units) {
  const Scenario scenario;
  EXPECT_EQ(unit_of(parameter("net.density"), scenario), "kg/m³");
  EXPECT_EQ(unit_of(parameter("towing.size"), scenario), "m/s²");
  EXPECT_EQ(unit_of(parameter("rods.profile"), scenario), "");
}

TEST(ParameterWords, OnlyWhatIsUsed) {
  Scenario scenario;
  EXPECT_FALSE(why_unused(parameter("target.radius"), scenario));
  EXPECT_TRUE(why_unused(parameter("target.size"), scenario));
  EXPECT_TRUE(why_unused(parameter("target.length"), scenario));
  EXPECT_TRUE(why_unused(parameter("closing.table"), scenario));
  scenario.target.shape = TargetShape::box;
  EXPECT_TRUE(why_unused(parameter("target.radius"), scenario));
  EXPECT_FALSE(why_unused(parameter("target.size"), scenario));
  scenario.target.shape = TargetShape::cylinder;
  EXPECT_FALSE(why_unused(parameter("target.radius"), scenario));
  EXPECT_TRUE(why_unused(parameter("target.span"), scenario));
  EXPECT_TRUE(why_unused(parameter("target.mesh_file"), scenario));
  scenario.target.shape = TargetShape::satellite;
  EXPECT_FALSE(why_unused(parameter("target.size"), scenario));
  EXPECT_FALSE(why_unused(parameter("target.span"), scenario));
  scenario.target.shape = TargetShape::mesh;
  EXPECT_TRUE(why_unused(parameter("target.size"), scenario));
  EXPECT_FALSE(why_unused(parameter("target.mesh_unit"), scenario));
  EXPECT_FALSE(why_unused(parameter("target.inertia"), scenario));
  scenario.target.inertia_from = InertiaSource::shape;
  EXPECT_TRUE(why_unused(parameter("target.inertia"), scenario));
  scenario.closing.law = ClosingLaw::table;
  EXPECT_TRUE(why_unused(parameter("closing.duration"), scenario));
  scenario.towing.mode = TowingMode::none;
  EXPECT_FALSE(why_unused(parameter("towing.mode"), scenario));
  EXPECT_TRUE(why_unused(parameter("towing.size"), scenario));
}

TEST(ParameterWords, TethersDrumsAndDrawstringsAreUsedWhereThereAreSuch) {
  Scenario scenario;
  const auto is_used = [&](const char* key) { return !why_unused(*find_parameter(key, scenario), scenario); };
  const auto set = [&](const char* key, const ParameterValue& value) {
    find_parameter(key, scenario)->set(scenario, value);
  };
  EXPECT_TRUE(is_used("tether.attached"));
  EXPECT_FALSE(is_used("tether.length")) << "a pocket has no tether by default";
  EXPECT_FALSE(is_used("tether.hub_mass"));
  scenario.system = "thrown_net";
  EXPECT_TRUE(is_used("tether.length"));
  EXPECT_TRUE(is_used("tether.winch"));
  EXPECT_TRUE(is_used("tether.elements"));
  EXPECT_FALSE(is_used("tether.slip_tension")) << "no drum by default";
  set("tether.winch", true);
  EXPECT_FALSE(is_used("tether.elements"));
  EXPECT_TRUE(is_used("tether.slip_tension"));
  EXPECT_TRUE(is_used("tether.brake_at"));
  EXPECT_FALSE(is_used("tether.brake_delay"));
  EXPECT_FALSE(is_used("tether.tension")) << "the drum is braked by default";
  set("tether.drive", Choice{3});
  EXPECT_TRUE(is_used("tether.tension"));
  EXPECT_FALSE(is_used("tether.motor_torque")) << "a light brake needs no motor";
  set("tether.brake_starts_at", Choice{1});
  EXPECT_FALSE(is_used("tether.brake_at"));
  EXPECT_TRUE(is_used("tether.brake_delay"));
  EXPECT_TRUE(is_used("drawstring.starts_at"));
  EXPECT_FALSE(is_used("drawstring.closed_length"));
  set("drawstring.starts_at", Choice{2});
  EXPECT_TRUE(is_used("drawstring.delay"));
  EXPECT_FALSE(is_used("drawstring.start"));
  EXPECT_FALSE(is_used("drawstring.ring_friction"));
  set("drawstring.passage", Choice{1});
  EXPECT_TRUE(is_used("drawstring.ring_friction"));
}

TEST(ParameterWords, StrategyActsAtOnce) {
  EXPECT_EQ(edit_effect(parameter("closing.duration")), EditEffect::at_once);
  EXPECT_EQ(edit_effect(parameter("closing.elements")), EditEffect::restart);
  EXPECT_EQ(edit_effect(parameter("towing.mode")), EditEffect::at_once);
  EXPECT_EQ(edit_effect(parameter("contact.friction")), EditEffect::at_once);
  EXPECT_EQ(edit_effect(parameter("contact.restitution")), EditEffect::restart);
  EXPECT_EQ(edit_effect(parameter("net.diameter")), EditEffect::restart);
  EXPECT_EQ(edit_effect(parameter("name")), EditEffect::none);
}

TEST(ParameterWords, ToolTipsHaveHelpLimitsAndSource) {
  const QString tip = tool_tip(parameter("net.diameter"));
  EXPECT_TRUE(tip.contains("Diameter of a cord"));
  EXPECT_TRUE(tip.contains("&lt;= 0.1"));
  EXPECT_TRUE(tip.contains("paper, Table 2"));
  EXPECT_TRUE(tip.contains("net.diameter"));
}

}  // namespace
}  // namespace netpocket
