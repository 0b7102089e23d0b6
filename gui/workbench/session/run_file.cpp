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

void RunFile::finish(const RunStatus& status, const RunStatistics& statistics) {
  if (recorder_) recorder_->finish(status, statistics);
  recorder_.reset();
}

void RunFile::copy_frames(RunFile& source, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) write(source.frame(i));
}

Recording& RunFile::reader(std::size_t frame_count) {
  if (reader_ && reader_->frame_count() >= frame_count) return *reader_;
  if (recorder_) recorder_->flush();
  reader_.reset();
  reader_.emplace(path_);
  return *reader_;
}

Snapshot RunFile::frame(std::size_t index) { return reader(index + 1).frame(index); }

void RunFile::save_as(const std::string& path) {
  const Recording& source = reader(written_);
  Recorder copy(path, source.origin(), source.structure(), true);
  for (std::size_t i = 0; i < source.frame_count(); ++i) copy.write(source.frame(i));
  copy.finish(source.status(), source.statistics());
}

}  // namespace netpocket
