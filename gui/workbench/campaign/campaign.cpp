#include "gui/workbench/campaign/campaign.h"

#include <QDir>
#include <QFileInfo>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>

#include "engine/base/file_error.h"
#include "engine/study/record_follower.h"

namespace netpocket {
namespace {

constexpr auto kLookInterval = std::chrono::milliseconds(250);
constexpr std::size_t kFewestForRate = 3;  // points

bool is_written_to(const std::string& folder) {
  const QDir records(QString::fromStdString(folder) + "/records");
  for (const QFileInfo& file : records.entryInfoList({"*.jsonl"}, QDir::Files)) {
    if (is_being_written(file.filePath().toStdString())) return true;
  }
  return false;
}

// False when it is time to end.
bool wait_a_while(const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any changed;
  std::unique_lock lock(mutex);
  changed.wait_for(lock, stop, kLookInterval, [] { return false; });
  return !stop.stop_requested();
}

}  // namespace

Campaign::Campaign(const QString& program, const QString& study, const QString& folder, QObject* parent)
    : QObject(parent), program_(program), study_(study), folder_(folder) {
  connect(&job_, &CampaignJob::finished, this, [this] {
    ended_ = true;
    emit changed();
  });
  connect(&job_, &CampaignJob::stopped, this, &Campaign::changed);
  connect(&job_, &CampaignJob::failed, this, [this](const QString& reason) {
    emit changed();
    emit failed(reason);
  });
  clock_.start();
  follower_ = std::jthread([this](const std::stop_token& stop) { follow(stop); });
}

Campaign::~Campaign() {
  follower_.request_stop();
  follower_.join();
}

// False when it is time to end.
bool Campaign::wait_for_room(const std::stop_token& stop) {
  while (!room_.try_acquire_for(kLookInterval)) {
    if (stop.stop_requested()) return false;
  }
  return true;
}

// Reads the manifest when it is new, then the records.
void Campaign::follow(const std::stop_token& stop) {
  const std::string folder = folder_.toStdString();
  RecordFollower records(folder);
  std::filesystem::file_time_type known_time;
  do {
    if (!wait_for_room(stop)) return;
    std::optional<StudyManifest> manifest;
    Batch batch;
    try {
      std::error_code error;
      const auto time = std::filesystem::last_write_time(folder + "/" + kStudyManifest, error);
      if (!error && time != known_time) manifest = read_study_manifest(folder);
      if (!error) known_time = time;
      batch = std::make_shared<const std::vector<FollowedRecord>>(records.read_new());
    } catch (const FileError& error) {
      const QString reason = QString::fromStdString(error.what());
      QMetaObject::invokeMethod(
          this, [this, reason] { emit failed(reason); }, Qt::QueuedConnection);
      return;
    }
    const bool is_written = is_written_to(folder);
    const bool has_more = !batch->empty();
    QMetaObject::invokeMethod(
        this, [=, this] { take(manifest, batch, is_written); }, Qt::QueuedConnection);
    if (has_more && !stop.stop_requested()) continue;
    if (!wait_a_while(stop)) return;
  } while (!stop.stop_requested());
}

void Campaign::take(const std::optional<StudyManifest>& manifest, const Batch& batch, bool is_written) {
  room_.release();
  const bool elsewhere = is_written && !is_running();
  const bool is_other = elsewhere != elsewhere_ || manifest.has_value();
  elsewhere_ = elsewhere;
  if (manifest) {
    manifest_ = manifest;
    if (!results_) results_ = std::make_unique<LiveResults>(*manifest_);
  }
  if (results_ && !batch->empty()) {
    for (const FollowedRecord& record : *batch) results_->add(record);
    // What was there before says nothing about the rate.
    if (!has_caught_up_ || !(is_running() || elsewhere_)) before_ = results_->finished();
    last_ = static_cast<double>(clock_.elapsed()) / 1000;
    emit points_came();
  }
  has_caught_up_ = has_caught_up_ || batch->empty();
  if (is_other) emit changed();
}

QString Campaign::study() const {
  if (!study_.isEmpty() || !manifest_) return study_;
  const QString file = QString::fromStdString(manifest_->file);
  return QFileInfo::exists(file) ? file : QString();
}

QString Campaign::name() const {
  return manifest_ ? QString::fromStdString(manifest_->study) : QFileInfo(folder_).fileName();
}

void Campaign::start(int jobs) {
  if (is_running() || study().isEmpty()) return;
  ended_ = false;
  before_ = results_ ? results_->finished() : 0;
  clock_.restart();
  last_ = 0;
  job_.start(program_, study(), folder_, jobs);
  emit changed();
}

void Campaign::stop() {
  if (!is_running()) return;
  job_.stop();
  emit changed();
}

bool Campaign::is_complete() const {
  if (is_running() || !manifest_) return false;
  const bool has_tables = QFileInfo::exists(folder_ + "/study.csv");
  return ended_ || (has_tables && results_ && results_->finished() >= manifest_->points);
}

double Campaign::captures_a_minute() const {
  const std::size_t done = results_ ? results_->finished() : 0;
  if (done < before_ + kFewestForRate || !(last_ > 0)) return 0;
  return 60 * static_cast<double>(done - before_) / last_;
}

std::optional<double> Campaign::time_left() const {
  const double rate = captures_a_minute();
  if (!(rate > 0) || !manifest_) return std::nullopt;
  const std::size_t done = std::min(results_->finished(), manifest_->points);
  return 60 * static_cast<double>(manifest_->points - done) / rate;
}

StudyScenario Campaign::scenario_of(std::size_t row) const {
  const LiveResults::Source& source = results_->sources()[row];
  try {
    return recorded_scenario(*manifest_, RecordReader().read(source.place), source.run);
  } catch (const FileError& error) {
    StudyScenario none;
    none.diagnostics.add({.message = error.what()});
    return none;
  }
}

}  // namespace netpocket
