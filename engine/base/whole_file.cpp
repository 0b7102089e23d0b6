#include "engine/base/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <filesystem>
#include <tuple>
#include <utility>

#include "engine/base/folder.h"

namespace netpocket {
namespace {

// Short enough to fit even if the destination's name has 255 bytes, and unique, so that nobody else writes the file.
std::string temporary_name() {
  static std::atomic<unsigned> count = 0;
  return fmt::format(".netpocket-{}-{}.part", getpid(), ++count);
}

int create(const Destination& destination, std::string& path) {
  while (true) {
    path = (std::filesystem::path(destination.folder) / temporary_name()).string();
    const int descriptor = open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0) return descriptor;
    if (errno != EEXIST) throw write_error(destination.name, errno);
  }
}

// Files of which there are as many as frames need no synchronisation: they can be drawn or exported again.
bool is_one_of_many(FileKind kind) { return kind == FileKind::png || kind == FileKind::vtp; }

}  // namespace

WholeFile::WholeFile(const std::string& path, FileKind kind)
    : destination_(find_destination(path, kind)), kind_(kind), descriptor_(create(destination_, temporary_path_)) {
  keep_permissions(descriptor_, destination_);
}

WholeFile::~WholeFile() {
  if (descriptor_ >= 0) close(descriptor_);
  if (!committed_) unlink(temporary_path_.c_str());
}

void WholeFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw write_error(path(), errno);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void WholeFile::commit() {
  const auto require = [this](bool success) {
    if (!success) throw write_error(path(), errno);
  };
  // File systems that cannot synchronise (some in memory, some over networks) return EINVAL or EROFS.
  if (!is_one_of_many(kind_)) require(fsync(descriptor_) == 0 || errno == EINVAL || errno == EROFS);
  // Some network file systems report a full disk only here.
  require(close(std::exchange(descriptor_, -1)) == 0);
  require(rename(temporary_path_.c_str(), destination_.path.c_str()) == 0);
  committed_ = true;
  if (!is_one_of_many(kind_)) require(sync_folder(destination_.folder));
}

void write_whole_file(const std::string& path, FileKind kind, std::string_view bytes) {
  WholeFile file(path, kind);
  file.write(bytes);
  file.commit();
}

}  // namespace netpocket
