#include "gui/workbench/session/run_library.h"

#include <sys/stat.h>

#include <QFile>
#include <QFileInfo>
#include <QUuid>

#include "engine/base/output_list.h"
#include "engine/capture/recorded_scenario.h"

namespace netpocket {
namespace {

// The name of another run whose recording stands there; empty: none does.
QString other_run_in(const RunLibrary& runs, const QString& path, RunId id) {
  struct stat wanted = {};
  if (stat(QFile::encodeName(path).constData(), &wanted) != 0) return {};
  for (const RunId other : runs.ids()) {
    const Run& run = *runs.find(other);
    struct stat held = {};
    if (other == id || !run.file || stat(run.file->path().c_str(), &held) != 0) continue;
    if (is_same_file(wanted, held)) return run.name;
  }
  return {};
}

// Those of the start and those that came during the run: its last change of strategy has all.
std::vector<DisturbanceParameters> recorded_disturbances(const Recording& recording, const Scenario& at_start) {
  for (std::size_t i = recording.checkpoint_times().size(); i-- > 0;) {
    if (!recording.changes_strategy(i)) continue;
    return read_scenario_text(recording.checkpoint(i).strategy, "scenario of the run").scenario.disturbances;
  }
  return at_start.disturbances;
}

}  // namespace

RunLibrary::RunLibrary(RunOptions origin, std::size_t cache_bytes, const QString& folder)
    : origin_(std::move(origin)), folder_(folder), cache_(cache_bytes) {
  qRegisterMetaType<RunId>("netpocket::RunId");
  qRegisterMetaType<std::size_t>("std::size_t");
}

RunLibrary::~RunLibrary() {
  // Recordings are closed before their folder goes.
  storage_.finish();
  runs_.clear();
}

Run* RunLibrary::get(RunId id) {
  const auto run = runs_.find(id);
  return run == runs_.end() ? nullptr : &run->second;
}

const Run* RunLibrary::find(RunId id) const {
  const auto run = runs_.find(id);
  return run == runs_.end() ? nullptr : &run->second;
}

std::vector<RunId> RunLibrary::ids() const {
  std::vector<RunId> ids;
  for (const auto& [id, run] : runs_) ids.push_back(id);
  return ids;
}

std::vector<RunId> RunLibrary::unsaved() const {
  std::vector<RunId> ids;
  for (const auto& [id, run] : runs_) {
    if (run.is_unsaved()) ids.push_back(id);
  }
  return ids;
}

QString RunLibrary::temporary_path(RunId id) const { return QString("%1/run%2.h5").arg(folder_.path()).arg(id); }

RunId RunLibrary::insert(Run run) {
  const RunId id = next_++;
  run.id = id;
  run.series.name = run.name.toStdString();
  runs_.emplace(id, std::move(run));
  return id;
}

RunId RunLibrary::add(const QString& name, const Scenario& scenario) {
  Run run;
  run.name = name;
  run.scenario = scenario;
  const RunId id = insert(std::move(run));
  get(id)->file = RunFile::temporary(temporary_path(id).toStdString());
  emit run_added(id);
  return id;
}

RunId RunLibrary::add_branch(RunId parent_id, double time) {
  const Run& parent = *find(parent_id);
  const std::size_t count = parent.frame_count() == 0 ? 0 : parent.frame_at(time) + 1;
  Run run = parent;
  run.name = tr("%1, from %2 s").arg(parent.name).arg(time, 0, 'f', 2);
  run.parent = parent_id;
  run.simulated_here = true;
  run.branch_time = time;
  run.state = RunState::preparing;
  run.status = {};
  run.temporary = true;
  run.saved_frames = 0;
  for (auto& channel : run.series.channels) channel.resize(std::min(channel.size(), count));
  std::erase_if(run.notes, [time](const TimeMark& mark) { return mark.time > time; });
  run.notes.push_back({TimeMark::Kind::branch, time, tr("Branched from %1").arg(parent.name)});
  const RunId id = insert(std::move(run));
  Run& branch = *get(id);
  branch.file = RunFile::temporary(temporary_path(id).toStdString());
  store([file = branch.file, source = parent.file, count, time, structure = branch.structure] {
    file->begin_branch(*source, count, time, *structure);
  });
  for (std::size_t i = 0; i < count; ++i) {
    if (auto frame = cache_.find(parent_id, i)) cache_.add(id, i, std::move(frame));
  }
  emit run_added(id);
  return id;
}

void RunLibrary::later(std::function<void()> action) {
  QMetaObject::invokeMethod(this, std::move(action), Qt::QueuedConnection);
}

void RunLibrary::store(std::function<void()> job) {
  storage_.post([this, job = std::move(job)] {
    try {
      job();
    } catch (const std::exception& error) {
      later([this, reason = QString::fromUtf8(error.what())] {
        // A full disk fails with every frame: once is enough.
        if (!std::exchange(write_failed_, true)) emit failed(reason);
      });
    }
  });
}

void RunLibrary::open(const QString& path) {
  storage_.post([this, path] { read_recording(path, false); });
}

void RunLibrary::recover(const LostRuns& lost) {
  storage_.post([this, lost] {
    for (const QString& path : lost.recordings) {
      const QString place = QString("%1/%2.h5").arg(folder_.path(), QUuid::createUuid().toString(QUuid::WithoutBraces));
      if (QFile::rename(path, place)) {
        read_recording(place, true);
      } else {
        later([this, path] { emit failed(tr("Cannot take over '%1'.").arg(path)); });
      }
    }
    forget(lost);
  });
}

struct RunLibrary::OpenedRecording {
  Recording recording;
  Scenario scenario;
  std::shared_ptr<const Snapshot> first_frame;
  bool recovered;
};

void RunLibrary::read_recording(const QString& path, bool recovered) {
  try {
    Recording recording(path.toStdString());
    auto scenario = recorded_scenario(recording).scenario;
    scenario.disturbances = recorded_disturbances(recording, scenario);
    std::shared_ptr<const Snapshot> first;
    if (recording.frame_count() > 0) first = std::make_shared<const Snapshot>(recording.frame(0));
    const auto opened = std::make_shared<OpenedRecording>(
        OpenedRecording{std::move(recording), std::move(scenario), std::move(first), recovered});
    later([this, opened] { add_recording(std::move(*opened)); });
  } catch (const std::exception& error) {
    later([this, reason = QString::fromUtf8(error.what())] { emit failed(reason); });
  }
}

void RunLibrary::add_recording(OpenedRecording opened) {
  Recording& recording = opened.recording;
  Run run;
  run.name =
      unused_name(opened.recovered ? tr("%1, recovered").arg(QString::fromStdString(recording.origin().scenario_name))
                                   : QFileInfo(QString::fromStdString(recording.path())).completeBaseName());
  run.scenario = opened.scenario;
  run.structure = std::make_shared<const Structure>(recording.structure());
  run.series = run_series(recording);
  run.first_frame = opened.first_frame;
  run.state = RunState::recorded;
  run.simulated_here = false;
  run.continuable = why_not_resumable(recording, origin_).empty();
  run.temporary = opened.recovered;
  run.status = recording.status();
  run.statistics = recording.statistics();
  run.file = RunFile::existing(std::move(recording), opened.recovered);
  emit run_added(insert(std::move(run)));
}

void RunLibrary::remove(RunId id) {
  const auto run = runs_.find(id);
  if (run == runs_.end()) return;
  // The file is closed where it was used.
  storage_.post([file = std::move(run->second.file)]() mutable { file.reset(); });
  runs_.erase(run);
  cache_.forget(id);
  emit run_removed(id);
}

void RunLibrary::rename(RunId id, const QString& name) {
  Run* run = get(id);
  if (run == nullptr || name.trimmed().isEmpty()) return;
  run->name = name.trimmed();
  run->series.name = run->name.toStdString();
  emit run_changed(id);
}

QString RunLibrary::unused_name(const QString& name) const {
  const auto taken = [this](const QString& candidate) {
    return std::ranges::any_of(runs_, [&](const auto& run) { return run.second.name == candidate; });
  };
  QString candidate = name;
  for (int i = 2; taken(candidate); ++i) candidate = QString("%1 (%2)").arg(name).arg(i);
  return candidate;
}

void RunLibrary::add_note(RunId id, const TimeMark& mark) {
  if (Run* run = get(id)) run->notes.push_back(mark);
  emit run_changed(id);
}

void RunLibrary::remove_note(RunId id, double time) {
  Run* run = get(id);
  if (run == nullptr) return;
  std::erase_if(run->notes, [time](const TimeMark& mark) {
    return mark.kind == TimeMark::Kind::own && std::abs(mark.time - time) < 1e-9;
  });
  emit run_changed(id);
}

void RunLibrary::begin(RunId id, std::shared_ptr<const Structure> structure, const Scenario& scenario) {
  Run* run = get(id);
  if (run == nullptr) return;
  run->structure = std::move(structure);
  run->scenario = scenario;
  const RunOrigin origin = run_origin(scenario, origin_);
  if (run->frame_count() == 0) run->series.begin(run->structure->channels);
  run->series.loops = run->structure->loops;
  run->series.phases = origin.phases;
  run->series.draft = origin.draft;
  if (run->parent < 0) {
    store([file = run->file, origin, structure = run->structure] { file->begin(origin, *structure); });
  }
  emit run_changed(id);
}

void RunLibrary::append(RunId id, const std::shared_ptr<const Snapshot>& frame, const RunStatistics& statistics,
                        double speed) {
  Run* run = get(id);
  if (run == nullptr) return;
  run->statistics = statistics;
  run->speed = speed;
  // A branch begins with the frame that it has from its parent.
  if (run->frame_count() > 0 && frame->time <= run->end_time()) return;
  if (run->frame_count() == 0) run->first_frame = frame;
  run->series.append(frame->channels);
  cache_.add(id, run->frame_count() - 1, frame);
  store([file = run->file, frame] { file->write(*frame); });
  emit frames_added(id);
}

void RunLibrary::append(RunId id, std::shared_ptr<const Checkpoint> checkpoint) {
  const Run* run = find(id);
  if (run == nullptr) return;
  store([file = run->file, checkpoint = std::move(checkpoint)] { file->write(*checkpoint); });
}

void RunLibrary::read_checkpoints(RunId id, double time, std::function<void(std::optional<CheckpointLog>)> use) {
  const Run* run = find(id);
  if (run == nullptr) return;
  storage_.post([this, file = run->file, time, threads = origin_.threads, use = std::move(use)] {
    try {
      later([use, log = file->checkpoint_log(time, {threads})] { use(log); });
    } catch (const std::exception& error) {
      later([this, use, reason = QString::fromUtf8(error.what())] {
        emit failed(reason);
        use(std::nullopt);
      });
    }
  });
}

void RunLibrary::set_state(RunId id, RunState state, const RunStatus& status, const RunStatistics& statistics) {
  Run* run = get(id);
  if (run == nullptr) return;
  run->state = state;
  run->status = status;
  run->statistics = statistics;
  if (state != RunState::running) run->speed = 0;
  emit run_changed(id);
}

void RunLibrary::set_scenario(RunId id, const Scenario& scenario) {
  Run* run = get(id);
  if (run == nullptr) return;
  run->scenario = scenario;
  const RunOrigin origin = run_origin(scenario, origin_);
  if (run->frame_count() == 0) run->series.begin(run->structure->channels);
  run->series.phases = origin.phases;
  emit run_changed(id);
}

void RunLibrary::finish(RunId id) {
  Run* run = get(id);
  if (run == nullptr || run->state == RunState::recorded) return;
  store([file = run->file, status = run->status, statistics = run->statistics] { file->finish(status, statistics); });
  run->state = RunState::recorded;
  emit run_changed(id);
}

std::shared_ptr<const Snapshot> RunLibrary::frame(RunId id, std::size_t index) {
  if (auto frame = cache_.find(id, index)) return frame;
  wanted_[id] = index;
  load_next();
  return nullptr;
}

void RunLibrary::load_next() {
  while (!loading_ && !wanted_.empty()) {
    const auto [id, index] = *wanted_.begin();
    wanted_.erase(wanted_.begin());
    load(id, index);
  }
}

void RunLibrary::load(RunId id, std::size_t index) {
  const Run* run = find(id);
  if (run == nullptr || index >= run->frame_count()) return;
  loading_ = true;
  storage_.post([this, id, index, file = run->file] {
    std::shared_ptr<const Snapshot> frame;
    QString reason;
    try {
      frame = std::make_shared<const Snapshot>(file->frame(index));
    } catch (const std::exception& error) {
      reason = QString::fromUtf8(error.what());
    }
    later([this, id, index, frame, reason] {
      loading_ = false;
      if (frame && find(id)) {
        cache_.add(id, index, frame);
        emit frame_loaded(id, index);
      } else if (!frame) {
        emit failed(reason);
      }
      load_next();
    });
  });
}

void RunLibrary::save(RunId id, const QString& path) {
  const Run* run = find(id);
  if (run == nullptr) return;
  if (const QString other = other_run_in(*this, path, id); !other.isEmpty()) {
    emit failed(
        tr("\"%1\" is the recording of the run \"%2\" in this window: save under another name.").arg(path, other));
    return;
  }
  storage_.post([this, id, file = run->file, count = run->frame_count(), path] {
    try {
      OutputList().add("recording", path.toStdString(), FileKind::recording);
      file->save_as(path.toStdString());
      later([this, id, count, path] {
        if (Run* saved_run = get(id)) saved_run->saved_frames = std::max(saved_run->saved_frames, count);
        emit saved(path);
      });
    } catch (const std::exception& error) {
      later([this, reason = QString::fromUtf8(error.what())] { emit failed(reason); });
    }
  });
}

void RunLibrary::collect(RunId id, FrameValues values, CollectedRows use) {
  const Run* run = find(id);
  if (run == nullptr) return;
  std::vector<std::shared_ptr<const Snapshot>> frames;
  for (std::size_t i = 0; i < run->frame_count(); ++i) frames.push_back(cache_.peek(id, i));
  store([this, frames = std::move(frames), times = run->series.times(), file = run->file, values = std::move(values),
         use = std::move(use)] {
    std::vector<std::vector<double>> rows;
    for (std::size_t i = 0; i < frames.size(); ++i) rows.push_back(values(frames[i] ? *frames[i] : file->frame(i)));
    later([use, times, rows] { use(times, rows); });
  });
}

void RunLibrary::flush(RunId id, std::function<void(const QString& path)> use) {
  const Run* run = find(id);
  if (run == nullptr) return;
  storage_.post([this, file = run->file, count = run->frame_count(), use = std::move(use)] {
    try {
      if (count > 0) file->frame(count - 1);
      later([use, path = QString::fromStdString(file->path())] { use(path); });
    } catch (const std::exception& error) {
      later([this, reason = QString::fromUtf8(error.what())] { emit failed(reason); });
    }
  });
}

}  // namespace netpocket
