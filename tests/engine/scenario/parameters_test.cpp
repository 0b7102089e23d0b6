// The parameter table: complete, consistent, and what it declares survives a round trip through text.

#include "engine/scenario/parameters.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "engine/scenario/parameter_text.h"
#include "engine/scenario/read_scenario.h"
#include "engine/scenario/write_scenario.h"

namespace netpocket {
namespace {

// A value within the limits, different from draw to draw, with all digits a double has.
class RandomValues {
 public:
  ParameterValue draw(const Parameter& p) {
    switch (p.type) {
      case ParameterType::number:
        return number(p);
      case ParameterType::integer:
        return static_cast<std::int64_t>(number(p));
      case ParameterType::boolean:
        return random_() % 2 == 0;
      case ParameterType::text:
        return "\"quoted\" \\ \t\n\x7f # = [x] \xc3\xa4 " + std::to_string(random_());
      case ParameterType::choice:
        return Choice{static_cast<int>(random_() % p.choices.size())};
      case ParameterType::vector:
        return Eigen::Vector3d(number(p), number(p), number(p));
      case ParameterType::pairs:
        return std::vector<Eigen::Vector2d>{{number(p), number(p)}, {number(p), number(p)}};
    }
    return {};
  }

 private:
  double number(const Parameter& p) {
    // Either uniform or, to reach every order of magnitude, close to the lower limit.
    const double part = std::uniform_real_distribution(0.0, 1.0)(random_);
    const double scale = random_() % 2 ? 1.0 : 1e-12;
    return p.limits.minimum + part * scale * (p.limits.maximum - p.limits.minimum);
  }

