// What a person gets to read who mistypes, and that nothing in a file does harm.

#include "engine/scenario/read_scenario.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <random>

#include "engine/scenario/write_scenario.h"

namespace netpocket {
namespace {

std::string problems(std::string_view text) { return read_scenario_text(text, "a.toml").diagnostics.text(); }

TEST(ReadScenario, EmptyTextGivesTheDefaults) {
  const ScenarioResult result = read_scenario_text("", "a.toml");
  EXPECT_TRUE(result.ok());
  EXPECT_EQ(result.scenario.net.diameter, Scenario().net.diameter);
}

TEST(ReadScenario, ReadsEveryKindOfValue) {
  const ScenarioResult result = read_scenario_text(R"(
name = "mine"
closing = {law = "table", table = [[0, 5.8], [2.5, 2]]}
target.spin = [0, 1, -0.5]
[pocket]
mesh_rows = 8
[contact]
spacecraft = false
friction = 1
)",
                                                   "a.toml");
  ASSERT_TRUE(result.ok()) << result.diagnostics.text();
  EXPECT_EQ(result.scenario.name, "mine");
  EXPECT_EQ(result.scenario.closing.law, ClosingLaw::table);
  ASSERT_EQ(result.scenario.closing.table.size(), 2u);
  EXPECT_EQ(result.scenario.closing.table[1], Eigen::Vector2d(2.5, 2));
  EXPECT_EQ(result.scenario.target.spin, Eigen::Vector3d(0, 1, -0.5));
  EXPECT_EQ(result.scenario.pocket.mesh_rows, 8);
  EXPECT_FALSE(result.scenario.contact.spacecraft);
  EXPECT_EQ(result.scenario.contact.friction, 1);
}

TEST(ReadScenario, UnknownKeysGetTheNearestName) {
  EXPECT_EQ(problems("[net]\ndiametre = 1"),
            "a.toml:2: net.diametre: is not a parameter; did you mean 'net.diameter'?");
  EXPECT_EQ(problems("[pocket]\n\ndiameter = 1"),
            "a.toml:3: pocket.diameter: is not a parameter; did you mean 'net.diameter'?");
  EXPECT_EQ(problems("seed = 1"), "a.toml:1: seed: is not a parameter; did you mean 'solver.seed'?");
  EXPECT_EQ(problems("[nets]\ndiameter = 1"), "a.toml:1: nets: is not a table of a scenario; did you mean 'net'?");
  EXPECT_EQ(problems("[solver]\nxyzzy_plugh = 1"),
            "a.toml:2: solver.xyzzy_plugh: is not a parameter; scenarios/REFERENCE.md lists them all");
}

TEST(ReadScenario, WrongTypesNameWhatIsExpected) {
  EXPECT_EQ(problems("[net]\ndiameter = \"4 mm\""),
            "a.toml:2: net.diameter: expects a number in m, not the text \"4 mm\"");
  EXPECT_EQ(problems("pocket.rod_count = 8.0"), "");
  EXPECT_EQ(
      problems("target.spin = [1, \"2\", 3]"),
      "a.toml:1: target.spin: expects a list of three numbers [x, y, z] in rad/s, not one with the text \"2\" in it");
  EXPECT_EQ(
      problems("rods.profile = [[1, 2], [3, true]]"),
      "a.toml:1: rods.profile: expects a list of pairs of numbers [[a, b], ...] in m, m, not one with true in it");
  EXPECT_EQ(problems("pocket.rod_count = 8.5"), "a.toml:1: pocket.rod_count: expects a whole number, not 8.5");
  EXPECT_EQ(problems("contact.spacecraft = 1"), "a.toml:1: contact.spacecraft: expects true or false, not 1");
  EXPECT_EQ(problems("target.spin = [1, 2]"),
            "a.toml:1: target.spin: expects a list of three numbers [x, y, z] in rad/s, not a list of 2");
  EXPECT_EQ(
      problems("target.shape = \"shpere\""),
      "a.toml:1: target.shape: expects one of \"sphere\", \"box\", \"cylinder\", \"satellite\", \"mesh\", not the text "
      "\"shpere\"; did you mean \"sphere\"?");
  EXPECT_EQ(problems("[net.diameter]\nx = 1"), "a.toml:1: net.diameter: expects a number in m, not a table");
  EXPECT_EQ(problems("net = 3"), "a.toml:1: net: is a table: write [net] and its keys on the lines below");
  EXPECT_EQ(problems("[[net]]"), "a.toml:1: net: is a table: write [net] and its keys on the lines below");
  EXPECT_EQ(
      problems("rods.profile = [[1, 2], [3]]"),
      "a.toml:1: rods.profile: expects a list of pairs of numbers [[a, b], ...] in m, m, not one with a list of 1 "
      "in it");
  EXPECT_EQ(problems("name = 2024-01-01"), "a.toml:1: name: expects text in quotes, not a date or time");
}

TEST(ReadScenario, RangeErrorsSayWhatIsAllowed) {
  EXPECT_EQ(problems("net.diameter = -1"), "a.toml:1: net.diameter: must be >= 1e-5 and <= 0.1 m, not -1");
  EXPECT_EQ(problems("net.poisson_ratio = -1"), "a.toml:1: net.poisson_ratio: must be > -1 and <= 0.5, not -1");
  EXPECT_EQ(problems("target.inertia = [1, 0, 1]"),
            "a.toml:1: target.inertia: each number must be >= 1e-6 and <= 10e9 kg m^2, not 0");
  EXPECT_EQ(problems("net.density = nan"), "a.toml:1: net.density: must be finite, not nan");
  EXPECT_EQ(problems("target.spin = [0, -inf, 0]"), "a.toml:1: target.spin: must be finite, not -inf");
  EXPECT_EQ(problems("pocket.rod_count = 1000000000"), "a.toml:1: pocket.rod_count: must be >= 3 and <= 64, not 1e9");
  EXPECT_EQ(problems("solver.seed = 9223372036854775807").substr(0, 39), "a.toml:1: solver.seed: must be >= 0 and");
  EXPECT_EQ(problems("name = \"\""), "a.toml:1: name: has 0 characters, allowed are 1 to 100 characters");
}

TEST(ReadScenario, SyntaxErrorsGiveTheLine) {
  EXPECT_EQ(problems("[net]\ndiameter = \n").substr(0, 10), "a.toml:2: ");
  EXPECT_EQ(problems("[net]\n[net]").substr(0, 10), "a.toml:2: ");
  EXPECT_EQ(problems("a = 1\nb = \"\xff\xfe\"").substr(0, 10), "a.toml:2: ");
  for (const std::string text : {"a = 1\nb = \"", "[net", "= 1", "net.diameter = 1e999", "\xff", "a = 0x"}) {
    const ScenarioResult result = read_scenario_text(text, "a.toml");
    ASSERT_EQ(result.diagnostics.list().size(), 1u) << text;
    EXPECT_GT(result.diagnostics.list()[0].line, 0) << text;
    EXPECT_EQ(result.diagnostics.text().find('\n'), std::string::npos) << text;
  }
}

TEST(ReadScenario, ProblemsAreListedInTheOrderOfTheFile) {
  const ScenarioResult result = read_scenario_text("[solver]\nsafety = 2\n[net]\ndensity = 0\nradius = 1", "a.toml");
  ASSERT_EQ(result.diagnostics.list().size(), 3u);
  EXPECT_EQ(result.diagnostics.list()[0].key, "solver.safety");
  EXPECT_EQ(result.diagnostics.list()[1].key, "net.density");
  EXPECT_EQ(result.diagnostics.list()[2].key, "net.radius");
}

TEST(ReadScenario, ManyProblemsAreCutShort) {
  std::string text;
  for (int i = 0; i < 30000; ++i) text += "unknown_" + std::to_string(i) + " = 1\n";
  const ScenarioResult result = read_scenario_text(text, "a.toml");
  ASSERT_EQ(result.diagnostics.list().size(), 21u);
  EXPECT_EQ(result.diagnostics.list().back().text(), "a.toml: 29980 more problems");
}

// Each would overflow the stack, the memory or the patience of a careless reader.
TEST(ReadScenario, HostileTextGivesOneShortSentence) {
  constexpr std::size_t kLarge = kLargestScenarioFile - 100;
  std::string dots;
  for (std::size_t i = 0; i < kLarge / 2; ++i) dots += "a.";
  const std::vector<std::string> texts = {
      dots + "a = 1",
      "[" + dots + "a]",
      "x = {" + dots + "a = 1}",
      "a = " + std::string(kLarge, '['),
      "a = " + std::string(kLarge / 2, '[') + std::string(kLarge / 2, ']'),
      std::string(kLarge, 'k') + " = 1",
      std::string(kLarge / 2 - 10, 'k') + " = 1\n" + std::string(kLarge / 2 - 10, 'k') + " = 1",
      "name = \"" + std::string(kLarge, 'x') + "\"",
      "target.shape = \"" + std::string(kLarge, 'x') + "\"",
      "net.diameter = " + std::string(kLarge, '9'),
      std::string(kLarge, '\0'),
      std::string(kLargestScenarioFile + 1, ' '),
  };
  for (const std::string& text : texts) {
    const ScenarioResult result = read_scenario_text(text, "a.toml");
    ASSERT_EQ(result.diagnostics.list().size(), 1u) << text.substr(0, 20);
    EXPECT_LT(result.diagnostics.text().size(), 400u) << text.substr(0, 20);
  }
}

// Nesting that the parser allows, at its deepest: inline tables of long keys.
TEST(ReadScenario, DeepButLegalNestingIsSurvived) {
  std::string text = "x = ";
  for (int i = 0; i < 250; ++i) text += "{a.b.c.d.e.f.g.h = ";
  text += "1" + std::string(250, '}');
  EXPECT_FALSE(read_scenario_text(text, "a.toml").ok());
}

// Either a scenario or a reason, whatever happened to the file.
TEST(ReadScenario, DamagedFilesAreReadOrRefused) {
  const std::string whole = write_scenario_text({});
  std::mt19937 random(7);
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string text = whole;
    for (int change = 0; change < 4; ++change) {
      const std::size_t at = random() % text.size();
      switch (random() % 3) {
        case 0:
          text[at] = static_cast<char>(random());
          break;
        case 1:
          text.erase(at, random() % 40);
          break;
        case 2:
          text.insert(at, text.substr(random() % text.size(), random() % 40));
          break;
      }
    }
    const ScenarioResult result = read_scenario_text(text, "a.toml");
    if (!result.ok()) {
      ++refused;
    } else {
      EXPECT_TRUE(read_scenario_text(write_scenario_text(result.scenario), "again").ok());
    }
  }
  // Most changes hit comments, which hold most of the text.
  EXPECT_GT(refused, 500);
  EXPECT_LT(refused, 3000);
}

