// netpocket study --slurm, with programs that stand in for sbatch and squeue. ./dev test-cluster has the real ones.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/gui/program.h"

namespace netpocket {
namespace {

// Runs the tasks of an array at once, except those in the file "lost", and remembers what it was called with. A job
// that waits for another runs at once, too: the other has ended.
constexpr const char* kSbatch = R"sh(#!/bin/sh
cd "$(dirname "$0")"
echo "$@" >> calls
if [ -e refusal ]; then cat refusal >&2; exit 1; fi
number=$(($(cat number 2>/dev/null || echo 6) + 1))
echo $number > number
array= command=
for word; do
  case $word in
    --array=*) array=${word#--array=} ;;
    --wrap=*) command=${word#--wrap=} ;;
  esac
done
for range in $(echo "$array" | tr , ' '); do
  for task in $(seq "${range%-*}" "${range#*-}"); do
    grep -qsx "$task" lost || SLURM_ARRAY_TASK_ID=$task sh -c "$command" >> "log_$task" 2>&1
  done
done
[ -n "$array" ] || sh -c "$command" >> tables_log 2>&1
echo "$number;cluster"
)sh";

// The file "queue" has what it says.
constexpr const char* kSqueue = R"sh(#!/bin/sh
cd "$(dirname "$0")"
echo "$@" >> squeue_calls
if [ -e queue ]; then cat queue; exit 0; fi
echo "slurm_load_jobs error: Invalid job id specified" >&2
exit 1
)sh";

std::string content_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

class SlurmStudy : public testing::Test {
 protected:
  SlurmStudy() {
    std::filesystem::create_directories(folder_.file("bin"));
    for (const auto& [name, text] : {std::pair("bin/sbatch", kSbatch), std::pair("bin/squeue", kSqueue)}) {
      chmod(folder_.write(name, text).c_str(), 0755);
    }
    std::filesystem::copy_file(scenario_file("case1.toml"), folder_.file("base.toml"));
    study_ = folder_.write("a study.toml", R"(base = "base.toml"
samples = 7
[set]
pocket.elements_per_side = 1
pocket.mesh_rows = 2
pocket.mesh_columns = 2
output.end_time = 0.02
[uncertain]
target.mass = { distribution = "normal", mean = 200, deviation = 20 }
)");
  }

  ProgramResult study(std::vector<std::string> more) const {
    std::vector<std::string> words = {"study", study_, "-o", folder_.file("o'ut 50%")};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words, {.environment = {"PATH=" + folder_.file("bin") + ":" + std::getenv("PATH")}});
  }
  ProgramResult status() const {
    return run_program({"study", "--status", folder_.file("o'ut 50%")},
                       {.environment = {"PATH=" + folder_.file("bin") + ":" + std::getenv("PATH")}});
  }
  std::string output(const std::string& name) const { return content_of(folder_.file("o'ut 50%/" + name)); }
  std::string calls() const { return content_of(folder_.file("bin/calls")); }

  TestFolder folder_;
  std::string study_;
};

TEST_F(SlurmStudy, GivesTheTablesOfOneProgram) {
  ASSERT_EQ(run_program({"study", study_, "-o", folder_.file("one"), "--quiet", "--jobs", "1"}).exit_code, 0);
  const auto result = study({"--slurm", "--parts", "3", "--partition", "short", "--time", "10"});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_TRUE(contains(result.out, "submitted 3 of 3 parts as job 7, 7 points are missing; job 8 puts the tables"))
      << result.out;
  EXPECT_TRUE(contains(calls(), "--array=1-3 --partition=short --time=10 ")) << calls();
  EXPECT_TRUE(contains(calls(), "/o'ut 50%%/slurm/part_%a.log")) << calls();
  EXPECT_TRUE(contains(calls(), "--dependency=afterany:7 ")) << calls();
  EXPECT_EQ(output("study.csv"), content_of(folder_.file("one/study.csv")));
  EXPECT_EQ(output("study.json"), content_of(folder_.file("one/study.json")));
  EXPECT_TRUE(contains(status().out, "7 of 7 points done\n3 parts: 3 done, 0 running, 0 waiting, 0 failed\n"));
}

