// The scenarios that come with the program.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

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

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
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

TEST(ScenarioFiles, EveryKeyHasAComment) {
  const std::regex bare_key("(^|\n)[a-z_]+ = [^#\n]*(\n|$)");
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().extension() != ".toml") continue;
    const std::string text = text_of(entry.path());
    std::smatch match;
    const std::string body = text.substr(text.find("description"));
    const std::string keys = body.substr(body.find('\n'));
    EXPECT_FALSE(std::regex_search(keys, match, bare_key)) << entry.path() << match.str();
  }
}

TEST(ScenarioFiles, CaseOneStatesTheDefaults) { EXPECT_TRUE(differences(load("case1.toml"), Scenario()).empty()); }

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
