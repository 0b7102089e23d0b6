#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/study/findings_report.h"
#include "engine/study/search_report.h"
#include "tests/engine/study/study_folder.h"

namespace netpocket {
namespace {

using Json = nlohmann::ordered_json;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

Json finding(const std::string& id, bool first_holds, bool second_holds) {
  return {{"id", id},
          {"text", "Something | is so."},
          {"rule", "it is"},
          {"cases",
           {{{"name", "slow"}, {"value", "1 N"}, {"holds", first_holds}, {"verdict", first_holds ? "yes" : "no"}},
            {{"name", "fast"}, {"value", "2 N"}, {"holds", second_holds}, {"verdict", second_holds ? "yes" : "no"}}}}};
}

StudyRecord record(int point, const std::string& place, const Json& findings) {
  const Json run = {
      {"variant", "slow"}, {"reason", "finished"}, {"peak_force", {{"y", -12.5}}}, {"first_contact_time", nullptr}};
  return {{"point", point},      {"place", place},
          {"draw", 0},           {"settings", {{"target.radius", "4"}}},
          {"refused", ""},       {"runs", Json::array({run})},
          {"findings", findings}};
}

TEST(FindingsReport, TellsValuesRobustnessAndRemarks) {
  Study study;
  study.name = "findings";
  study.description = "What this is.";
  study.remarks["F2"] = "Most likely because.";
  study.places = {{}};
  study.variants = {{}};
  const std::string text =
      findings_report(study, {record(1, "default", {finding("F1", true, true), finding("F2", true, false)}),
                              record(2, "half step", {finding("F1", true, true), finding("F2", false, false)}),
                              record(3, "mesh", {finding("F1", true, false), finding("F2", true, true)})});
  EXPECT_TRUE(contains(text, "What this is.")) << text;
  EXPECT_TRUE(contains(text, "| F1 | Something \\| is so. | yes | yes | 1 of 2 other points |")) << text;
  EXPECT_TRUE(contains(text, "| F2 | Something \\| is so. | yes | no | 1 of 2 other points |")) << text;
  EXPECT_TRUE(contains(text, "Holds in all cases at 1 of the 2 other points; not at half step (slow, fast).")) << text;
  EXPECT_TRUE(contains(text, "not at mesh (fast).")) << text;
  EXPECT_TRUE(contains(text, "| fast | no | 2 N |\n")) << text;
  EXPECT_TRUE(contains(text, "Most likely because.")) << text;
  EXPECT_TRUE(contains(text, "| mesh | `target.radius = 4` | -12.5 | none | 1: F2 |")) << text;
  EXPECT_TRUE(contains(text, study_identity(study))) << text;
}

// F3 of a judged point and of draws: one closing in 10 s with peaks about 100 N, one in 5 s with peaks about `fast` N.
StudyRecord draw(int number, double fast) {
  const double slow = 100 + number % 4, swift = fast + number % 3;
  const auto run = [](const char* variant, double closing_end, double peak) {
    return fmt::format(R"({{"variant": "{}", "reason": "finished", "closing_end": {}, "peak_force": {{"y": -{}}},
                            "first_contact_time": null}})",
                       variant, closing_end, peak);
  };
  const auto peak_case = [](const char* name, double peak) {
    return fmt::format(R"({{"name": "{}", "value": "one draw decides nothing", "holds": null, "verdict": "undecided",
                            "measures": [{{"name": "peak |F_y|", "unit": "N", "value": {}}}]}})",
                       name, peak);
  };
  const char* other = number != 2 ? R"("holds": true, "verdict": "yes", "measures": [])"
                                  : R"("holds": false, "verdict": "no", "measures": [])";
  return Json::parse(fmt::format(
      R"({{"point": {}, "place": "judged", "draw": {}, "settings": {{}}, "refused": "", "runs": [{}, {}], "findings": [
             {{"id": "F3", "text": "Faster is harder.", "rule": "by draws", "cases": [{}, {}]}},
             {{"id": "F4", "text": "Something is so.", "rule": "it is", "cases": [{{"name": "slow", "value": "1", {}}}]}}
         ]}})",
      number + 1, number, run("slow", 10, slow), run("fast", 5, swift), peak_case("slow", slow),
      peak_case("fast", swift), other));
}

