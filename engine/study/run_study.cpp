#include "engine/study/run_study.h"

#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <filesystem>
#include <mutex>
#include <optional>
#include <thread>

#include "engine/base/folder.h"
#include "engine/base/whole_file.h"
#include "engine/capture/run.h"
#include "engine/study/study_folder.h"

namespace netpocket {
namespace {

// A point to be run.
struct Work {
  std::size_t index;
  std::vector<Scenario> scenarios;  // by variant
  std::string identity;
  std::vector<std::string> files;  // of its recordings, by variant
  std::size_t runs_left;
};

// Removes a file or an empty folder. Does nothing if it does not exist or cannot be removed.
void remove_own(const std::string& path) {
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
}

// Joins the lines of a text.
std::string in_one_line(std::string text) {
  for (auto end = text.find('\n'); end != text.npos; end = text.find('\n', end)) text.replace(end, 1, "; ");
  return text;
}

class StudyRunner {
 public:
  StudyRunner(const Study& study, const std::string& folder, const StudyOptions& options, const StudyCallback& progress)
      : study_(study), folder_(folder), options_(options), progress_(progress), points_(study_points(study)) {
    records_.resize(points_.size());
  }

  StudyOutcome run(const std::stop_token& stop) {
    const OwnedStudyFolder own(folder_, study_.name);
    make_folder(folder_ + "/points");
    make_folder(folder_ + "/runs");
    for (std::size_t i = 0; i < points_.size(); ++i) prepare(i);
    const std::stop_callback forward(stop, [this] { stop_.request_stop(); });
    report();
    {
      std::vector<std::jthread> workers;
      for (int i = 0; i < options_.jobs; ++i) workers.emplace_back([this] { work(); });
    }
    if (!study_.keep_recordings) remove_recordings();
    StudyOutcome outcome = collect();
    write_whole_file(folder_ + "/study.csv", FileKind::csv, study_csv(study_, outcome.records));
    write_whole_file(folder_ + "/study.json", FileKind::json, study_json(study_, outcome.records).dump(1) + "\n");
    if (failure_) std::rethrow_exception(failure_);
    return outcome;
  }

 private:
  struct Task {
    std::size_t work;
    std::size_t variant;
  };

  // Decides whether a point is refused, kept from before, or run.
  void prepare(std::size_t index) {
    std::vector<Scenario> scenarios;
    std::string problems;
    for (const NamedSettings& variant : study_.variants) {
      StudyScenario made = study_scenario(study_, points_[index], variant);
      if (!made.diagnostics.ok() && problems.empty()) problems = in_one_line(made.diagnostics.text());
      scenarios.push_back(std::move(made.scenario));
    }
    const std::string identity = point_identity(scenarios, options_.version + options_.commit);
    const std::string path = record_path(folder_, index);
    if (!problems.empty()) {
      keep(index, refused_record(index, points_[index], identity, problems));
    } else if (auto record = options_.resume ? load_record(path, identity) : std::nullopt) {
      (*record)["point"] = index + 1;
      records_[index] = std::move(record);
      ++points_done_;
    } else {
      Work work{index, std::move(scenarios), identity, {}, study_.variants.size()};
      for (std::size_t v = 0; v < study_.variants.size(); ++v) {
        const std::string& name = study_.variants[v].name;
        work.files.push_back(fmt::format("{}/runs/{:04}_{}.h5", folder_, index + 1, name.empty() ? "run" : name));
        tasks_.push_back({work_.size(), v});
        seconds_to_run_ += work.scenarios[v].output.end_time;
      }
      work_.push_back(std::move(work));
    }
  }

  void keep(std::size_t index, StudyRecord record) {
    write_whole_file(record_path(folder_, index), FileKind::json, record.dump(1) + "\n");
    records_[index] = std::move(record);
    ++points_done_;
  }

  // Main function of a worker: runs tasks until none is left.
  void work() {
    try {
      while (const auto task = next_task()) run(*task);
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      stop_.request_stop();
    }
  }

  std::optional<Task> next_task() {
    const std::scoped_lock lock(mutex_);
    if (stop_.stop_requested() || next_ == tasks_.size()) return std::nullopt;
    return tasks_[next_++];
  }

  void run(const Task& task) {
    Work& work = work_[task.work];
    const Scenario& scenario = work.scenarios[task.variant];
    const RunOptions run_options = {1, true, options_.version, options_.commit, options_.command};
    double counted = 0;
    const auto count_until = [&](double time) {
      const std::scoped_lock lock(mutex_);
      seconds_run_ += time - counted;
      counted = time;
      report();
    };
    {
      const std::scoped_lock lock(mutex_);
      made_.push_back(work.files[task.variant]);
    }
    const RunResult result = run_to_recording(
        scenario, work.files[task.variant], run_options, [&](const RunProgress& p) { count_until(p.time); },
        stop_.get_token());
    if (result.status.reason == RunReason::storage_failed) throw RecordingError(result.status.message);
    if (result.status.reason == RunReason::stopped) return;
    count_until(scenario.output.end_time);  // counts the time that a diverged run has left over
    const std::scoped_lock lock(mutex_);
    if (--work.runs_left == 0) finish(work);
  }

  void finish(const Work& work) {
    {
      std::vector<Recording> recordings;
      for (const std::string& file : work.files) recordings.emplace_back(file);
      keep(work.index, run_record(work.index, points_[work.index], work.identity, study_.variants, recordings));
    }
    if (!study_.keep_recordings) {
      for (const std::string& file : work.files) remove_own(file);
    }
    report();
  }

  // Removes the recordings that this call began and did not finish. Those that earlier calls kept remain.
  void remove_recordings() {
    for (const std::string& file : made_) remove_own(file);
    remove_own(folder_ + "/runs");
  }

  void report() const {
    if (!progress_) return;
    StudyProgress p;
    p.points = points_.size();
    p.points_done = points_done_;
    p.fraction = seconds_to_run_ > 0 ? seconds_run_ / seconds_to_run_ : 1;
    p.wall_seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    progress_(p);
  }

  StudyOutcome collect() {
    StudyOutcome outcome;
    outcome.points = points_.size();
    for (auto& record : records_) {
      if (record) outcome.records.push_back(std::move(*record));
    }
    outcome.stopped = outcome.records.size() < points_.size();
    return outcome;
  }

  using Clock = std::chrono::steady_clock;

  const Study& study_;
  const std::string& folder_;
  const StudyOptions& options_;
  const StudyCallback& progress_;
  const std::vector<StudyPoint> points_;
  const Clock::time_point start_ = Clock::now();
  double seconds_to_run_ = 0;  // s, simulated
  std::vector<Task> tasks_;
  std::stop_source stop_;

  // The mutex guards the following while workers run.
  std::mutex mutex_;
  std::vector<Work> work_;
  std::size_t next_ = 0;
  double seconds_run_ = 0;
  std::vector<std::optional<StudyRecord>> records_;  // by point
  std::size_t points_done_ = 0;
  std::vector<std::string> made_;  // recordings that this call began
  std::exception_ptr failure_;
};

}  // namespace

StudyOutcome run_study(const Study& study, const std::string& folder, const StudyOptions& options,
                       const StudyCallback& progress, const std::stop_token& stop) {
  return StudyRunner(study, folder, options, progress).run(stop);
}

}  // namespace netpocket
