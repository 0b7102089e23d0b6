#include "engine/study/run_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "engine/base/folder.h"
#include "engine/base/whole_file.h"
#include "engine/statistics/proportion.h"
#include "engine/study/found_records.h"
#include "engine/study/measured_run.h"
#include "engine/study/record_files.h"
#include "engine/study/run_search.h"
#include "engine/study/study_folder.h"
#include "engine/study/study_manifest.h"
#include "engine/study/study_plan.h"
#include "engine/study/study_table.h"

namespace netpocket {
namespace {

// Removes a file or an empty folder. Does nothing if it does not exist or cannot be removed.
void remove_own(const std::string& path) {
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
}

// A point that is being run.
struct Work {
  PreparedPoint prepared;
  std::vector<std::string> files;  // of its recordings, by variant; empty names: none
  std::vector<StudyRecord> runs;   // by variant
  std::size_t runs_left = 0;
};

class StudyRunner {
 public:
  StudyRunner(const Study& study, const std::string& folder, const StudyOptions& options, const StudyCallback& progress)
      : study_(study), folder_(folder), options_(options), progress_(progress), plan_(study), used_(used_keys(study)) {
    const auto part = static_cast<std::size_t>(options.part.part - 1);
    for (std::size_t i = part; i < plan_.size(); i += static_cast<std::size_t>(options.part.parts)) mine_.push_back(i);
    limit_ = study.until.half_width > 0 ? 0 : mine_.size();
  }

  void run(const std::stop_token& stop) {
    writer_.emplace(records_path(folder_, options_.part.part, options_.part.parts));
    if (has_recordings()) make_folder(folder_ + "/runs");
    if (options_.resume) found_.emplace(folder_);
    const std::stop_callback forward(stop, [this] {
      stop_.request_stop();
      changed_.notify_all();
    });
    report();
    {
      std::vector<std::jthread> workers;
      for (int i = 0; i < options_.jobs; ++i) workers.emplace_back([this] { work(); });
    }
    if (!study_.keep_recordings) remove_recordings();
  }

  // Throws what a worker threw.
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

  const StudyPlan& plan() const { return plan_; }
  // Number of points that the study takes.
  std::size_t points() const { return is_narrow_ ? limit_ : plan_.size(); }
  std::size_t runs_made() const { return runs_made_; }
  double wall_seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  struct Task {
    std::shared_ptr<Work> work;
    std::size_t variant;
  };

  bool has_recordings() const { return study_.has_findings || study_.keep_recordings; }

  // Main function of a worker.
  void work() {
    try {
      while (const auto task = next_task()) run(*task);
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      stop_.request_stop();
    }
    changed_.notify_all();
  }

  // A run of a point that another worker has begun, or the first run of the next point; nothing when there is none.
  std::optional<Task> next_task() {
    for (;;) {
      std::unique_lock lock(mutex_);
      changed_.wait(lock,
                    [this] { return stop_.stop_requested() || !tasks_.empty() || next_ < limit_ || !may_get_work(); });
      if (stop_.stop_requested()) return std::nullopt;
      if (!tasks_.empty()) {
        Task task = std::move(tasks_.back());
        tasks_.pop_back();
        return task;
      }
      if (next_ == limit_) {
        if (!begin_batch()) return std::nullopt;
        continue;
      }
      const std::size_t index = mine_[next_++];
      ++preparing_;
      lock.unlock();
      if (auto task = begin(index)) return task;
    }
  }

  // Whether there may be work later although there is none now: variants of a point that is being prepared, or another
  // batch once all points of this one are finished.
  bool may_get_work() const { return preparing_ > 0 || (limit_ < mine_.size() && finished_ < limit_); }

  // Lets another batch of points begin, if there is one and the interval is still too wide. Needs the mutex.
  bool begin_batch() {
    if (is_narrow_ || limit_ == mine_.size() || finished_ < limit_) return false;
    is_narrow_ =
        limit_ > 0 && std::ranges::all_of(tallies_, [this](const CaptureTally& tally) {
          return is_narrow_enough(tally.captured, tally.judged, study_.estimate.confidence, study_.until.half_width);
        });
    if (is_narrow_) return false;
    limit_ = std::min(mine_.size(), limit_ + static_cast<std::size_t>(study_.until.batch));
    changed_.notify_all();
    return true;
  }