TEST(ReadScenario, ControlCharactersDoNotReachTheTerminal) {
  const std::string text = problems("name = 1\n\"\\u001b[31m\\n\" = 1\ntarget.shape = \"\\u001b]0;x\\u0007\"");
  EXPECT_EQ(text.find('\x1b'), std::string::npos) << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << text;
  // The parser's own messages repeat the file too.
  const std::string unfinished = problems("\"\"a\x1b[31m\"\n\"\"\"\n");
  EXPECT_EQ(std::count_if(unfinished.begin(), unfinished.end(), [](char c) { return std::iscntrl(c) != 0; }), 0)
      << unfinished;
}

TEST(ReadScenarioFile, MissingFilesAndFoldersGetOneSentence) {
  EXPECT_EQ(read_scenario_file("no/such.toml").diagnostics.text(), "no/such.toml: there is no such file");
  const std::string folder = std::filesystem::temp_directory_path().string();
  EXPECT_EQ(read_scenario_file(folder).diagnostics.text(), folder + ": is a folder, not a scenario file");
  EXPECT_EQ(read_scenario_file("").diagnostics.list().size(), 1u);
}

TEST(ReadScenarioFile, EndlessDevicesAreRefused) {
  EXPECT_EQ(read_scenario_file("/dev/zero").diagnostics.text(),
            "/dev/zero: is larger than 1000000 bytes, the limit for a scenario");
}

