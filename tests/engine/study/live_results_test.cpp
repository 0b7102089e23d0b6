// A study's folder while it fills: records as they come, the scenario of a point, and a table that grows.
#include "engine/study/live_results.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "engine/capture/run.h"
#include "engine/scenario/fidelity.h"
#include "engine/scenario/write_scenario.h"
#include "engine/study/run_study.h"
#include "engine/study/study_plan.h"
#include "tests/engine/study/study_folder.h"

namespace netpocket {
namespace {

constexpr const char* kSmall = R"(
sampling = "sobol"
samples = 8
[set]
pocket.elements_per_side = 1
pocket.mesh_rows = 2
pocket.mesh_columns = 2
output.end_time = 0.02
[uncertain]
target.mass = { distribution = "normal", mean = 200, deviation = 20 }
"target.velocity[1]" = { distribution = "uniform", min = -0.5, max = -0.1 }
contact.friction = { distribution = "triangular", min = 0.5, mode = 1, max = 1.5, relative = true }
)";

Study read(const StudyFolder& folder, const std::string& text) {
  StudyResult result = folder.read(text);
  EXPECT_TRUE(result.ok()) << result.diagnostics.text();
  return std::move(result.study);
}

std::vector<FollowedRecord> all_records(const std::string& folder) {
  RecordFollower follower(folder);
  return follower.read_new();
}

TEST(LiveResults, TellWhichRowsAreDrafts) {
  const StudyFolder folder;
  const Study study = read(folder, kSmall + std::string(R"(
[[variant]]
name = "draft"
solver.fidelity = "draft"
[[variant]]
name = "full"
)"));
  const std::string out = folder.file("out");
  run_study(study, out, {.jobs = 2, .version = "v", .commit = "c"});
  LiveResults results(read_study_manifest(out));
  // The second time each takes the place of itself.
  for (int round = 0; round < 2; ++round) {
    for (const FollowedRecord& record : all_records(out)) results.add(record);
    EXPECT_EQ(results.results().size(), 16u);
    EXPECT_EQ(results.drafts(), 8u);
    EXPECT_EQ(results.draft_notice(), draft_notice(Fidelity::draft));
  }
}

TEST(StudyManifest, MakesTheScenarioOfAnyPointWithoutTheStudysFile) {
  const StudyFolder folder;
  const Study study = read(folder, kSmall + std::string(R"(
[[variant]]
name = "slow"
closing.duration = 10
[[variant]]
name = "fast"
closing.duration = 5
)"));
  const std::string out = folder.file("out");
  run_study(study, out, {.jobs = 2, .version = "v", .commit = "c"});
  std::filesystem::remove(folder.file("study.toml"));
  const StudyManifest manifest = read_study_manifest(out);
  EXPECT_EQ(manifest.study, "study");
  EXPECT_EQ(manifest.points, 8u);
  EXPECT_EQ(manifest.file, std::filesystem::canonical(folder.file("")).string() + "/study.toml");
  ASSERT_TRUE(manifest.base);
  const StudyPlan plan(study);
  const auto records = all_records(out);
  ASSERT_EQ(records.size(), 8u);
  for (const FollowedRecord& followed : records) {
    for (std::size_t run = 0; run < 2; ++run) {
      const StudyScenario again = recorded_scenario(manifest, followed.record, run);
      ASSERT_TRUE(again.diagnostics.ok()) << again.diagnostics.text();
      const StudyScenario first = study_scenario(study, plan.point(followed.place.point - 1), study.variants[run]);
      EXPECT_EQ(write_scenario_text(again.scenario), write_scenario_text(first.scenario));
    }
    EXPECT_TRUE(is_as_recorded(manifest, followed.record, "vc"));
    EXPECT_FALSE(is_as_recorded(manifest, followed.record, "another program"));
  }
  EXPECT_FALSE(recorded_scenario(manifest, records[0].record, 2).diagnostics.ok());
}

TEST(StudyManifest, OfAnEarlierVersionTellsHowFarItIsButMakesNoScenario) {
  const StudyFolder folder;
  std::filesystem::create_directories(folder.file("old"));
  folder.write("old/study_manifest.json", R"({"study": "old", "points": 3, "variants": ["slow", "fast"]})");
  const StudyManifest manifest = read_study_manifest(folder.file("old"));
  EXPECT_EQ(manifest.points, 3u);
  ASSERT_EQ(manifest.variants.size(), 2u);
  EXPECT_EQ(manifest.variants[1].name, "fast");
  const StudyScenario none = recorded_scenario(manifest, StudyRecord(), 0);
  EXPECT_NE(none.diagnostics.text().find("--resume"), std::string::npos);
  folder.write("old/study_manifest.json", R"({"study": "old", "points": "many"})");
  EXPECT_THROW(read_study_manifest(folder.file("old")), FileError);
  EXPECT_THROW(read_study_manifest(folder.file("nowhere")), FileError);
}

TEST(RecordFollower, GivesEachCompleteLineOnce) {
  const StudyFolder folder;
  std::filesystem::create_directories(folder.file("out/records"));
  RecordFollower follower(folder.file("out"));
  EXPECT_TRUE(follower.read_new().empty());
  const std::string first = R"({"point":2,"outcome":"done","identity":"a","runs":[]})",
                    second = R"({"point":1,"outcome":"refused","identity":"b","runs":[]})";
  std::ofstream file(folder.file("out/records/1_of_1.jsonl"));
  file << first << "\n" << second.substr(0, 20) << std::flush;
  auto found = follower.read_new();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].place.point, 2u);
  EXPECT_TRUE(follower.read_new().empty()) << "half a line is none";
  file << second.substr(20) << "\nno record\n" << std::flush;
  found = follower.read_new();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].place.outcome, "refused");
  EXPECT_EQ(found[0].place.offset, first.size() + 1);
  EXPECT_EQ(RecordReader().read(found[0].place)["identity"], "b");
  folder.write("out/records/2_of_2.jsonl", first + "\n");
  EXPECT_EQ(follower.read_new().size(), 1u) << "a file that is new";
  EXPECT_TRUE(follower.read_new().empty());
}

