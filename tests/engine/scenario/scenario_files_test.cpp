// The scenarios that come with the program.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "engine/scenario/check_scenario.h"
#include "engine/scenario/parameters.h"
#include "engine/scenario/read_scenario.h"

namespace netpocket {
namespace {

const std::filesystem::path kFolder = NETPOCKET_SOURCE_DIR "/scenarios";

Scenario load(const std::string& name) {
  const ScenarioResult result = read_scenario_file((kFolder / name).string());
  EXPECT_TRUE(result.ok()) << result.diagnostics.text();
  return result.scenario;
}

// Keys in which two scenarios differ, other than name and description.
std::vector<std::string_view> differences(const Scenario& a, const Scenario& b) {
  std::vector<std::string_view> keys;
  for (const Parameter& p : parameters()) {
    if (!p.group().empty() && p.get(a) != p.get(b)) keys.push_back(p.key);
  }
  return keys;
}

TEST(ScenarioFiles, AllLoadAndPassTheChecks) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().extension() != ".toml") continue;
    ++files;
    SCOPED_TRACE(entry.path());
    const Scenario scenario = load(entry.path().filename());
    EXPECT_EQ(scenario.name, entry.path().stem());
    EXPECT_FALSE(scenario.description.empty());
    const Diagnostics diagnostics = check_scenario(scenario);
    EXPECT_TRUE(diagnostics.ok()) << diagnostics.text();
  }
  EXPECT_GE(files, 5);
}

TEST(ScenarioFiles, EveryParameterHasAComment) {
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().extension() != ".toml") continue;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      const std::string key = line.substr(0, line.find(" = "));
      if (key == line || line[0] == '#' || key == "name" || key == "description") continue;
      EXPECT_NE(line.find("# "), std::string::npos) << entry.path() << ": " << line;
    }
  }
}

TEST(ScenarioFiles, LowKinkIsTheDefault) { EXPECT_TRUE(differences(load("low_kink.toml"), Scenario()).empty()); }

// The file's head says which.
TEST(ScenarioFiles, CaseOneDepartsFromTheDefaultsInItsPocketOnly) {
  EXPECT_EQ(differences(load("case1.toml"), Scenario()),
            (std::vector<std::string_view>{"pocket.mesh_rows", "rods.profile", "rods.wall_lower", "rods.wall_upper",
                                           "rods.elements_per_side", "rods.hinge_stiffness", "target.radius",
                                           "contact.friction", "towing.offset", "towing.offset_angle"}));
}

TEST(ScenarioFiles, PaperCasesDifferOnlyInTheClosingTime) {
  const Scenario case1 = load("case1.toml");
  const Scenario case2 = load("case2.toml");
  const Scenario case3 = load("case3.toml");
  EXPECT_EQ(differences(case1, case2), std::vector<std::string_view>{"closing.duration"});
  EXPECT_EQ(differences(case1, case3), std::vector<std::string_view>{"closing.duration"});
  // Tang et al. 2023, section 4.2.
  EXPECT_EQ(case1.closing.duration, 10);
  EXPECT_EQ(case2.closing.duration, 7.5);
  EXPECT_EQ(case3.closing.duration, 5);
}

}  // namespace
}  // namespace netpocket
