#include "gui/workbench/findings_updater.h"

#include "engine/analysis/run_history.h"
#include "engine/recording/recording.h"

namespace netpocket {
namespace {

constexpr int kInterval = 1500;  // ms

FindingsResult evaluate(const std::vector<std::string>& paths, bool running) {
  FindingsResult result;
  result.running = running;
  try {
    std::vector<Recording> recordings;
    for (const std::string& path : paths) recordings.emplace_back(path);
    std::vector<const Recording*> pointers;
    for (const Recording& recording : recordings) pointers.push_back(&recording);
    result.findings = evaluate_findings(pointers);
    const Capture capture = RunHistory(recordings.front()).capture();
    result.why_not = capture.reason;
    result.captured = capture.verdict;
  } catch (const std::exception& error) {
    result.failure = error.what();
  }
  return result;
}

}  // namespace

FindingsUpdater::FindingsUpdater(CaptureSession& session, std::function<std::vector<RunId>()> runs)
    : session_(session), runs_(std::move(runs)) {
  timer_.setSingleShot(true);
  timer_.setInterval(kInterval);
  connect(&timer_, &QTimer::timeout, this, &FindingsUpdater::begin);
  task_ = std::make_unique<LatestTask<Job>>([this](const Job& job) {
    QMetaObject::invokeMethod(
        this, [this, result = evaluate(job.paths, job.running)] { emit evaluated(result); }, Qt::QueuedConnection);
  });
}

FindingsUpdater::~FindingsUpdater() { task_.reset(); }

void FindingsUpdater::request() {
  if (!timer_.isActive()) timer_.start();
}

void FindingsUpdater::begin() {
  Job job;
  RunId last = -1;
  for (const RunId id : runs_()) {
    const Run* run = session_.runs().find(id);
    if (run == nullptr || run->frame_count() < 2) continue;
    job.paths.push_back(run->file->path());
    job.running = job.running || (run->state != RunState::recorded && run->state != RunState::ended);
    last = id;
  }
  if (last < 0) {
    emit evaluated({});
    return;
  }
  // The storage thread has then written everything that was simulated.
  session_.runs().flush(last, [this, job](const QString&) { task_->submit(job); });
}

}  // namespace netpocket