TEST_F(SlurmStudy, SubmitsAgainOnlyWhatIsMissing) {
  folder_.write("bin/lost", "2\n4\n");
  ASSERT_EQ(study({"--slurm", "--parts", "4"}).exit_code, 0);
  std::filesystem::remove(folder_.file("bin/lost"));
  EXPECT_EQ(study({"--slurm"}).exit_code, 5);  // the folder holds the study already
  // Part 2 is still in the queue and part 4 was killed.
  folder_.write("bin/queue", "1 COMPLETED None\n2 PENDING Resources\n3 COMPLETED None\n4 FAILED NonZeroExitCode\n");
  std::filesystem::create_directories(folder_.file("o'ut 50%/slurm"));
  folder_.write("o'ut 50%/slurm/part_4.log", "netpocket: cannot write\n\n");
  const auto before = status();
  EXPECT_TRUE(contains(before.out,
                       "4 of 7 points done\n4 parts: 2 done, 0 running, 1 waiting, 1 failed\n"
                       "part 4: 1 of 1 points missing; FAILED (NonZeroExitCode); netpocket: cannot write\n"))
      << before.out << before.error;
  const auto again = study({"--slurm", "--resume"});
  EXPECT_EQ(again.exit_code, 0) << again.error;
  EXPECT_TRUE(
      contains(again.out, "1 parts with missing points are still in the queue\nsubmitted 1 of 4 parts as job 9"))
      << again.out;
  EXPECT_TRUE(contains(calls(), "--array=4 ")) << calls();
  const auto other = study({"--slurm", "--resume", "--parts", "2"});
  EXPECT_EQ(other.exit_code, 3);
  EXPECT_TRUE(contains(other.error, "tasks of 4 parts are still in the queue")) << other.error;
  std::filesystem::remove(folder_.file("bin/queue"));
  EXPECT_TRUE(contains(status().out, "part 2: 2 of 2 points missing; no longer known to Slurm")) << status().out;
  ASSERT_EQ(study({"--slurm", "--resume"}).exit_code, 0);
  EXPECT_TRUE(contains(study({"--slurm", "--resume"}).out, "no point is missing")) << calls();
  EXPECT_TRUE(contains(output("study.csv"), "\n7,"));
}

TEST_F(SlurmStudy, SaysWhatIsWrong) {
  folder_.write("bin/refusal",
                "sbatch: error: invalid partition specified: nowhere\n"
                "sbatch: error: Batch job submission failed: Invalid partition name specified\n");
  const auto refused = study({"--slurm", "--partition", "nowhere"});
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_TRUE(contains(refused.error, "Slurm does not take the job: ")) << refused.error;
  EXPECT_TRUE(contains(refused.error, "nvalid partition")) << refused.error;

  folder_.write("bin/refusal", "sbatch: error: Batch job submission failed: Unable to contact slurm controller\n");
  EXPECT_EQ(study({"--slurm", "--resume"}).exit_code, 5);

  const auto none = run_program({"study", study_, "-o", folder_.file("other"), "--slurm"}, {.environment = {"PATH=/"}});
  EXPECT_EQ(none.exit_code, 5);
  EXPECT_TRUE(contains(none.error, "there is no sbatch here: this machine is not of a Slurm cluster")) << none.error;

  EXPECT_EQ(study({"--parts", "3"}).exit_code, 2);
  EXPECT_EQ(study({"--slurm", "--part", "1/2"}).exit_code, 2);
  EXPECT_EQ(study({"--slurm", "--jobs", "2"}).exit_code, 2);
  EXPECT_EQ(study({"--slurm", "--parts", "0"}).exit_code, 2);
}

}  // namespace
}  // namespace netpocket
