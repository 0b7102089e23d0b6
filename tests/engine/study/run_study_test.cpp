// Studies of the real engine, on a coarse pocket over a few hundredths of a second.
#include "engine/study/run_study.h"

#include <gtest/gtest.h>
#include <time.h>

#include <chrono>

#include "engine/study/record_files.h"
#include "engine/study/study_folder.h"
#include "engine/study/study_status.h"
#include "engine/study/study_table.h"
#include "tests/engine/bodies/mesh_samples.h"
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
  const auto outcome = run_study(study, folder.file("out"), {.jobs = 2}, [&](const StudyProgress& p) {
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
  const std::string csv = folder.text("out/study.csv");
  EXPECT_EQ(lines(csv), 6u) << csv;  // names, two runs, one refusal, two runs
  EXPECT_TRUE(csv.starts_with("point,place,draw,target.radius,variant,refused,ended,captured,first_contact_s,")) << csv;
  EXPECT_NE(csv.find("\n3,,0,4.4,fast,,finished,not known,"), std::string::npos) << csv;
  const auto json = nlohmann::json::parse(folder.text("out/study.json"));
  EXPECT_EQ(json["points"].size(), 3u);
  EXPECT_EQ(json["rules"].size(), 11u);
  EXPECT_FALSE(std::filesystem::exists(folder.file("out/runs")));
}

// As if stopped at once.
void begin(const Study& study, const StudyFolder& folder) {
  std::stop_source stop;
  stop.request_stop();
  run_study(study, folder.file("out"), {}, {}, stop.get_token());
}

// Times and effort apart, what a study finds does not depend on how it is run.
TEST(RunStudy, ResultsDoNotDependOnTheNumberOfJobs) {
  const auto results = [](int jobs) {
    const StudyFolder folder;
    auto outcome = run_study(coarse_study(folder), folder.file("out"), {.jobs = jobs});
    for (StudyRecord& record : outcome.records) {
      record.erase("timings");
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
  const auto stopped = run_study(study, folder.file("out"), {.jobs = 1}, until_first, stop.get_token());
  EXPECT_TRUE(stopped.stopped);
  EXPECT_EQ(stopped.records.size(), 2u);
  EXPECT_EQ(lines(folder.text("out/study.csv")), 4u);

  const auto resumed = run_study(study, folder.file("out"), {.jobs = 1, .resume = true});
  EXPECT_EQ(resumed.runs_made, 2u);  // both variants of the third point
  EXPECT_FALSE(resumed.stopped);
  EXPECT_EQ(resumed.records[0], stopped.records[0]);
  EXPECT_EQ(lines(folder.text("out/study.csv")), 6u);
}

TEST(RunStudy, ResumeDoesNotKeepPointsOfOtherScenariosOrPrograms) {
  const StudyFolder folder;
  Study study = coarse_study(folder);
  run_study(study, folder.file("out"), {.version = "1"});
  const auto kept = [&](const Study& now, const std::string& version) {
    std::stop_source stop;
    stop.request_stop();
    const StudyOptions options = {.resume = true, .version = version};
    return run_study(now, folder.file("out"), options, {}, stop.get_token()).points_done;
  };
  EXPECT_EQ(kept(study, "1"), 3u);
  EXPECT_EQ(kept(study, "2"), 0u);
  study.base.target.mass = 300;
  EXPECT_EQ(kept(study, "1"), 0u);
}

TEST(RunStudy, SaysWhenItCannotWrite) {
  const StudyFolder folder;
  const Study study = coarse_study(folder);
  begin(study, folder);
  folder.write("out/runs", "not a folder");
  EXPECT_THROW(run_study(study, folder.file("out"), {.resume = true}), FileError);
}

std::string refusal(const Study& study, const std::string& folder) {
  try {
    run_study(study, folder, {.resume = true});
  } catch (const RecordingError& error) {
    return error.what();
  }
  return "";
}

TEST(RunStudy, FoldersOfOthersAreRefusedAndLeftAlone) {
  const StudyFolder folder;
  const Study study = coarse_study(folder);
  std::filesystem::create_directories(folder.file("mine/runs"));
  folder.write("mine/runs/thesis.h5", "years of work");
  EXPECT_EQ(refusal(study, folder.file("mine")),
            "\"" + folder.file("mine") +
                "\" holds something that is not of a study (\"runs\"): name a new or an empty folder");
  EXPECT_EQ(folder.text("mine/runs/thesis.h5"), "years of work");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.file("mine")), {}), 1);
}

TEST(RunStudy, AFolderHoldsOneStudy) {
  const StudyFolder folder;
  Study study = coarse_study(folder);
  begin(study, folder);
  study.name = "other";
  EXPECT_EQ(refusal(study, folder.file("out")),
            "\"" + folder.file("out") + "\" holds the study \"study\", not \"other\": name another folder");
  folder.write("out/netpocket_study.json", "{}");
  EXPECT_NE(refusal(study, folder.file("out")).find("is not the mark of a study"), std::string::npos);
}

TEST(RunStudy, OneProgramAtATimeHoldsAFolder) {
  const StudyFolder folder;
  const Study study = coarse_study(folder);
  const OwnedStudyFolder held(folder.file("out"), study.name);
  EXPECT_EQ(refusal(study, folder.file("out")), "another program is running a study in \"" + folder.file("out") + "\"");
}

