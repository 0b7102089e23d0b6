#include "gui/cluster/slurm.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "gui/cluster/child_process.h"

namespace netpocket {
namespace {

// The last line of a message, which says most; without the program's name and "error:".
std::string last_line(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  text.erase(0, text.rfind('\n') + 1);
  for (const char* prefix : {"sbatch: error: ", "sbatch: ", "slurm_load_jobs error: ", "squeue: error: "}) {
    if (text.starts_with(prefix)) text.erase(0, std::string_view(prefix).size());
  }
  return text.empty() ? "no reason given" : text;
}

ChildResult call(const std::vector<std::string>& words) {
  ChildResult result = run_child(words);
  if (result.is_found) return result;
  throw SlurmError(SlurmError::Kind::unreachable,
                   fmt::format("there is no {} here: this machine is not of a Slurm cluster", words.front()));
}

bool is_unreachable(const std::string& message) {
  constexpr std::array kSigns = {"Unable to contact",   "Connection refused",          "Socket timed out",
                                 "Unable to establish", "Zero Bytes were transmitted", "authentication"};
  return std::ranges::any_of(kSigns, [&](const char* sign) { return message.find(sign) != message.npos; });
}

}  // namespace

std::string array_text(const std::vector<int>& tasks) {
  std::string text;
  for (std::size_t i = 0; i < tasks.size();) {
    std::size_t last = i;
    while (last + 1 < tasks.size() && tasks[last + 1] == tasks[last] + 1) ++last;
    text += text.empty() ? "" : ",";
    text += last == i ? fmt::format("{}", tasks[i]) : fmt::format("{}-{}", tasks[i], tasks[last]);
    i = last + 1;
  }
  return text;
}

std::string submit(const SlurmJob& job) {
  std::vector<std::string> words = {"sbatch",
                                    "--parsable",
                                    "--job-name=" + job.name,
                                    "--output=" + job.log,
                                    "--open-mode=append",
                                    "--ntasks=1",
                                    "--cpus-per-task=1",
                                    "--requeue",
                                    "--signal=B:TERM@30"};
  if (!job.tasks.empty()) words.push_back("--array=" + array_text(job.tasks));
  if (!job.after.empty()) words.push_back("--dependency=afterany:" + job.after);
  if (!job.partition.empty()) words.push_back("--partition=" + job.partition);
  if (!job.time.empty()) words.push_back("--time=" + job.time);
  words.push_back("--wrap=" + job.command);
  const ChildResult result = call(words);
  if (result.exit_code != 0) {
    const auto kind = is_unreachable(result.error) ? SlurmError::Kind::unreachable : SlurmError::Kind::refused;
    throw SlurmError(kind, fmt::format("Slurm does not take the job: {}", last_line(result.error)));
  }
  // "NUMBER" or "NUMBER;CLUSTER".
  const std::string number = result.out.substr(0, result.out.find_first_of(";\n"));
  if (!number.empty() && number.find_first_not_of("0123456789") == number.npos) return number;
  throw SlurmError(SlurmError::Kind::refused, fmt::format("sbatch names no job: {}", last_line(result.out)));
}

bool SlurmTask::is_alive() const {
  constexpr std::array kEnded = {"BOOT_FAIL", "CANCELLED", "COMPLETED", "DEADLINE",      "FAILED",
                                 "NODE_FAIL", "PREEMPTED", "REVOKED",   "OUT_OF_MEMORY", "TIMEOUT"};
  return std::ranges::find(kEnded, state) == kEnded.end();
}

std::vector<SlurmTask> tasks_of(const std::string& job) {
  const ChildResult result =
      call({"squeue", "--noheader", "--array", "--states=all", "--jobs=" + job, "--format=%K %T %r"});
  if (result.exit_code != 0) {
    if (result.error.find("Invalid job id") != result.error.npos) return {};
    throw SlurmError(SlurmError::Kind::unreachable, fmt::format("Slurm does not answer: {}", last_line(result.error)));
  }
  std::vector<SlurmTask> tasks;
  std::istringstream lines(result.out);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    SlurmTask task;
    if (words >> task.task >> task.state && std::getline(words >> std::ws, task.reason)) tasks.push_back(task);
  }
  return tasks;
}

}  // namespace netpocket
