// The three cases of the paper (scenarios/case1.toml to case3.toml) to their end: findings, energy, and how little the
// step matters.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "engine/analysis/run_history.h"
#include "engine/analysis/summary.h"
#include "engine/capture/run.h"
#include "engine/recording/soundness.h"
#include "engine/scenario/read_scenario.h"
#include "tests/engine/verification_table.h"

namespace netpocket {
namespace {

constexpr std::array<const char*, 3> kCases = {"case1", "case2", "case3"};

Scenario load(const std::string& name) {
  ScenarioResult result = read_scenario_file(NETPOCKET_SOURCE_DIR "/scenarios/" + name + ".toml");
  EXPECT_TRUE(result.ok());
  return result.scenario;
}

class VerificationPaperCases : public test::VerificationTest {
 protected:
  VerificationPaperCases() {
    std::string name = testing::TempDir() + "/cases-XXXXXX";
    folder_ = mkdtemp(name.data());
  }
  ~VerificationPaperCases() override { std::filesystem::remove_all(folder_); }

  Recording record(const Scenario& scenario) {
    const std::string path = (folder_ / fmt::format("{}.h5", ++count_)).string();
    const RunResult result = run_to_recording(scenario, path, {.version = "1", .commit = "a", .command = "test"});
    EXPECT_EQ(result.status.reason, RunReason::finished) << result.status.message;
    return Recording(path);
  }

 private:
  std::filesystem::path folder_;
  int count_ = 0;
};

// The verdicts of scenarios/FINDINGS.md by finding: the cells of its table after the statement, one for each case.
std::map<std::string, std::vector<std::string>> documented_verdicts() {
  std::map<std::string, std::vector<std::string>> verdicts;
  std::ifstream file(NETPOCKET_SOURCE_DIR "/scenarios/FINDINGS.md");
  for (std::string line; std::getline(file, line) && line != "## One by one";) {
    std::istringstream cells(line);
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, '|');) {
      if (cell.ends_with('\\')) continue;  // a bar within a cell
      row.push_back(cell.size() > 2 ? cell.substr(1, cell.size() - 2) : "");
    }
    if (row.size() > 5 && row[1].starts_with("F")) verdicts[row[1]] = {row[3], row[4], row[5]};
  }
  return verdicts;
}

// What is spent never comes back, but for round-off, and all accounts together are that of the energy error.
void expect_sound_accounts(const Recording& run) {
  constexpr Channel kSpent[] = {Channel::spent_in_cords, Channel::spent_at_hinges, Channel::spent_in_contacts,
                                Channel::spent_by_friction};
  const double round_off = 1e-12 * run.channel(Channel::energy_dissipated).back();
  for (const Channel c : kSpent) {
    const auto& spent = run.channel(c);
    for (std::size_t i = 1; i < spent.size(); ++i) {
      ASSERT_GE(spent[i], spent[i - 1] - round_off) << channel_info(c).name << " at t = " << run.times()[i];
    }
    EXPECT_GT(spent.back(), 0) << channel_info(c).name;
  }
  double before = 0;
  for (std::size_t i = 0; i < run.frame_count(); ++i) {
    double sum = 0;
    for (const Channel c : kSpent) sum += run.channel(c)[i];
    EXPECT_NEAR(sum, run.channel(Channel::energy_dissipated)[i], round_off);
    const double left = run.channel(Channel::energy_kinetic)[i] + run.channel(Channel::energy_strain)[i] +
                        run.channel(Channel::energy_contact)[i] + sum - run.channel(Channel::energy_input)[i];
    if (i == 0) before = left;
    EXPECT_NEAR(left - before, run.channel(Channel::energy_error)[i], 10 * round_off);
  }
}

