#include "engine/scenario/scenario_json.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/scenario/parameters.h"
#include "engine/scenario/read_scenario.h"
#include "engine/scenario/write_scenario.h"

namespace netpocket {
namespace {

using Json = nlohmann::ordered_json;

bool is_table(const Json& value) { return value.is_object(); }
bool is_list_of_tables(const Json& value) { return value.is_array() && !value.empty() && value[0].is_object(); }

// As TOML: plain values first, then tables. JSON's values are TOML's.
std::string toml_of(const Json& table, const std::string& prefix) {
  std::string text, below;
  for (const auto& [key, value] : table.items()) {
    const std::string path = prefix.empty() ? key : prefix + "." + key;
    if (is_table(value)) {
      below += "\n[" + path + "]\n" + toml_of(value, path);
    } else if (is_list_of_tables(value)) {
      for (const Json& item : value) below += "\n[[" + path + "]]\n" + toml_of(item, path);
    } else if (find_parameter(path) || !value.is_array() || !value.empty()) {
      text += key + " = " + value.dump() + "\n";
    }
  }
  return text + below;
}

// What went through JSON is the same scenario to the last bit.
TEST(ScenarioJson, IsTheWholeScenario) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(NETPOCKET_SOURCE_DIR "/scenarios")) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path());
    const ScenarioResult original = read_scenario_file(entry.path().string());
    ASSERT_TRUE(original.ok());
    const Json json = Json::parse(scenario_json(original.scenario).dump());
    const ScenarioResult again = read_scenario_text(toml_of(json, ""), "again.toml");
    ASSERT_TRUE(again.ok()) << again.diagnostics.text();
    EXPECT_EQ(write_scenario_text(again.scenario), write_scenario_text(original.scenario));
    ++files;
  }
  EXPECT_GE(files, 10);
}

TEST(ScenarioJson, HasTheNamesOfTheFile) {
  const ScenarioResult result = read_scenario_text(R"(name = 'a "b"'
[closing]
duration = 8
[[controller]]
kind = "attitude_double_loop"
)",
                                                   "test.toml");
  ASSERT_TRUE(result.ok()) << result.diagnostics.text();
  const Json json = scenario_json(result.scenario);
  EXPECT_EQ(json.at("name"), "a \"b\"");
  EXPECT_EQ(json.at("closing").at("duration"), 8.0);
  ASSERT_EQ(json.at("controller").size(), 1u);
  EXPECT_EQ(json.at("controller")[0].at("kind"), "attitude_double_loop");
  EXPECT_TRUE(json.at("sensor").empty());
}

}  // namespace
}  // namespace netpocket
