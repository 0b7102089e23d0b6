#include "gui/cluster/slurm_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/base/folder.h"
#include "engine/base/whole_file.h"
#include "engine/study/found_records.h"
#include "engine/study/study_folder.h"
#include "engine/study/study_manifest.h"
#include "engine/study/study_plan.h"
#include "gui/cluster/slurm.h"

namespace netpocket {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kPointsOfPart = 20;
constexpr int kMostParts = 1000;  // largest number of a task where MaxArraySize is Slurm's default, 1001

// What slurm.json holds.
struct Submitted {
  int parts = 0;                     // 0: nothing was submitted
  std::map<int, std::string> tasks;  // by part, the array job that has it last
};

std::string state_path(const std::string& folder) { return folder + "/slurm.json"; }

Submitted read_state(const std::string& folder) {
  Submitted state;
  std::ifstream file(state_path(folder));
  if (!file) return state;
  const Json json = Json::parse(file, nullptr, false);
  try {
    state.parts = json.at("parts").get<int>();
    for (const auto& [part, job] : json.at("tasks").items()) state.tasks[std::stoi(part)] = job.get<std::string>();
  } catch (const std::exception&) {
    throw FileError(fmt::format("\"{}\" is damaged", state_path(folder)));
  }
  return state;
}

void write_state(const std::string& folder, const Submitted& state, const SlurmSubmission& submission) {
  Json tasks = Json::object();
  for (const auto& [part, job] : state.tasks) tasks[std::to_string(part)] = job;
  const Json json = {{"parts", state.parts}, {"collector", submission.collector}, {"tasks", tasks}};
  write_whole_file(state_path(folder), FileKind::json, json.dump(1) + "\n");
}

// As one word of a shell.
std::string shell_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

// In a name of a log, "%" begins what Slurm replaces.
std::string without_patterns(const std::string& path) {
  std::string text;
  for (const char c : path) text += c == '%' ? std::string("%%") : std::string(1, c);
  return text;
}

std::string absolute(const std::string& path) { return fs::absolute(path).lexically_normal().string(); }

// `exec`: signals of Slurm reach the program.
std::string command(const SlurmChoice& choice, const std::string& options) {
  return fmt::format("exec {} study {} -o {} --quiet {}", shell_word(absolute(choice.program)),
                     shell_word(absolute(choice.study)), shell_word(absolute(choice.folder)), options);
}

int chosen_parts(const SlurmChoice& choice, int before, std::size_t points) {
  const int all = static_cast<int>(points);
  if (choice.parts > 0) return std::min(choice.parts, all);
  if (before > 0) return before;
  return std::clamp((all + kPointsOfPart - 1) / kPointsOfPart, 1, kMostParts);
}

// Tasks by part, of all jobs that have a part.
std::map<int, SlurmTask> tasks_by_part(const Submitted& state) {
  std::set<std::string> jobs;
  for (const auto& [part, job] : state.tasks) jobs.insert(job);
  std::map<int, SlurmTask> found;
  for (const std::string& job : jobs) {
    for (const SlurmTask& task : tasks_of(job)) {
      const auto last = state.tasks.find(task.task);
      if (last != state.tasks.end() && last->second == job) found[task.task] = task;
    }
  }
  return found;
}

std::string log_path(const std::string& folder, int part) { return fmt::format("{}/slurm/part_{}.log", folder, part); }

// The last line that is not empty.
std::string last_words(const std::string& path) {
  std::ifstream file(path);
  std::string last;
  for (std::string line; std::getline(file, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

std::string failure_text(const std::string& folder, int part, std::size_t missing, std::size_t points,
                         const SlurmTask* task) {
  std::string text = fmt::format("part {}: {} of {} points missing", part, missing, points);
  text += task ? "; " + task->state : "; no longer known to Slurm";
  if (task && task->reason != "None") text += fmt::format(" ({})", task->reason);
  const std::string words = last_words(log_path(folder, part));
  return text + (words.empty() ? "" : "; " + words) + "\n";
}

}  // namespace

SlurmSubmission submit_study(const Study& study, const SlurmChoice& choice) {
  const OwnedStudyFolder own(choice.folder, study.name, FolderUse::shared);
  write_study_manifest(study, StudyPlan(study).size(), choice.folder, choice.version);
  Submitted state = read_state(choice.folder);
  const std::vector<std::size_t> missing = missing_points(study, choice.folder, choice.version);
  const int before = state.parts;
  SlurmSubmission made;
  made.missing = missing.size();
  made.parts = state.parts = chosen_parts(choice, before, StudyPlan(study).size());
  std::set<int> parts;
  for (const std::size_t i : missing) parts.insert(static_cast<int>(i % static_cast<std::size_t>(state.parts)) + 1);
  const auto tasks = tasks_by_part(state);
  const auto is_alive = [](const auto& task) { return task.second.is_alive(); };
  if (before != 0 && before != state.parts && std::ranges::any_of(tasks, is_alive)) {
    throw SlurmError(SlurmError::Kind::refused,
                     fmt::format("tasks of {} parts are still in the queue: another number of parts has to wait for "
                                 "them",
                                 before));
  }
  if (before != state.parts) state.tasks.clear();
  for (const int part : parts) {
    const auto task = tasks.find(part);
    const bool waits = before == state.parts && task != tasks.end() && task->second.is_alive();
    if (!waits) made.submitted.push_back(part);
    made.alive += waits ? 1 : 0;
  }
  if (made.submitted.empty()) return made;
  make_folder(choice.folder + "/slurm");
  const std::string logs = without_patterns(absolute(choice.folder)) + "/slurm/";
  const std::string part = fmt::format("--jobs 1 --part \"$SLURM_ARRAY_TASK_ID/{}\"", state.parts);
  const std::string report = choice.report.empty() ? "" : " --report " + shell_word(absolute(choice.report));
  SlurmJob job{study.name, command(choice, part), logs + "part_%a.log", made.submitted,
               "",         choice.partition,      choice.time};
  made.array = submit(job);
  for (const int part : made.submitted) state.tasks[part] = made.array;
  write_state(choice.folder, state, made);
  job = {study.name + " tables",
         command(choice, "--merge" + report),
         logs + "tables.log",
         {},
         made.array,
         choice.partition,
         choice.time};
  made.collector = submit(job);
  write_state(choice.folder, state, made);
  return made;
}

std::string slurm_status_text(const std::string& folder, const StudyStatus& status) {
  const Submitted state = read_state(folder);
  if (state.parts == 0) return "";
  const auto parts = static_cast<std::size_t>(state.parts);
  std::vector<std::size_t> points(parts), missing(parts);
  for (std::size_t i = 0; i < status.is_finished.size(); ++i) {
    ++points[i % parts];
    missing[i % parts] += status.is_finished[i] ? 0 : 1;
  }
  const auto done = std::ranges::count(missing, std::size_t{0});
  std::map<int, SlurmTask> tasks;
  try {
    tasks = tasks_by_part(state);
  } catch (const SlurmError& error) {
    return fmt::format("{} of {} parts done; {}\n", done, parts, error.what());
  }
  std::size_t running = 0, waiting = 0, failed = 0;
  std::string failures;
  for (std::size_t i = 0; i < parts; ++i) {
    if (missing[i] == 0) continue;
    const int part = static_cast<int>(i) + 1;
    const auto task = tasks.find(part);
    if (task != tasks.end() && task->second.is_alive()) {
      ++(task->second.state == "PENDING" ? waiting : running);
    } else if (++failed <= kMostFailuresListed) {
      failures += failure_text(folder, part, missing[i], points[i], task == tasks.end() ? nullptr : &task->second);
    }
  }
  std::string text =
      fmt::format("{} parts: {} done, {} running, {} waiting, {} failed\n", parts, done, running, waiting, failed);
  if (failed > kMostFailuresListed) failures += fmt::format("and {} more parts\n", failed - kMostFailuresListed);
  if (failed > 0) failures += "--slurm --resume submits what is missing\n";
  return text + failures;
}

}  // namespace netpocket
