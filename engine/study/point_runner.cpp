#include "engine/study/point_runner.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>

#include "engine/study/measured_run.h"

namespace netpocket {

struct PointRunner::Impl {
  Impl(const Study& its_study, const std::string& its_folder, const StudyOptions& its_options, std::size_t its_points,
       const StudyCallback& its_progress, const std::stop_token& stop)
      : study(its_study),
        folder(its_folder),
        options(its_options),
        progress(its_progress),
        used(used_keys(study)),
        program(options.version + options.commit),
        found(options.resume ? std::make_unique<FoundRecords>(folder) : nullptr),
        writer(records_path(folder, 1, 1)),
        expected(its_points),
        forward(stop, [this] { stop_source.request_stop(); }) {}

  std::vector<StudyRecord> run(const std::vector<StudyPoint>& points) {
    std::vector<StudyRecord> records(points.size());
    std::atomic<std::size_t> next = 0;
    {
      std::vector<std::jthread> workers;
      for (int i = 0; i < options.jobs; ++i) {
        workers.emplace_back([&] {
          for (std::size_t p = next++; p < points.size() && !stop_source.stop_requested(); p = next++) {
            finish(first + p, points[p], records[p]);
          }
        });
      }
    }
    first += points.size();
    if (failure) std::rethrow_exception(failure);
    if (stop_source.stop_requested()) throw SearchStopped();
    return records;
  }

  // Leaves `record` empty when stopped.
  void finish(std::size_t index, const StudyPoint& point, StudyRecord& record) {
    try {
      record = record_of(index, point);
    } catch (...) {
      const std::scoped_lock lock(mutex);
      if (!failure) failure = std::current_exception();
      stop_source.request_stop();
    }
  }

  StudyRecord record_of(std::size_t index, const StudyPoint& point) {
    PreparedPoint prepared = prepare_point(study, index, point, program, PointCheck::none);
    if (auto kept = kept_record(index, prepared.identity)) return std::move(*kept);
    prepared = prepare_point(study, index, point, program, PointCheck::full);
    StudyRecord record;
    if (!prepared.problem.empty()) {
      record = refused_record(index, prepared.point, prepared.identity, prepared.problem);
    } else {
      StudyRecord run = run_of(prepared.scenarios.front());
      if (run.is_null() || run.empty()) return {};
      std::vector<StudyRecord> runs;
      runs.push_back(std::move(run));
      record = run_record(index, prepared.point, prepared.identity, std::move(runs), {});
    }
    const std::scoped_lock lock(mutex);
    writer.add(record);
    runs_made += prepared.problem.empty() ? 1 : 0;
    done.emplace_back(index, prepared.identity);
    ++made;
    report();
    return record;
  }

  std::optional<StudyRecord> kept_record(std::size_t index, const std::string& identity) {
    const auto place = found ? found->find(index, identity) : std::nullopt;
    if (!place) return std::nullopt;
    const std::scoped_lock lock(mutex);
    StudyRecord record = reader.read(*place);
    done.emplace_back(index, identity);
    report();
    return record;
  }

  StudyRecord run_of(const Scenario& scenario) {
    double counted = 0;
    const auto count_until = [&](double time) {
      const std::scoped_lock lock(mutex);
      running += time / scenario.output.end_time - counted;
      counted = time / scenario.output.end_time;
      report();
    };
    const RunOptions run_options = {1, true, options.version, options.commit, options.command};
    StudyRecord run = measured_run(scenario, study.variants.front().name, used, "", run_options, count_until,
                                   stop_source.get_token());
    const std::scoped_lock lock(mutex);
    running -= counted;
    return run;
  }

  // Needs the mutex.
  void report() const {
    if (!progress) return;
    const std::size_t kept = done.size() - made, to_make = expected > kept ? expected - kept : 0;
    StudyProgress p{expected, done.size(), 1, wall_seconds()};
    if (to_make > 0) p.fraction = std::min(1.0, (static_cast<double>(made) + running) / static_cast<double>(to_make));
    progress(p);
  }

  double wall_seconds() const { return std::chrono::duration<double>(Clock::now() - start).count(); }

  using Clock = std::chrono::steady_clock;

  const Study& study;
  const std::string& folder;
  const StudyOptions& options;
  const StudyCallback& progress;
  const std::vector<std::string> used;
  const std::string program;
  const std::unique_ptr<const FoundRecords> found;
  const Clock::time_point start = Clock::now();
  std::size_t first = 0;  // index of the next points
  std::stop_source stop_source;

  // The mutex guards the following while points are run.
  std::mutex mutex;
  RecordWriter writer;
  RecordReader reader;
  std::vector<std::pair<std::size_t, std::string>> done;  // index and identity
  std::size_t expected, made = 0;                         // points; made: by this call
  std::size_t runs_made = 0;
  double running = 0;  // parts of points that are being run
  std::exception_ptr failure;

  const std::stop_callback<std::function<void()>> forward;
};

PointRunner::PointRunner(const Study& study, const std::string& folder, const StudyOptions& options, std::size_t points,
                         const StudyCallback& progress, const std::stop_token& stop)
    : impl_(std::make_unique<Impl>(study, folder, options, points, progress, stop)) {}

PointRunner::~PointRunner() = default;

std::vector<StudyRecord> PointRunner::run(const std::vector<StudyPoint>& points) { return impl_->run(points); }

std::vector<RecordPlace> PointRunner::places() const {
  auto done = impl_->done;
  std::ranges::sort(done);
  const FoundRecords found(impl_->folder);
  std::vector<RecordPlace> places;
  for (const auto& [index, identity] : done) {
    if (auto place = found.find(index, identity)) places.push_back(std::move(*place));
  }
  return places;
}

std::size_t PointRunner::runs_made() const { return impl_->runs_made; }
double PointRunner::wall_seconds() const { return impl_->wall_seconds(); }

}  // namespace netpocket
