#pragma once
// Commands that write files, with little to do each, for tests of where the files go.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <sstream>

#include "tests/gui/program.h"

namespace netpocket::test {

using Words = std::vector<std::string>;

inline std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

inline mode_t mode_of(const std::string& path) {
  struct stat status = {};
  EXPECT_EQ(stat(path.c_str(), &status), 0) << path;
  return status.st_mode & 07777;
}

// Exactly one sentence, which holds all the parts.
inline void expect_sentence(const ProgramResult& result, int exit_code, const Words& parts) {
  EXPECT_EQ(result.exit_code, exit_code) << result.error;
  EXPECT_TRUE(result.error.starts_with("netpocket: ")) << result.error;
  EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << result.error;
  for (const std::string& part : parts)
    EXPECT_TRUE(contains(result.error, part)) << part << " is not in " << result.error;
}

// A run of a coarse pocket.
inline Words run_words(const std::string& output, const std::string& until = "0.1") {
  return {"run",   scenario_file("case1.toml"), "-o",      output,    "--set", "pocket.mesh_columns=2",
          "--set", "pocket.mesh_rows=2",        "--quiet", "--until", until};
}

inline Words operator+(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// Tests with a folder and a short recording in it.
class OutputTest : public testing::Test {
 protected:
  OutputTest() {
    const auto result = run_program(run_words(recording_));
    EXPECT_EQ(result.exit_code, 0) << result.error;
  }

  // One for each way to write a file that the user names; they write `path`.
  Words sheet(const std::string& path) const {
    return {"render", recording_, "--sheet", path, "--times", "0", "--panel-size", "64x64", "--quiet"};
  }
  Words video(const std::string& path) const {
    return {"render", recording_, "--video", path, "--fps", "20", "--size", "64x64", "--quiet"};
  }
  Words gltf(const std::string& path) const { return {"render", recording_, "--gltf", path, "--times", "0"}; }
  Words view(const std::string& path) const { return {"render", recording_, "--save-view", path}; }
  Words report(const std::string& path) const { return {"report", recording_, "-o", path, "--no-video", "--quiet"}; }

  TestFolder folder_;
  std::string recording_ = folder_.file("run.h5");
};

}  // namespace netpocket::test
