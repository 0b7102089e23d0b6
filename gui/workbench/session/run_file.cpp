#include "gui/workbench/session/run_file.h"

#include <filesystem>

namespace netpocket {

std::shared_ptr<RunFile> RunFile::temporary(const std::string& path) {
  return std::shared_ptr<RunFile>(new RunFile(path, true));
}

std::shared_ptr<RunFile> RunFile::existing(Recording recording, bool temporary) {
  std::shared_ptr<RunFile> file(new RunFile(recording.path(), temporary));
  file->written_ = recording.frame_count();
  file->origin_ = recording.origin();
  file->reader_.emplace(std::move(recording));
  return file;
}

RunFile::~RunFile() {
  recorder_.reset();
  reader_.reset();
  std::error_code ignored;
  if (temporary_) std::filesystem::remove(path_, ignored);
}

void RunFile::begin(const RunOrigin& origin, const Structure& structure) {
  origin_ = origin;
  recorder_ = std::make_unique<Recorder>(path_, origin, structure, true);
}

void RunFile::write(const Snapshot& snapshot) {
  if (!recorder_) return;
  recorder_->write(snapshot);
  ++written_;
}

void RunFile::write(const Checkpoint& checkpoint) {
  if (recorder_) recorder_->write(checkpoint);
}

void RunFile::finish(const RunStatus& status, const RunStatistics& statistics) {
  if (recorder_) recorder_->finish(status, statistics);
  recorder_.reset();
  reader_.reset();  // it may have been opened before the last frames
}

void RunFile::begin_branch(RunFile& source, std::size_t count, double time, const Structure& structure) {
  const Recording& parent = source.complete_reader();
  begin(parent.origin(), structure);
  for (std::size_t i = 0; i < count; ++i) write(parent.frame(i));
  for (std::size_t i = 0; i < parent.checkpoint_times().size() && parent.checkpoint_times()[i] <= time; ++i) {
    write(parent.checkpoint(i));
  }
}

CheckpointLog RunFile::checkpoint_log(double time, const SimulationOptions& options) {
  return {complete_reader(), time, options};
}

Recording& RunFile::reader(std::size_t frame_count) {
  if (reader_ && reader_->frame_count() >= frame_count) return *reader_;
  return complete_reader();
}

Recording& RunFile::complete_reader() {
  if (reader_ && !recorder_) return *reader_;
  if (recorder_) recorder_->flush();
  reader_.reset();
  reader_.emplace(path_);
  return *reader_;
}

Snapshot RunFile::frame(std::size_t index) { return reader(index + 1).frame(index); }

void RunFile::save_as(const std::string& path) {
  const Recording& source = complete_reader();
  Recorder copy(path, source.origin(), source.structure(), true);
  for (std::size_t i = 0; i < source.frame_count(); ++i) copy.write(source.frame(i));
  for (std::size_t i = 0; i < source.checkpoint_times().size(); ++i) copy.write(source.checkpoint(i));
  copy.finish(source.status(), source.statistics());
}

}  // namespace netpocket