  // Begins a point. Nothing when it is refused or kept from before.
  std::optional<Task> begin(std::size_t index) {
    auto work = std::make_shared<Work>();
    const std::string program = options_.version + options_.commit;
    work->prepared = prepare_point(study_, plan_, index, program, PointCheck::none);
    const auto kept = found_ ? found_->find(index, work->prepared.identity) : std::nullopt;
    if (!kept) work->prepared = prepare_point(study_, plan_, index, program, PointCheck::full);
    const PreparedPoint& prepared = work->prepared;
    if (kept || !prepared.problem.empty()) {
      const std::scoped_lock lock(mutex_);
      --preparing_;
      const StudyRecord record =
          kept ? reader_.read(*kept) : refused_record(index, prepared.point, prepared.identity, prepared.problem);
      if (!kept) writer_->add(record);
      count(record);
      return std::nullopt;
    }
    work->runs.resize(study_.variants.size());
    work->runs_left = study_.variants.size();
    for (const NamedSettings& variant : study_.variants) {
      const std::string name = variant.name.empty() ? "run" : variant.name;
      work->files.push_back(has_recordings() ? fmt::format("{}/runs/{:04}_{}.h5", folder_, index + 1, name) : "");
    }
    const std::scoped_lock lock(mutex_);
    --preparing_;
    for (std::size_t v = work->runs.size(); v-- > 1;) tasks_.push_back({work, v});
    changed_.notify_all();
    return Task{work, 0};
  }

  void run(const Task& task) {
    Work& work = *task.work;
    const Scenario& scenario = work.prepared.scenarios[task.variant];
    const RunOptions run_options = {1, true, options_.version, options_.commit, options_.command};
    double counted = 0;
    const auto count_until = [&](double time) {
      const std::scoped_lock lock(mutex_);
      runs_counted_ += time / scenario.output.end_time - counted;
      counted = time / scenario.output.end_time;
      report();
    };
    if (!work.files[task.variant].empty()) {
      const std::scoped_lock lock(mutex_);
      made_.push_back(work.files[task.variant]);
    }
    StudyRecord run = measured_run(scenario, study_.variants[task.variant].name, used_, work.files[task.variant],
                                   run_options, count_until, stop_.get_token());
    if (run.is_null() || run.empty()) return;
    count_until(scenario.output.end_time);  // counts the time that a run which ended early has left over
    const std::scoped_lock lock(mutex_);
    ++runs_made_;
    work.runs[task.variant] = std::move(run);
    if (--work.runs_left == 0) finish(work);
  }

  // Needs the mutex.
  void finish(Work& work) {
    {
      std::vector<Recording> recordings;
      for (const std::string& file : work.files) {
        if (study_.has_findings) recordings.emplace_back(file);
      }
      const PreparedPoint& prepared = work.prepared;
      const StudyRecord record =
          run_record(prepared.index, prepared.point, prepared.identity, std::move(work.runs), recordings);
      writer_->add(record);
      runs_counted_ -= static_cast<double>(study_.variants.size());
      count(record);
    }
    if (study_.keep_recordings) return;
    for (const std::string& file : work.files) {
      if (!file.empty()) remove_own(file);
    }
  }

  // Counts a finished point. Needs the mutex.
  void count(const StudyRecord& record) {
    ++finished_;
    for (std::size_t v = 0; v < record["runs"].size(); ++v) tallies_[v].add(record["runs"][v]);
    report();
    changed_.notify_all();
  }

  // Removes the recordings that this call began and did not finish. Those that earlier calls kept remain.
  void remove_recordings() {
    for (const std::string& file : made_) remove_own(file);
    remove_own(folder_ + "/runs");
  }

  // Needs the mutex.
  void report() const {
    if (!progress_) return;
    StudyProgress p;
    p.points = mine_.size();
    p.points_done = finished_;
    const double runs = static_cast<double>(mine_.size() * study_.variants.size());
    const double done = static_cast<double>(finished_ * study_.variants.size()) + runs_counted_;
    p.fraction = runs > 0 ? done / runs : 1;
    p.wall_seconds = wall_seconds();
    progress_(p);
  }

  using Clock = std::chrono::steady_clock;

  const Study& study_;
  const std::string& folder_;
  const StudyOptions& options_;
  const StudyCallback& progress_;
  const StudyPlan plan_;
  const std::vector<std::string> used_;
  const Clock::time_point start_ = Clock::now();
  std::vector<std::size_t> mine_;  // indices of the points of this part
  std::optional<FoundRecords> found_;
  std::stop_source stop_;

