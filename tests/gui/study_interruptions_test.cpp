// A study that is interrupted at random moments, killed or by a full disk, gives the table of one that was not.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <thread>

#include "tests/gui/program.h"

namespace netpocket {
namespace {

std::string whole_text(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

class StudyInterruptions : public testing::Test {
 protected:
  StudyInterruptions() {
    std::filesystem::copy_file(scenario_file("case1.toml"), folder_.file("base.toml"));
    study_ = folder_.write("study.toml", R"(base = "base.toml"
samples = 120
[set]
pocket.elements_per_side = 1
pocket.mesh_rows = 2
pocket.mesh_columns = 2
output.end_time = 0.2
[uncertain]
target.mass = { distribution = "normal", mean = 200, deviation = 20 }
)");
  }

  std::vector<std::string> words(const std::vector<std::string>& more) const {
    std::vector<std::string> all = {"study", study_, "-o", folder_.file("out"), "--quiet"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  std::string records(const std::string& part) const { return folder_.file("out/records/" + part + ".jsonl"); }
  std::size_t size_of(const std::string& part) const {
    std::error_code none;
    const auto size = std::filesystem::file_size(records(part), none);
    return none ? 0 : static_cast<std::size_t>(size);
  }

  // Kills the program some milliseconds after it has finished a point.
  void kill_in(const std::string& part, const std::vector<std::string>& more) {
    ++interruptions_;
    const std::size_t before = size_of(part);
    RunningProgram program(words(more));
    while (size_of(part) == before) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(std::uniform_int_distribution(0, 20)(random_)));
    program.signal(SIGKILL);
    EXPECT_EQ(program.wait().exit_code, 128 + SIGKILL);
  }

  // Lets less than a record fit onto the disk.
  void fill_disk() {
    ++interruptions_;
    const std::size_t room = 1000 + std::uniform_int_distribution<std::size_t>(0, 500)(random_);
    const auto result = run_program(words({"--resume", "--jobs", "1"}),
                                    {.largest_file = std::max<std::size_t>(size_of("1_of_1"), 1000) + room});
    EXPECT_EQ(result.exit_code, 5);
    EXPECT_TRUE(contains(result.error, "cannot write \"" + folder_.file("out"))) << result.error;
  }

  TestFolder folder_;
  std::string study_;
  std::mt19937 random_{20};
  int interruptions_ = 0;
};

TEST_F(StudyInterruptions, TenGiveTheSameTable) {
  ASSERT_EQ(run_program({"study", study_, "-o", folder_.file("one"), "--jobs", "1", "--quiet"}).exit_code, 0);
  for (int i = 0; i < 3; ++i) {
    kill_in("1_of_1", {"--resume", "--jobs", "2"});
    kill_in("1_of_1", {"--resume", "--jobs", "1"});
    fill_disk();
  }
  kill_in("2_of_3", {"--part", "2/3", "--jobs", "1"});
  // Points are left to do. There may be tables of what is done: a full disk leaves them if they fit.
  EXPECT_LT(size_of("1_of_1"), std::filesystem::file_size(folder_.file("one/records/1_of_1.jsonl")));
  ASSERT_EQ(interruptions_, 10);
  EXPECT_EQ(run_program(words({"--resume", "--jobs", "2"})).exit_code, 0);
  for (const char* table : {"study.csv", "study.json", "study_columns.csv", "study_estimates.csv"}) {
    EXPECT_EQ(whole_text(folder_.file(std::string("out/") + table)),
              whole_text(folder_.file(std::string("one/") + table)));
  }
  std::printf("%d interruptions (7 kills, 3 full disks): the tables are those of a study that was not interrupted\n",
              interruptions_);
}

}  // namespace
}  // namespace netpocket
