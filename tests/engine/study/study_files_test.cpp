// The studies that come with the program, and the document they write.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "engine/study/findings_report.h"
#include "engine/study/read_study.h"

namespace netpocket {
namespace {

const std::filesystem::path kScenarios = NETPOCKET_SOURCE_DIR "/scenarios";

std::string content(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(StudyFiles, AreValidAndCompareThePapersClosingTimes) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kScenarios / "studies")) {
    if (entry.path().extension() != ".toml") continue;
    ++count;
    const StudyResult result = read_study_file(entry.path().string());
    ASSERT_TRUE(result.ok()) << result.diagnostics.text();
    EXPECT_FALSE(result.study.description.empty()) << entry.path();
    if (!result.study.has_findings) continue;  // a campaign compares no closing times
    ASSERT_EQ(result.study.variants.size(), 3u) << entry.path();
    for (const auto& [variant, duration] : {std::pair(0, 10.0), std::pair(1, 7.5), std::pair(2, 5.0)}) {
      Scenario scenario;
      ASSERT_TRUE(apply_settings(scenario, result.study.variants[variant].settings).ok());
      EXPECT_EQ(scenario.closing.duration, duration) << entry.path();
    }
  }
  EXPECT_GE(count, 6);
}

// The point that is judged must be one that can be run.
TEST(StudyFiles, JudgedPointIsValid) {
  const StudyResult result = read_study_file((kScenarios / "studies/findings.toml").string());
  ASSERT_TRUE(result.ok());
  const auto points = study_points(result.study);
  for (const NamedSettings& variant : result.study.variants) {
    const StudyScenario made = study_scenario(result.study, points.front(), variant);
    EXPECT_TRUE(made.diagnostics.ok()) << made.diagnostics.text();
  }
}

// A document of several studies, and the command that makes it.
struct StudyDocument {
  const char *file, *command;
  std::vector<std::string> studies;
};
const StudyDocument kDocuments[] = {
    {"CONTROL_FINDINGS.md",
     "./dev control",
     {"control_at_impact", "control_gains", "control_rods", "held_spacecraft", "deflation"}},
    {"THROWN_FINDINGS.md", "./dev thrown-net", {"thrown_net_deployment", "thrown_net_capture", "thrown_net_spin"}}};

TEST(StudyFiles, EveryPointOfADocumentIsValid) {
  for (const StudyDocument& document : kDocuments) {
    for (const std::string& name : document.studies) {
      const StudyResult result = read_study_file((kScenarios / "studies" / (name + ".toml")).string());
      ASSERT_TRUE(result.ok()) << result.diagnostics.text();
      for (const StudyPoint& point : study_points(result.study)) {
        for (const NamedSettings& variant : result.study.variants) {
          const StudyScenario made = study_scenario(result.study, point, variant);
          EXPECT_TRUE(made.diagnostics.ok()) << name << ", " << point.place << ": " << made.diagnostics.text();
        }
      }
    }
  }
}

// The documents are of the scenarios as they are.
TEST(StudyFiles, DocumentsJudgeThem) {
  for (const StudyDocument& document : kDocuments) {
    const std::string findings = content(kScenarios / document.file);
    for (const std::string& name : document.studies) {
      const StudyResult result = read_study_file((kScenarios / "studies" / (name + ".toml")).string());
      EXPECT_NE(findings.find("netpocket study " + name + ".toml --report`; scenarios " + study_identity(result.study)),
                findings.npos)
          << name << ": make it anew with " << document.command;
    }
  }
}

TEST(StudyFiles, FindingsAreJudgedInTheDocument) {
  const std::string findings = content(kScenarios / "FINDINGS.md");
  EXPECT_NE(findings.find("netpocket study findings.toml"), findings.npos);
  for (int i = 1; i <= 11; ++i) EXPECT_NE(findings.find("### F" + std::to_string(i) + " "), findings.npos) << i;
}

}  // namespace
}  // namespace netpocket