  // The mutex guards the following while workers run.
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<RecordWriter> writer_;
  RecordReader reader_;
  std::vector<Task> tasks_;
  std::size_t next_ = 0, limit_ = 0, finished_ = 0;  // of mine_: begun, may begin, finished
  std::size_t preparing_ = 0;                        // points whose scenarios are being made
  bool is_narrow_ = false;                           // the interval is as narrow as asked for
  std::vector<CaptureTally> tallies_ = std::vector<CaptureTally>(study_.variants.size());
  double runs_counted_ = 0;  // of points that are being run
  std::size_t runs_made_ = 0;
  std::vector<std::string> made_;  // recordings that this call began
  std::exception_ptr failure_;
};

// Reads the records of the first `points` points and writes the tables of a study.
class Collector {
 public:
  Collector(const Study& study, const std::string& folder, const StudyOptions& options, const StudyPlan& plan)
      : study_(study), folder_(folder), options_(options), plan_(plan) {}

  void collect(std::size_t points, StudyOutcome& outcome) {
    const FoundRecords found(folder_);
    outcome.points = points;
    const auto part = static_cast<std::size_t>(options_.part.part - 1);
    const auto parts = static_cast<std::size_t>(options_.part.parts);
    // One of many parts, which is not the last to end, does not look at the points of the others.
    const bool is_for_all = parts == 1 || found.size() >= points;
    for (std::size_t i = is_for_all ? 0 : part; i < points; i += is_for_all ? 1 : parts) {
      const std::string program = options_.version + options_.commit;
      const auto place = found.find(i, prepare_point(study_, plan_, i, program, PointCheck::none).identity);
      if (place) places_.push_back(*place);
      outcome.stopped = outcome.stopped || (!place && i % parts == part);
    }
    outcome.points_done = is_for_all ? places_.size() : found.size();
    evaluate(outcome);
    if (parts > 1 && places_.size() < points) return;
    write_study_tables(study_, folder_, places_);
    if (!study_.uncertain.empty()) {
      write_whole_file(folder_ + "/study_estimates.csv", FileKind::csv, estimates_csv(study_, outcome.estimates));
    }
    if (study_.sensitivity.method != SensitivityMethod::none) {
      write_whole_file(folder_ + "/study_sensitivity.csv", FileKind::csv,
                       sensitivity_csv(study_, outcome.sensitivities));
    }
    outcome.has_tables = true;
  }

 private:
  void evaluate(StudyOutcome& outcome) const {
    RecordReader reader;
    CampaignEstimator estimator(study_);
    SensitivityEstimator sensitivity(study_);
    const bool is_sensitivity = study_.sensitivity.method != SensitivityMethod::none;
    for (const RecordPlace& place : places_) {
      StudyRecord record = reader.read(place);
      outcome.refused += place.outcome == "refused" ? 1 : 0;
      outcome.diverged += place.outcome == "diverged" ? 1 : 0;
      outcome.limited += place.outcome == "limited" ? 1 : 0;
      if (outcome.first_refusal.empty()) outcome.first_refusal = record["refused"].get<std::string>();
      // Points of a sensitivity study are no sample.
      if (!study_.uncertain.empty() && !is_sensitivity) estimator.add(record);
      if (is_sensitivity) sensitivity.add(record);
      if (study_.has_findings || study_.report.of == ReportOf::statements) outcome.records.push_back(std::move(record));
    }
    outcome.estimates = estimator.estimates();
    if (is_sensitivity) outcome.sensitivities = sensitivity.estimates();
  }

  const Study& study_;
  const std::string& folder_;
  const StudyOptions& options_;
  const StudyPlan& plan_;
  std::vector<RecordPlace> places_;  // of the finished points, in their order
};

}  // namespace

StudyOutcome run_study(const Study& study, const std::string& folder, const StudyOptions& options,
                       const StudyCallback& progress, const std::stop_token& stop) {
  const bool is_part = options.part.parts > 1;
  const OwnedStudyFolder own(folder, study.name, is_part ? FolderUse::shared : FolderUse::alone);
  if (study.is_search()) return run_search(study, folder, options, progress, stop);
  write_study_manifest(study, StudyPlan(study).size(), folder, options.version + options.commit);
  StudyRunner runner(study, folder, options, progress);
  runner.run(stop);
  StudyOutcome outcome;
  outcome.runs_made = runner.runs_made();
  outcome.wall_seconds = runner.wall_seconds();
  Collector(study, folder, options, runner.plan()).collect(runner.points(), outcome);
  runner.rethrow();
  return outcome;
}

}  // namespace netpocket
