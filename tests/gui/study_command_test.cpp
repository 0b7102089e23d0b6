// netpocket study, with the real engine.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "tests/gui/program.h"

namespace netpocket {
namespace {

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

// A coarse pocket; `rest` adds to it.
std::string write_study(const TestFolder& folder, double end_time, const std::string& rest) {
  std::ostringstream text;
  const auto base = std::filesystem::relative(scenario_file("case1.toml"), folder.file(""));
  text << "base = " << base << "\n[set]\npocket.elements_per_side = 1\n"
       << "pocket.mesh_rows = 2\npocket.mesh_columns = 2\noutput.end_time = " << end_time << "\n"
       << rest;
  return folder.write("study.toml", text.str());
}

TEST(Study, TabulatesItsPoints) {
  const TestFolder folder;
  const std::string study = write_study(
      folder, 0.04, "[vary]\ntarget.radius = [4.0, 4.1, 9.0]\n[[variant]]\nname = \"fast\"\nclosing.duration = 5\n");
  const auto result = run_program({"study", study, "-o", folder.file("out"), "--jobs", "2"});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_TRUE(contains(result.out, "3 of 3 points done, 1 of them refused as not valid")) << result.out;
  EXPECT_TRUE(contains(result.error, "100 %")) << result.error;
  EXPECT_TRUE(contains(text_of(folder.file("out/study.csv")), "\n2,,0,4.1,fast,,finished,"));
  EXPECT_TRUE(contains(text_of(folder.file("out/study.csv")), "the target starts inside the net"));
  const auto json = nlohmann::json::parse(text_of(folder.file("out/study.json")));
  EXPECT_EQ(json["points"][1]["runs"][0]["variant"], "fast");
}

TEST(Study, DoesNotMixStudiesUnlessToldToResume) {
  const TestFolder folder;
  const std::string study = write_study(folder, 0.02, "");
  const std::vector<std::string> arguments = {"study", study, "-o", folder.file("out"), "--quiet"};
  EXPECT_EQ(run_program(arguments).exit_code, 0);
  const auto again = run_program(arguments);
  EXPECT_EQ(again.exit_code, 5);
  EXPECT_TRUE(contains(again.error, "holds a study already; --resume goes on with it")) << again.error;
  const auto resumed = run_program({"study", study, "-o", folder.file("out"), "--resume", "--quiet"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.error;
  EXPECT_EQ(resumed.out + resumed.error, "");
}

TEST(Study, FilesOfOthersStay) {
  const TestFolder folder;
  const std::string study = write_study(folder, 0.02, "");
  std::filesystem::create_directory(folder.file("runs"));
  folder.write("runs/mine.h5", "years of work");
  const auto result = run_program({"study", study, "-o", folder.file("")});
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_TRUE(contains(result.error, "holds something that is not of a study")) << result.error;
  EXPECT_EQ(text_of(folder.file("runs/mine.h5")), "years of work");
}

TEST(Study, OneAtATimeInAFolder) {
  const TestFolder folder;
  const std::string study = write_study(folder, 19000, "");  // hours
  RunningProgram first({"study", study, "-o", folder.file("out"), "--jobs", "1", "--quiet"});
  while (!std::filesystem::exists(folder.file("out/runs"))) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const auto second = run_program({"study", study, "-o", folder.file("out"), "--resume"});
  EXPECT_EQ(second.exit_code, 5);
  EXPECT_TRUE(contains(second.error, "another program is running a study in")) << second.error;
  first.signal(SIGINT);
  EXPECT_EQ(first.wait().exit_code, 130);
}

TEST(Study, WithoutAValidPointIsBadInput) {
  const TestFolder folder;
  const std::string study = write_study(folder, 0.02, "[vary]\ntarget.radius = [8.0, 9.0]\n");
  const auto result = run_program({"study", study, "-o", folder.file("out"), "--quiet"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_TRUE(contains(result.error, "none of the 2 points makes a valid scenario; the first: ")) << result.error;
  EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << result.error;
}

TEST(Study, SaysWhereTheFileIsWrong) {
  const TestFolder folder;
  const std::string study = write_study(folder, 0.02, "[vary]\ntarget.radios = [4]\n");
  const auto result = run_program({"study", study, "-o", folder.file("out")});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_TRUE(contains(result.error, "study.toml:8: \"target.radios\" is not a parameter; did you mean"))
      << result.error;
  EXPECT_FALSE(std::filesystem::exists(folder.file("out")));
}

TEST(Study, InterruptedItKeepsWhatIsDoneAndGoesOn) {
  const TestFolder folder;
  // The second point would take hours.
  const std::string study = write_study(folder, 0.02, "[vary]\noutput.end_time = [0.02, 19000]\n");
  RunningProgram program({"study", study, "-o", folder.file("out"), "--jobs", "1"});
  while (text_of(folder.file("out/records/1_of_1.jsonl")).empty()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  program.signal(SIGINT);
  const auto result = program.wait();
  EXPECT_EQ(result.exit_code, 130);
  EXPECT_TRUE(contains(result.out, "1 of 2 points done")) << result.out;
  EXPECT_TRUE(contains(result.error, "--resume goes on")) << result.error;
  EXPECT_TRUE(contains(text_of(folder.file("out/study.csv")), "\n1,,0,0.02,"));
  EXPECT_FALSE(std::filesystem::exists(folder.file("out/runs")));
}

TEST(Study, WritesAReport) {
  const TestFolder folder;
  const std::string study = write_study(
      folder, 0.04, "[[point]]\nname = \"default\"\n[[point]]\nname = \"half step\"\nsolver.safety = 0.4\n");
  const auto result =
      run_program({"study", study, "-o", folder.file("out"), "--report", folder.file("F.md"), "--quiet"});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  const std::string report = text_of(folder.file("F.md"));
  EXPECT_TRUE(contains(report, "| F11 | The target stays captured. | not known | 0 of 1 other points |")) << report;
  EXPECT_TRUE(contains(report, "`solver.safety = 0.4`")) << report;
}

constexpr const char* kUncertainMass = R"(
[uncertain]
target.mass = { distribution = "normal", mean = 200, deviation = 20 }
"target.velocity[1]" = { distribution = "uniform", min = -0.2, max = 0.2 }
[until]
half_width = 0.3
)";

// `keys` come before the tables.
std::string write_campaign(const TestFolder& folder, const std::string& keys, std::string rest) {
  const std::string study = write_study(folder, 0.02, rest);
  return folder.write("campaign.toml", keys + text_of(study));
}

TEST(Study, CampaignEndsWithAnEstimateAndIsDrawn) {
  const TestFolder folder;
  const std::string study = write_campaign(folder, "samples = 6\n", kUncertainMass);
  const auto result = run_program({"study", study, "-o", folder.file("out"), "--report", folder.file("C.md")});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  // The runs end before anything is closed.
  EXPECT_TRUE(contains(result.out, "probability of capture: not known, 0 of 0 captures, 6 more not judged"))
      << result.out;
  EXPECT_TRUE(contains(result.out, "6 captures in ")) << result.out;
  EXPECT_TRUE(contains(text_of(folder.file("C.md")), "| `target.mass` | kg |")) << text_of(folder.file("C.md"));
  EXPECT_TRUE(contains(text_of(folder.file("out/study_estimates.csv")), "probability_wilson"));
  const auto plotted = run_program({"plot", folder.file("out"), "-o", folder.file("figures"), "--format", "svg"});
  EXPECT_EQ(plotted.exit_code, 0) << plotted.error;
  EXPECT_TRUE(std::filesystem::exists(folder.file("figures/capture_map.svg")));
}

constexpr const char* kFiveDraws = R"(
target.radius = 3
closing.duration = 0.8
towing.mode = "none"
[uncertain]
target.mass = { distribution = "normal", mean = 200, deviation = 20 }
"target.position[0]" = { distribution = "uniform", min = -0.2, max = 0.2 }
)";

std::string write_campaign(const TestFolder& folder) {
  const std::string study = write_study(folder, 2, kFiveDraws);
  const std::string text = "sampling = \"sobol\"\nsamples = 5\n" + text_of(study);
  return folder.write("study.toml", text);
}

// The captures are run again from what the folder says: the study's file is gone by then.
TEST(Study, ItsWorstCapturesAreDrawnAgain) {
  const TestFolder folder;
  const std::string study = write_campaign(folder);
  ASSERT_EQ(run_program({"study", study, "-o", folder.file("out"), "--quiet"}).exit_code, 0);
  std::filesystem::remove(study);
  const auto drawn = run_program(
      {"plot", folder.file("out"), "--sheet", folder.file("worst.png"), "--by", "relative_speed_start", "--largest"});
  EXPECT_EQ(drawn.exit_code, 0) << drawn.error;
  EXPECT_TRUE(contains(text_of(folder.file("worst.png")).substr(0, 4), "PNG"));
  EXPECT_GT(std::filesystem::file_size(folder.file("worst.png")), 100000u);
  EXPECT_FALSE(std::filesystem::exists(folder.file("out/runs")));
  const auto misspelt =
      run_program({"plot", folder.file("out"), "--sheet", folder.file("w.png"), "--by", "escape_deth"});
  EXPECT_EQ(misspelt.exit_code, 3);
  EXPECT_TRUE(contains(misspelt.error, "has no column \"escape_deth\"")) << misspelt.error;
  EXPECT_TRUE(contains(misspelt.error, "did you mean \"escape_depth\"?")) << misspelt.error;
  const auto homeless = run_program({"plot", folder.file("out")});
  EXPECT_EQ(homeless.exit_code, 2);
  EXPECT_TRUE(contains(homeless.error, "--output is required")) << homeless.error;
}

TEST(Study, HasAPageOfItsOwn) {
  const TestFolder folder;
  ASSERT_EQ(run_program({"study", write_campaign(folder), "-o", folder.file("out"), "--quiet"}).exit_code, 0);
  const auto result = run_program({"report", folder.file("out"), "-o", folder.file("page.html"), "--quiet"});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  const std::string page = text_of(folder.file("page.html"));
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
  EXPECT_TRUE(page.ends_with("</html>\n"));
  const auto begin = page.find("application/json\">") + 18;
  const auto data = nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  EXPECT_EQ(data["points"].size(), 5u);
  EXPECT_EQ(data["inputs"].size(), 2u);
  EXPECT_EQ(data["inputs"][0][1], "kg");
  ASSERT_EQ(data["pictures"].size(), 5u) << "all of so few are among the worst";
  for (const auto& [row, id] : data["pictures"].items()) {
    EXPECT_TRUE(contains(page, "id=\"" + id.get<std::string>() + "\"")) << row;
  }
  EXPECT_TRUE(contains(page, "data:image/png;base64,"));
}

TEST(Study, PartsRunIntoOneFolder) {
  const TestFolder folder;
  std::string rest = kUncertainMass;
  const std::string study = write_campaign(folder, "samples = 5\n", rest.substr(0, rest.find("[until]")));
  EXPECT_EQ(run_program({"study", study, "-o", folder.file("one"), "--quiet"}).exit_code, 0);
  const auto part = [&](const std::string& name) {
    return run_program({"study", study, "-o", folder.file("out"), "--part", name, "--jobs", "1"});
  };
  const auto second = part("2/2");
  EXPECT_EQ(second.exit_code, 0) << second.error;
  EXPECT_FALSE(std::filesystem::exists(folder.file("out/study.csv")));
  const auto status = run_program({"study", "--status", folder.file("out")});
  EXPECT_EQ(status.out, "campaign: 2 of 5 points done\n") << status.error;
  EXPECT_EQ(part("1/2").exit_code, 0);
  EXPECT_EQ(text_of(folder.file("out/study.csv")), text_of(folder.file("one/study.csv")));
  EXPECT_EQ(run_program({"study", study, "-o", folder.file("out"), "--merge", "--quiet"}).exit_code, 0);
  for (const char* wrong : {"3/2", "0/2", "2", "1/2x"}) {
    const auto refused = part(wrong);
    EXPECT_EQ(refused.exit_code, 2) << wrong;
    EXPECT_TRUE(contains(refused.error, "expects PART/PARTS")) << refused.error;
  }
}

TEST(Study, NeedsAStudyAndAFolder) {
  EXPECT_EQ(run_program({"study"}).exit_code, 2);
  EXPECT_EQ(run_program({"study", "a.toml"}).exit_code, 2);
  const TestFolder folder;
  const auto nothing = run_program({"study", "--status", folder.file("")});
  EXPECT_EQ(nothing.exit_code, 3);
  EXPECT_TRUE(contains(nothing.error, "holds no study")) << nothing.error;
}

}  // namespace
}  // namespace netpocket