std::vector<StudyRecord> ensemble(double fast) {
  std::vector<StudyRecord> records;
  for (int number = 0; number <= 6; ++number) records.push_back(draw(number, fast));
  return records;
}

TEST(FindingsReport, DrawsDecideF3AndTellTheSpreadOfOthers) {
  Study study;
  study.places = {{}};
  study.variants = {{}};
  std::vector<StudyRecord> records = ensemble(200);
  StudyRecord other = draw(0, 200);
  other["place"] = "half step";
  records.push_back(other);
  const std::string text = findings_report(study, records);
  EXPECT_TRUE(contains(text, "| F3 | Faster is harder. | yes | yes | decided by 6 | single draws |")) << text;
  EXPECT_TRUE(contains(text, "| F4 | Something is so. | yes | 5 of 6 | 1 of 1 other points |")) << text;
  EXPECT_TRUE(contains(text, "6 draws from 200 to 202")) << text;
  EXPECT_TRUE(contains(text, "| slow | yes | peak \\|F_y\\| 100 N in the run without displacements |")) << text;
  EXPECT_TRUE(contains(text, "| fast |  | peak \\|F_y\\|, N | 201 | 200 | 202 |")) << text;
  EXPECT_TRUE(contains(text, "Holds in all cases in 5 of 6 draws of the ensemble.")) << text;
  EXPECT_FALSE(contains(text, "solver.seed")) << "draws are no points of their own";
  EXPECT_TRUE(contains(findings_report(study, ensemble(101)), "| F3 | Faster is harder. | undecided | undecided |"));
  EXPECT_TRUE(contains(findings_report(study, ensemble(50)), "| F3 | Faster is harder. | no | no |"));
}

TEST(FindingsReport, DrawsThatDivergeAreTold) {
  Study study;
  study.places = {{}};
  study.variants = {{}};
  std::vector<StudyRecord> records = ensemble(200);
  records[3]["runs"][0]["reason"] = "diverged";
  const std::string text = findings_report(study, records);
  EXPECT_TRUE(contains(text, "decided by 5")) << text;
  EXPECT_TRUE(contains(text, "1 more draws diverged or could not be run.")) << text;
}

TEST(FindingsReport, NeedsItsFirstPoint) {
  Study study;
  StudyRecord refused = record(1, "default", Json::array());
  refused["runs"] = Json::array();
  EXPECT_TRUE(contains(findings_report(study, {refused}), "The first point was not run."));
}

TEST(SearchReport, RanksPointsAndShowsValues) {
  Study study;
  study.name = "A search";
  study.description = "Over radii.";
  study.places = {{}};
  study.variants = {{}};
  study.report = {.of = ReportOf::search, .best = 2, .show = {"F2"}};
  const Json yes = finding("F1", true, true), no = finding("F1", true, false);
  StudyRecord refused = record(4, "", Json::array());
  refused["runs"] = Json::array();
  StudyRecord large = record(3, "", {yes, finding("F2", true, true)});
  large["settings"]["target.radius"] = "5";
  const std::string text = study_report(study, {record(1, "", {no, finding("F2", false, false)}),
                                                record(2, "", {yes, finding("F2", true, false)}), large, refused});
  EXPECT_TRUE(contains(text, "## A search\n\nOver radii.\n")) << text;
  EXPECT_TRUE(contains(text, "4 points, 1 of them refused as not valid. In all cases hold F1 at 2, F2 at 1.")) << text;
  EXPECT_TRUE(contains(text, "| point | `target.radius` | findings that hold in all cases | F2 |")) << text;
  const auto best = text.find("| point 3 | 5 | 2: F1 F2 | slow: yes, 1 N<br>fast: yes, 2 N |");
  const auto second = text.find("| point 2 | 4 | 1: F1 | slow: yes, 1 N<br>fast: no, 2 N |");
  EXPECT_NE(best, text.npos) << text;
  EXPECT_NE(second, text.npos) << text;
  EXPECT_LT(best, second);
  EXPECT_FALSE(contains(text, "point 1 ")) << text;
}

// A run of a variant with a metric.
Json measured(const std::string& variant, double angle) {
  return {{"variant", variant}, {"reason", "finished"}, {"captured", true}, {"metrics", {{"impact_attitude", angle}}}};
}