  std::mt19937_64 random_{20231016};
};

bool equal(const Scenario& a, const Scenario& b) {
  for (const Parameter& p : parameters()) {
    if (p.get(a) != p.get(b)) {
      ADD_FAILURE() << p.key << ": " << toml_text(p, p.get(a)) << " is not " << toml_text(p, p.get(b));
      return false;
    }
  }
  return true;
}

TEST(ParameterTable, DeclaresEveryMember) {
  // Does not compile when a member is added; then declare it in the table and count it here.
  const Scenario s;
  [[maybe_unused]] const auto& [n, d, system, pocket, net, rope, rods, spacecraft, target, contact, closing, towing,
                                winch, deflation, actuators, orbit, solver, output, controllers, sensors, thrusters,
                                wheels, disturbances, own, files] = s;
  const auto count = [](std::string_view group) { return parameters_of(*find_parameter_group(group)).size(); };
  EXPECT_EQ(count(""), 3u);
  {
    [[maybe_unused]] const auto& [a, b, c, e, f] = pocket;
    EXPECT_EQ(count("pocket"), 5u);
  }
  {
    [[maybe_unused]] const auto& [a, b, c, e, f, g, h] = net;
    EXPECT_EQ(count("net"), 7u);
    EXPECT_EQ(count("rope"), 7u);
  }
  {
    [[maybe_unused]] const auto& [a, b, c, e, f, g, h, i, j, k, l, m, o, p] = rods;
    EXPECT_EQ(count("rods"), 14u);
  }
  {
    [[maybe_unused]] const auto& [a, b, c, e, f] = spacecraft;
    EXPECT_EQ(count("spacecraft"), 5u);
  }
  {
    [[maybe_unused]] const auto& [a, b, c, e, f, g, h, i, j, k, l, m, o, p, q, r, t, u, v, w, x, y] = target;
    EXPECT_EQ(count("target"), 22u);
  }
  {
    [[maybe_unused]] const auto& [a, b, c, e, f, g, h] = contact;
    EXPECT_EQ(count("contact"), 7u);
  }
  {
    [[maybe_unused]] const auto& [a, b, c, e, f, g, h, i] = closing;
    EXPECT_EQ(count("closing"), 8u);
  }
  {
    [[maybe_unused]] const auto& [a, b, c, e, f, g, h, i] = towing;
    EXPECT_EQ(count("towing"), 8u);
  }
  {
    [[maybe_unused]] const auto& [a, b, c, e, f, g, h, i, j, k, l, m, o, p, q, r, t] = winch;
    EXPECT_EQ(count("winch"), 17u);
  }
  {
    [[maybe_unused]] const auto& [a, b, c, e] = deflation;
    EXPECT_EQ(count("deflation"), 4u);
  }
  {
    [[maybe_unused]] const auto& [a, b, c, e, f, g] = actuators;
    EXPECT_EQ(count("actuators"), 6u);
  }
  {
    [[maybe_unused]] const auto& [a, b, c, e, f, g, h, i, j] = orbit;
    EXPECT_EQ(count("orbit"), 9u);
  }
  {
    [[maybe_unused]] const auto& [a, b, c, e, f, g, h, i, j, k] = solver;
    EXPECT_EQ(count("solver"), 10u);
  }
  {
    [[maybe_unused]] const auto& [a, b] = output;
    EXPECT_EQ(count("output"), 2u);
  }
}

TEST(ParameterTable, IsConsistent) {
  const Scenario defaults;
  std::set<std::string_view> keys;
  std::size_t grouped = 0;
  for (const ParameterGroup& group : parameter_groups()) grouped += parameters_of(group).size();
  EXPECT_EQ(grouped, parameters().size()) << "a parameter belongs to no group, or its group is not in one piece";
  for (const Parameter& p : parameters()) {
    SCOPED_TRACE(p.key);
    EXPECT_TRUE(keys.insert(p.key).second) << "declared twice";
    EXPECT_EQ(find_parameter(p.key), &p);
    EXPECT_FALSE(p.help.empty());
    EXPECT_FALSE(p.source.empty());
    EXPECT_EQ(static_cast<std::size_t>(p.type), p.get(defaults).index());
    EXPECT_EQ(limit_problem(p, p.get(defaults)), std::nullopt);
    EXPECT_EQ(p.type == ParameterType::choice, !p.choices.empty());
    for (const std::string_view text : {p.help, p.source, p.unit}) EXPECT_EQ(text.find_first_of("|\n"), text.npos);
  }
}

// Two rows that lead to the same member would pass a round trip of all parameters at once.
TEST(ParameterTable, EveryRowChangesItsOwnMemberOnly) {
  RandomValues values;
  const Scenario defaults;
  for (const Parameter& p : parameters()) {
    SCOPED_TRACE(p.key);
    if (p.type == ParameterType::choice && p.choices.size() == 1) continue;  // the kind of system: one is registered
    Scenario changed;
    ParameterValue value = values.draw(p);
    while (value == p.get(defaults)) value = values.draw(p);
    p.set(changed, value);
    for (const Parameter& other : parameters()) {
      EXPECT_EQ(other.get(changed) != other.get(defaults), &other == &p) << other.key;
    }
  }
}

TEST(ParameterTable, RoundTripsThroughTextToTheLastBit) {
  RandomValues values;
  for (int i = 0; i < 200; ++i) {
    Scenario written;
    for (const Parameter& p : parameters()) {
      if (p.key != "system") p.set(written, values.draw(p));  // another system has other parameters
    }
    const std::string text = write_scenario_text(written);
    const ScenarioResult read = read_scenario_text(text, "round trip");
    ASSERT_TRUE(read.ok()) << read.diagnostics.text() << "\n" << text;
    ASSERT_TRUE(equal(read.scenario, written));
    ASSERT_EQ(write_scenario_text(read.scenario), text);
  }
}

TEST(ParameterTable, EveryChoiceIsReadByItsName) {
  for (const Parameter& p : parameters()) {
    for (const std::string_view name : p.choices) {
      Scenario scenario;
      EXPECT_TRUE(set_parameter(scenario, p, name).ok());
      EXPECT_EQ(p.choices[std::get<Choice>(p.get(scenario)).index], name);
    }
  }
}

// The value's TOML text with its last number replaced.
std::string text_with(const Parameter& p, double number) {
  const std::string n = fmt::format("{}", number);
  switch (p.type) {
    case ParameterType::vector:
      return fmt::format("[{0}, {0}, {1}]", p.limits.maximum, n);
    case ParameterType::pairs:
      return fmt::format("[[{0}, {0}], [{0}, {1}]]", p.limits.maximum, n);
    default:
      return n;
  }
}

TEST(ParameterTable, LimitsAreRefusedOnBothSides) {
  int tested = 0;
  for (const Parameter& p : parameters()) {
    const bool integer = p.type == ParameterType::integer;
    if (!integer && p.type != ParameterType::number && p.type != ParameterType::vector &&
        p.type != ParameterType::pairs) {
      continue;
    }
    SCOPED_TRACE(p.key);
    ++tested;
    const auto [low, high, excluded] = p.limits;
    const double below = integer ? low - 1 : std::nextafter(low, -HUGE_VAL);
    const double beyond = integer ? high + 1 : std::nextafter(high, HUGE_VAL);
    Scenario s;
    EXPECT_TRUE(set_parameter(s, p, text_with(p, high)).ok());
    EXPECT_EQ(set_parameter(s, p, text_with(p, low)).ok(), !excluded);
    const Scenario before = s;
    for (const double wrong : {below, beyond}) {
      const Diagnostics refused = set_parameter(s, p, text_with(p, wrong));
      ASSERT_FALSE(refused.ok()) << wrong;
      EXPECT_NE(refused.text().find(allowed_text(p)), std::string::npos) << refused.text();
    }
    for (const char* wrong : {"nan", "inf", "-inf"}) {
      const std::string text = p.type == ParameterType::vector  ? fmt::format("[{0}, {0}, {0}]", wrong)
                               : p.type == ParameterType::pairs ? fmt::format("[[{0}, {0}]]", wrong)
                                                                : wrong;
      EXPECT_FALSE(set_parameter(s, p, text).ok()) << wrong;
    }
    EXPECT_TRUE(equal(s, before)) << "a refused value changed the scenario";
  }
  EXPECT_GT(tested, 60);
}

TEST(ParameterTable, WrongTypesAreRefusedForEveryParameter) {
  const std::vector<std::string> values = {"\"text\"", "1.5",         "true",       "[1, 2]", "[1, 2, \"x\"]",
                                           "{a = 1}",  "[[1, 2, 3]]", "1979-05-27", "[[1]]",  "[true, true, true]"};
  for (const Parameter& p : parameters()) {
    int refused = 0;
    for (const std::string& value : values) {
      Scenario s;
      const Diagnostics diagnostics = set_parameter(s, p, value);
      if (diagnostics.ok()) continue;
      ++refused;
      EXPECT_NE(diagnostics.text().find(std::string(p.key)), std::string::npos);
    }
    // Texts take all but what is a quoted text of another kind: set_parameter quotes what has no quotes.
    EXPECT_GE(refused, p.type == ParameterType::text ? 0 : 8) << p.key;
  }
}

}  // namespace
}  // namespace netpocket