TEST(LiveResults, AreThoseOfTheFinishedTable) {
  const StudyFolder folder;
  const std::string out = folder.file("out");
  run_study(read(folder, kSmall), out, {.jobs = 2});
  LiveResults live(read_study_manifest(out));
  for (const FollowedRecord& followed : all_records(out)) live.add(followed);
  const StudyResults table = read_study_results(out);
  const StudyResults& results = live.results();
  ASSERT_EQ(results.size(), table.size());
  EXPECT_EQ(live.finished(), 8u);
  ASSERT_EQ(results.inputs.size(), 3u) << "what all points share is no input";
  for (const ResultColumn& column : table.inputs) {
    const ResultColumn* same = results.find(column.name);
    ASSERT_NE(same, nullptr) << column.name;
    EXPECT_EQ(same->unit == "" ? "1" : same->unit, column.unit) << column.name;
    for (std::size_t row = 0; row < table.size(); ++row) {
      const auto at = static_cast<std::size_t>(results.points[row]) - 1;
      EXPECT_EQ(same->values[row], column.values[at]) << column.name;
    }
  }
  const ResultColumn* speed = results.find("relative_speed_start");
  ASSERT_NE(speed, nullptr);
  EXPECT_EQ(speed->unit, "m/s");
  EXPECT_EQ(speed->values.size(), results.size());
}

TEST(LiveResults, HaveTheAxesOfAGridAndCountWhatIsRefused) {
  const StudyFolder folder;
  const std::string out = folder.file("out");
  const Study study = read(folder, R"(
findings = false
[set]
pocket.elements_per_side = 1
output.end_time = 0.02
[vary]
target.radius = [1, 2, 90]
)");
  const StudyOutcome outcome = run_study(study, out, {.jobs = 1});
  LiveResults live(read_study_manifest(out));
  for (const FollowedRecord& followed : all_records(out)) live.add(followed);
  EXPECT_EQ(live.finished(), 3u);
  EXPECT_EQ(live.refused(), outcome.refused);
  EXPECT_EQ(live.refused(), 1u);
  EXPECT_FALSE(live.first_refusal().empty());
  ASSERT_EQ(live.results().inputs.size(), 1u);
  EXPECT_EQ(live.results().inputs[0].values, (std::vector<double>{1, 2}));
}

TEST(LiveResults, TakeTheLastRecordOfAPoint) {
  StudyManifest manifest;
  manifest.uncertain = {"target.mass"};
  LiveResults live(manifest);
  const auto record = [](double mass, bool captured) {
    StudyRecord run = {{"captured", captured}, {"used", {{"target.mass", mass}}}, {"metrics", {{"gap", mass / 2}}}};
    for (const char* name : {"peak_force", "impulse"}) run[name] = {{"x", 0}, {"y", 0}, {"z", 0}};
    run["energy_error"] = 0;
    StudyRecord all = {{"refused", ""}, {"settings", StudyRecord::object()}, {"runs", StudyRecord::array()}};
    all["runs"].push_back(run);
    RecordPlace place;
    place.point = 7;
    place.outcome = "done";
    return FollowedRecord{place, all};
  };
  live.add(record(200, true));
  live.add(record(210, false));
  EXPECT_EQ(live.finished(), 1u);
  EXPECT_EQ(live.judged(), 1);
  EXPECT_EQ(live.captured(), 0);
  ASSERT_EQ(live.results().size(), 1u);
  EXPECT_EQ(live.results().find("target.mass")->values[0], 210);
  EXPECT_EQ(live.results().find("gap")->values[0], 105);
}

}  // namespace
}  // namespace netpocket