// The largest amount of memory that this program has had, bytes.
double peak_memory() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

// Of a file with a single line of 1 GB only as much is read as a scenario may hold.
TEST(ReadScenarioFile, AnEndlessLineCostsNoMemory) {
  const auto path = std::filesystem::path(testing::TempDir()) / "netpocket_long_line.toml";
  std::ofstream(path) << "name = \"";
  std::filesystem::resize_file(path, 1000000000);  // zeros, which take no room on the disk
  const double before = peak_memory();
  EXPECT_EQ(read_scenario_file(path).diagnostics.text(),
            path.string() + ": is larger than 1000000 bytes, the limit for a scenario");
  EXPECT_LT(peak_memory() - before, 20e6);
  std::filesystem::remove(path);
}

TEST(ReadScenarioFile, TheNameDefaultsToThatOfTheFile) {
  const auto path = std::filesystem::path(testing::TempDir()) / "netpocket_unnamed.toml";
  std::ofstream(path) << "[net]\ndiameter = 0.005\n";
  EXPECT_EQ(read_scenario_file(path).scenario.name, "netpocket_unnamed");
  std::ofstream(path) << "name = \"given\"\n";
  EXPECT_EQ(read_scenario_file(path).scenario.name, "given");
  std::filesystem::remove(path);
}