StudyRecord drawn(const std::string& place, int seed, double plain, double good) {
  StudyRecord record = {{"point", 1},    {"outcome", "done"}, {"place", place},           {"draw", 0},
                        {"refused", ""}, {"settings", {}},    {"findings", Json::array()}};
  record["settings"]["solver.seed"] = std::to_string(seed);
  record["runs"] = Json::array({measured("plain", plain), measured("good", good)});
  return record;
}

// Draws of a point are judged together; a statement about a ratio takes that of each draw.
TEST(StatementsReport, JudgesEachPointByAllItsDraws) {
  Study study;
  study.name = "Impact";
  study.file = "impact";
  study.places = {{}};
  study.variants = {{"plain", {}}, {"good", {}}};
  study.axes = {{.key = "solver.seed", .values = {"1", "2"}}};
  study.report = {.of = ReportOf::statements, .show = {"impact_attitude"}};
  study.statements = {
      {.text = "It turns | a tenth.",
       .column = "impact_attitude",
       .variant = "good",
       .against = "plain",
       .at_most = 0.1},
      {.text = "It turns at all.", .column = "impact_attitude", .variant = "good", .against = "", .at_least = 0.01}};
  study.remarks["S1"] = "Because.";
  const std::string text =
      study_report(study, {drawn("fast", 1, 2, 0.1), drawn("fast", 2, 4, 0.4), drawn("slow", 1, 1, 0.05),
                           drawn("slow", 2, 1, 0.5), drawn("late", 1, 1, 0.5), drawn("late", 2, 2, 1)});
  EXPECT_TRUE(contains(text, "## Impact\n")) << text;
  EXPECT_TRUE(contains(text, "| S1 | It turns \\| a tenth. | no, holds at 1 of 3 points |")) << text;
  EXPECT_TRUE(contains(text, "| S2 | It turns at all. | yes, holds at 3 of 3 points |")) << text;
  EXPECT_TRUE(contains(text, "| fast | yes | 0.1 to 0.4 | 2 to 4 | 0.05 to 0.1 |")) << text;
  EXPECT_TRUE(contains(text, "| slow | undecided: in 1 of 2 draws | 0.05 to 0.5 | 1 | 0.05 to 0.5 |")) << text;
  EXPECT_TRUE(contains(text, "| late | no | 0.5 to 1 | 1 to 2 | 0.5 |")) << text;
  EXPECT_TRUE(contains(text, "divided by that with plain, is at most 0.1 in each draw.")) << text;
  EXPECT_TRUE(contains(text, "\nBecause.\n")) << text;
  EXPECT_TRUE(contains(text, "| late | plain | 1 to 2 |")) << text;
}

// Neither a run that diverged nor one that was not made counts as a number.
TEST(StatementsReport, TellsWhatIsNotKnown) {
  Study study;
  study.places = {{}};
  study.variants = {{"plain", {}}};
  study.report.of = ReportOf::statements;
  study.statements = {
      {.text = "It turns little.", .column = "impact_attitude", .variant = "plain", .against = "", .at_most = 1}};
  StudyRecord diverged = drawn("", 1, 0.5, 0), refused = drawn("", 2, 0.5, 0);
  diverged["runs"][0]["reason"] = diverged["outcome"] = "diverged";
  refused["runs"] = Json::array();
  refused["outcome"] = "refused";
  const std::string text = study_report(study, {diverged, refused});
  EXPECT_TRUE(contains(text, "undecided, holds at 0 of 1 points")) << text;
  EXPECT_TRUE(contains(text, "| all | not known | - |")) << text;
  EXPECT_TRUE(contains(text, "1 points were refused as not valid. 1 points have runs that diverged.")) << text;
}

TEST(SearchReport, TellsWhenNothingWasRun) {
  Study study;
  study.report.of = ReportOf::search;
  EXPECT_TRUE(contains(study_report(study, {}), "No point was run."));
}

TEST(FindingsReport, IdentityFollowsScenarios) {
  Study study;
  study.places = {{}};
  study.variants = {{}};
  const std::string before = study_identity(study);
  EXPECT_EQ(before.size(), 16u);
  study.base.target.mass = 300;
  EXPECT_NE(study_identity(study), before);
}

}  // namespace
}  // namespace netpocket
