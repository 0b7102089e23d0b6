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
           {{{"name", "slow"}, {"value", "1 N"}, {"holds", first_holds}},
            {{"name", "fast"}, {"value", "2 N"}, {"holds", second_holds}}}}};
}

StudyRecord record(int point, const std::string& place, const Json& findings) {
  const Json run = {
      {"variant", "slow"}, {"reason", "finished"}, {"peak_force", {{"y", -12.5}}}, {"first_contact_time", nullptr}};
  return {{"point", point},
          {"place", place},
          {"settings", {{"target.radius", "4"}}},
          {"refused", ""},
          {"runs", Json::array({run})},
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
  study.report = {.of_search = true, .best = 2, .show = {"F2"}};
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

TEST(SearchReport, TellsWhenNothingWasRun) {
  Study study;
  study.report.of_search = true;
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