TEST(ApplySetting, SetsWhatItNames) {
  Scenario s;
  EXPECT_TRUE(apply_setting(s, "net.diameter=0.006").ok());
  EXPECT_TRUE(apply_setting(s, " pocket.mesh_rows = 8 ").ok());
  EXPECT_TRUE(apply_setting(s, "closing.law=quintic").ok());
  EXPECT_TRUE(apply_setting(s, "target.shape=\"box\"").ok());
  EXPECT_TRUE(apply_setting(s, "target.spin=[0, 0.1, 0]").ok());
  EXPECT_TRUE(apply_setting(s, "name=a = b").ok());
  EXPECT_EQ(s.net.diameter, 0.006);
  EXPECT_EQ(s.pocket.mesh_rows, 8);
  EXPECT_EQ(s.closing.law, ClosingLaw::quintic);
  EXPECT_EQ(s.target.shape, TargetShape::box);
  EXPECT_EQ(s.target.spin.y(), 0.1);
  EXPECT_EQ(s.name, "a = b");
}

TEST(ApplySetting, SaysWhatIsWrong) {
  const auto problem = [](std::string_view setting) {
    Scenario s;
    return apply_setting(s, setting).text();
  };
  EXPECT_EQ(problem("net.diameter"), "a setting is written key=value, not \"net.diameter\"");
  EXPECT_EQ(problem("net.diametr=1"), "\"net.diametr\" is not a parameter; did you mean 'net.diameter'?");
  EXPECT_EQ(problem("net.diameter=4mm"), "net.diameter: expects a number in m, not \"4mm\"");
  EXPECT_EQ(problem("net.diameter="), "net.diameter: expects a number in m, not \"\"");
  EXPECT_EQ(problem("net.diameter=4"), "net.diameter: must be >= 1e-5 and <= 0.1 m, not 4");
  EXPECT_EQ(problem("closing.law=cyclod"),
            "closing.law: expects one of \"cycloid\", \"quintic\", \"trapezoid\", \"linear\", \"table\", not the text "
            "\"cyclod\"; did you mean \"cycloid\"?");
  EXPECT_EQ(problem("net.diameter=0.01\n[rods]"), "net.diameter: expects a number in m, not \"0.01\\n[rods]\"");
  EXPECT_FALSE(problem("name=\xff").empty());
}

}  // namespace
}  // namespace netpocket
