// Studies of the real engine, on a coarse pocket over a few hundredths of a second.
#include "engine/study/run_study.h"

#include <gtest/gtest.h>

#include "tests/engine/study/study_folder.h"

namespace netpocket {
namespace {

constexpr const char* kStudy = R"(
[set]
pocket.elements_per_side = 1
pocket.mesh_rows = 2
pocket.mesh_columns = 2
output.end_time = 0.1
[vary]
target.radius = [4.0, 7.0, 4.4]
[[variant]]
name = "slow"
closing.duration = 10
[[variant]]
name = "fast"
closing.duration = 5
)";

Study coarse_study(const StudyFolder& folder) {
  StudyResult result = folder.read(kStudy);
  EXPECT_TRUE(result.ok()) << result.diagnostics.text();
  return std::move(result.study);
}

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(RunStudy, RunsEveryValidPointAndSaysWhyOthersAreNot) {
  const StudyFolder folder;
  const Study study = coarse_study(folder);
  double fraction = 0;
  const auto outcome = run_study(study, folder.file(""), {.jobs = 2}, [&](const StudyProgress& p) {
    EXPECT_GE(p.fraction, fraction - 1e-9);
    fraction = p.fraction;
  });
  EXPECT_NEAR(fraction, 1, 1e-9);
  EXPECT_FALSE(outcome.stopped);
  ASSERT_EQ(outcome.records.size(), 3u);
  EXPECT_NE(outcome.records[1]["refused"].get<std::string>().find("target.position: the target starts inside"),
            std::string::npos);
  EXPECT_TRUE(outcome.records[1]["runs"].empty());
  for (const std::size_t i : {0u, 2u}) {
    const StudyRecord& record = outcome.records[i];
    EXPECT_EQ(record["refused"], "");
    ASSERT_EQ(record["runs"].size(), 2u);
    EXPECT_EQ(record["runs"][1]["variant"], "fast");
    EXPECT_EQ(record["runs"][1]["reason"], "finished");
    EXPECT_EQ(record["findings"].size(), 11u);
  }
  const std::string csv = folder.text("study.csv");
  EXPECT_EQ(lines(csv), 6u) << csv;  // names, two runs, one refusal, two runs
  EXPECT_TRUE(csv.starts_with("point,place,draw,target.radius,variant,refused,ended,captured,first_contact_s,")) << csv;
  EXPECT_NE(csv.find("\n3,,0,4.4,fast,,finished,not known,"), std::string::npos) << csv;
  const auto json = nlohmann::json::parse(folder.text("study.json"));
  EXPECT_EQ(json["points"].size(), 3u);
  EXPECT_EQ(json["rules"].size(), 11u);
  EXPECT_FALSE(std::filesystem::exists(folder.file("runs")));
}

// Times and effort apart, what a study finds does not depend on how it is run.
TEST(RunStudy, ResultsDoNotDependOnTheNumberOfJobs) {
  const auto results = [](int jobs) {
    const StudyFolder folder;
    auto outcome = run_study(coarse_study(folder), folder.file(""), {.jobs = jobs});
    for (StudyRecord& record : outcome.records) {
      for (auto& run : record["runs"]) {
        run.erase("wall_seconds");
        run.erase("cpu_seconds");
      }
    }
    return outcome.records;
  };
  EXPECT_EQ(results(1), results(3));
}

TEST(RunStudy, StoppedItKeepsWhatIsDoneAndGoesOn) {
  const StudyFolder folder;
  const Study study = coarse_study(folder);
  std::stop_source stop;
  const auto until_first = [&](const StudyProgress& p) {
    if (p.points_done == 2) stop.request_stop();  // the refused one and the first
  };
  const auto stopped = run_study(study, folder.file(""), {.jobs = 1}, until_first, stop.get_token());
  EXPECT_TRUE(stopped.stopped);
  EXPECT_EQ(stopped.records.size(), 2u);
  EXPECT_EQ(lines(folder.text("study.csv")), 4u);

  std::size_t kept = 0;
  const auto resumed = run_study(study, folder.file(""), {.jobs = 1, .resume = true}, [&](const StudyProgress& p) {
    if (kept == 0) kept = p.points_done;
  });
  EXPECT_EQ(kept, 2u);
  EXPECT_FALSE(resumed.stopped);
  EXPECT_EQ(resumed.records[0], stopped.records[0]);
  EXPECT_EQ(lines(folder.text("study.csv")), 6u);
}

TEST(RunStudy, ResumeDoesNotKeepPointsOfOtherScenariosOrPrograms) {
  const StudyFolder folder;
  Study study = coarse_study(folder);
  run_study(study, folder.file(""), {.version = "1"});
  const auto kept = [&](const Study& now, const std::string& version) {
    std::size_t done = 0;
    bool first = true;
    std::stop_source stop;
    stop.request_stop();
    const auto look = [&](const StudyProgress& p) {
      if (std::exchange(first, false)) done = p.points_done;
    };
    run_study(now, folder.file(""), {.resume = true, .version = version}, look, stop.get_token());
    return done;
  };
  EXPECT_EQ(kept(study, "1"), 3u);
  EXPECT_EQ(kept(study, "2"), 1u);  // the refused one
  study.base.target.mass = 300;
  EXPECT_EQ(kept(study, "1"), 1u);
}

TEST(RunStudy, SaysWhenItCannotWrite) {
  const StudyFolder folder;
  const Study study = coarse_study(folder);
  folder.write("runs", "not a folder");
  EXPECT_THROW(run_study(study, folder.file(""), {}), RecordingError);
}

}  // namespace
}  // namespace netpocket
