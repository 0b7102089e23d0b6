// The program on a recording by version 0.1.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/gui/program.h"

namespace netpocket {
namespace {

constexpr const char* kOlder = NETPOCKET_SOURCE_DIR "/tests/recordings/version_0_1.h5";

std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

TEST(OlderRecordings, CanBeDescribedVerifiedAndCompared) {
  const TestFolder folder;
  const auto info = run_program({"info", kOlder});
  EXPECT_EQ(info.exit_code, 0) << info.error;
  EXPECT_NE(info.out.find("netpocket      0.1.0 (ca4457c)"), info.out.npos) << info.out;
  EXPECT_EQ(info.out.find("nan"), info.out.npos) << info.out;
  EXPECT_EQ(run_program({"info", kOlder, "--json"}).exit_code, 0);
  const auto metrics = run_program({"metrics", kOlder});
  EXPECT_EQ(metrics.exit_code, 0) << metrics.error;
  EXPECT_EQ(metrics.out.find("nan"), metrics.out.npos) << metrics.out;
  const auto verified = run_program({"info", kOlder, "--verify"});
  EXPECT_EQ(verified.exit_code, 0) << verified.error;
  const auto findings = run_program({"findings", kOlder, short_recording(folder)});
  EXPECT_EQ(findings.exit_code, 0) << findings.error;
}

TEST(OlderRecordings, CanBeExportedAndPlotted) {
  const TestFolder folder;
  const auto exported = run_program({"export", kOlder, "--csv", folder.file("csv"), "--vtp", folder.file("vtp")});
  EXPECT_EQ(exported.exit_code, 0) << exported.error;
  EXPECT_EQ(content(folder.file("csv/channels.csv")).find("spent_"), std::string::npos);
  // Beside a recording of today, which has what this one lacks.
  const auto plotted =
      run_program({"plot", kOlder, short_recording(folder), "-o", folder.file("figures"), "--format", "svg"});
  EXPECT_EQ(plotted.exit_code, 0) << plotted.error;
  EXPECT_TRUE(std::filesystem::exists(folder.file("figures/energy.svg")));
}

// States belong to the program that wrote them.
TEST(OlderRecordings, AreNotResumedAndStayAsTheyAre) {
  const TestFolder folder;
  const std::string path = folder.file("older.h5"), before = content(kOlder);
  std::filesystem::copy_file(kOlder, path);
  const auto resumed = run_program({"run", "--resume", path, "--quiet"});
  EXPECT_EQ(resumed.exit_code, 3) << resumed.out;
  EXPECT_NE(resumed.error.find("netpocket 0.1.0 (ca4457c) recorded it"), std::string::npos) << resumed.error;
  EXPECT_EQ(content(path), before);
}

}  // namespace
}  // namespace netpocket