TEST(RunStudy, RemovesOnlyRecordingsThatItMadeItself) {
  const StudyFolder folder;
  Study study = coarse_study(folder);
  study.keep_recordings = true;
  run_study(study, folder.file("out"), {});
  folder.write("out/runs/mine.txt", "a note");
  // Kept ones and those of others stay, also when recordings are not to be kept any more.
  study.keep_recordings = false;
  study.axes[0].values.push_back("4.2");
  run_study(study, folder.file("out"), {.resume = true});
  for (const char* file : {"0001_slow.h5", "0001_fast.h5", "0003_slow.h5", "mine.txt"}) {
    EXPECT_TRUE(std::filesystem::exists(folder.file(std::string("out/runs/") + file))) << file;
  }
  EXPECT_FALSE(std::filesystem::exists(folder.file("out/runs/0004_slow.h5")));
}

// Each run's processor time is its own, however many run beside it.
// A limit of steps is the same everywhere, unlike one of time.
TEST(RunStudy, ARunEndsAtItsLimitOfSteps) {
  const StudyFolder folder;
  const std::string settings =
      "pocket.elements_per_side = 1\npocket.mesh_rows = 2\npocket.mesh_columns = 2\noutput.end_time = 0.1\n";
  const Study study = folder
                          .read("samples = 6\n[set]\n" + settings +
                                "[uncertain]\nsolver.most_steps = { distribution = \"discrete\", values = "
                                "[40, 1000000] }\n")
                          .study;
  const StudyOutcome outcome = run_study(study, folder.file("out"), {.jobs = 1});
  EXPECT_GT(outcome.limited, 0u);
  EXPECT_LT(outcome.limited, 6u);
  EXPECT_EQ(outcome.diverged, 0u);
  std::size_t limited = 0;
  RecordReader reader;
  scan_records(folder.file("out"), [&](const RecordPlace& place) {
    const StudyRecord run = reader.read(place)["runs"][0];
    const bool is_limited = place.outcome == "limited";
    limited += is_limited ? 1 : 0;
    EXPECT_EQ(run["reason"], is_limited ? "limited" : "finished");
    EXPECT_EQ(run["steps"] == 40, is_limited);
    EXPECT_TRUE(run["captured"].is_null());
  });
  EXPECT_EQ(limited, outcome.limited);
  ASSERT_EQ(outcome.estimates.size(), 1u);
  EXPECT_EQ(outcome.estimates[0].tally.judged, 0);
  const StudyStatus status = study_status(folder.file("out"));
  EXPECT_EQ(status.limited, limited);
  ASSERT_EQ(status.failures.size(), limited);
  EXPECT_NE(status.failures[0].reason.find("limit of 40 steps (solver.most_steps)"), std::string::npos);
  run_study(study, folder.file("parts"), {.jobs = 2, .resume = true, .part = {2, 2}});
  run_study(study, folder.file("parts"), {.jobs = 2, .resume = true, .part = {1, 2}});
  EXPECT_EQ(folder.text("out/study.csv"), folder.text("parts/study.csv"));
  EXPECT_EQ(run_study(study, folder.file("out"), {.resume = true}).runs_made, 0u);
}

TEST(RunStudy, ProcessorTimeIsThatOfTheRun) {
  const StudyFolder folder;
  Study study = coarse_study(folder);
  study.base.output.end_time = 20;
  study.settings.pop_back();
  timespec before{}, after{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &before);
  const auto outcome = run_study(study, folder.file("out"), {.jobs = 4});
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &after);
  const double all =
      static_cast<double>(after.tv_sec - before.tv_sec) + 1e-9 * static_cast<double>(after.tv_nsec - before.tv_nsec);
  double sum = 0;
  for (const StudyRecord& record : outcome.records) {
    for (const auto& timing : record["timings"]) sum += timing["cpu_seconds"].get<double>();
  }
  EXPECT_GT(sum, 0);
  EXPECT_LE(sum, all);
}

TEST(RunStudy, APointDependsOnItsMesh) {
  const StudyFolder folder;
  const auto write_box = [&](double size) {
    samples::write_file(folder.file("box.obj"), samples::obj(samples::box({size, size, size})));
  };
  write_box(3);
  Scenario scenario;
  scenario.files.folder = folder.file("");
  scenario.target.shape = TargetShape::mesh;
  scenario.target.mesh_file = "box.obj";
  const std::string first = point_identity({scenario}, "1");
  EXPECT_EQ(point_identity({scenario}, "1"), first);
  write_box(3.5);
  std::filesystem::last_write_time(folder.file("box.obj"),
                                   std::filesystem::file_time_type::clock::now() + std::chrono::seconds(2));
  EXPECT_NE(point_identity({scenario}, "1"), first);
}

TEST(StudyTable, ARowIsALine) {
  const StudyFolder folder;
  Study study = coarse_study(folder);
  const StudyPoint point{"a \"place\"\nof two lines", {{"target.radius", "4"}}, 0};
  const std::string csv = study_csv(study, {refused_record(0, point, "x", "one, two\r\nthree")});
  EXPECT_EQ(lines(csv), 2u);
  EXPECT_NE(csv.find("\n1,\"a \"\"place\"\"\\nof two lines\",0,4,,\"one, two\\r\\nthree\","), std::string::npos) << csv;
}

}  // namespace
}  // namespace netpocket