// The document says of the three scenarios what their runs show: both are to be renewed together (`./dev findings`).
TEST_F(VerificationPaperCases, FindingsAreThoseOfTheDocumentAndEnergyIsKept) {
  std::vector<Recording> runs;
  for (const char* name : kCases) runs.push_back(record(load(name)));
  std::vector<const Recording*> pointers;
  for (const Recording& run : runs) pointers.push_back(&run);
  const auto documented = documented_verdicts();
  EXPECT_EQ(documented.size(), 11u);
  for (const Finding& finding : evaluate_findings(pointers)) {
    for (std::size_t i = 0; i < finding.cases.size(); ++i) {
      const FindingCase& found = finding.cases[i];
      const std::string what = fmt::format("{}, {}: {}", finding.id, found.name, found.value);
      if (finding.id == "F3") {
        EXPECT_EQ(found.verdict, Verdict::undecided) << what << " (single runs)";
        continue;
      }
      ASSERT_TRUE(documented.contains(finding.id)) << finding.id;
      EXPECT_EQ(to_string(found.verdict), documented.at(finding.id)[i]) << what;
    }
    // What does not hang on a single impact.
    const std::set<std::string> robust = {"F1", "F4", "F8", "F9", "F11"};
    if (robust.contains(finding.id)) {
      EXPECT_TRUE(std::ranges::all_of(finding.cases, &FindingCase::holds)) << finding.id;
    }
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    expect_below(fmt::format("{}: energy error / energy put in", kCases[i]), summarize(runs[i]).energy_error, 5e-3,
                 "audit of the whole run to 20 s, springs and dampers of contacts counted by their laws");
    expect_sound_accounts(runs[i]);
    for (const SafeguardCount& count : safeguard_counts(runs[i])) EXPECT_EQ(count.value, 0) << kCases[i] << count.name;
    EXPECT_EQ(safeguards_text(runs[i]), "none acted");
    ASSERT_TRUE(deepest_penetration(runs[i]));
    EXPECT_EQ(deepest_penetration(runs[i])->partner, "the target");
    EXPECT_LT(deepest_penetration(runs[i])->part, 1);
    // Rods are pressed deeper, but not by their radius.
    EXPECT_LE(deepest_penetration(runs[i])->depth,
              *std::ranges::max_element(runs[i].channel(Channel::penetration_max)) + 1e-12);
  }
}

// One long element a side is what the short closing ropes press hardest: at this safety it gained energy before the
// bound followed their length.
TEST_F(VerificationPaperCases, OneElementASideKeepsItsEnergyAsRopesShorten) {
  Scenario scenario = load("case1");
  scenario.pocket.elements_per_side = 1;
  scenario.solver.safety = 0.97;
  scenario.output.end_time = 12;
  expect_below("case1, one element a side, safety 0.97: energy error / energy put in",
               summarize(record(scenario)).energy_error, 5e-3, "audit to 12 s, past the closing");
}

// First contact and the impulse with which the mouth presses the target down before it is thrown back. What follows is
// chatter between mouth and cone, whose single impulses are not determined.
struct Press {
  double first_contact, impulse;
};

Press first_press(const Recording& run) {
  const RunHistory history(run);
  const std::vector<ContactEpisode> episodes = history.episodes(history.until_closed(), 0.02);
  EXPECT_FALSE(episodes.empty());
  return {history.first_contact().value_or(0), episodes.front().impulse};
}

TEST_F(VerificationPaperCases, HalfTheStep) {
  for (const char* name : kCases) {
    Scenario scenario = load(name);
    scenario.output.frame_rate = 200;
    scenario.output.end_time = scenario.closing.duration;
    const Press whole = first_press(record(scenario));
    scenario.solver.safety /= 2;
    const Press half = first_press(record(scenario));
    const std::string what = std::string(name) + ": ";
    expect_below(what + "first contact, difference to half the step, s",
                 std::abs(whole.first_contact - half.first_contact), 0.0101, "two frames of 0.005 s");
    expect_below(what + "impulse of the first press, relative difference to half the step",
                 std::abs(whole.impulse / half.impulse - 1), 0.05, fmt::format("{:.2f} N s", half.impulse));
  }
}

}  // namespace
}  // namespace netpocket
