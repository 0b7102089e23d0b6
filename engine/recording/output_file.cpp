#include "engine/recording/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <tuple>
#include <utility>

#include "engine/recording/recorder.h"

namespace netpocket {

namespace {

// More than HDF5 writes between two checks of the room and when it closes the file.
constexpr std::uint64_t kMargin = 8u << 20;
constexpr std::uint64_t kStep = 32u << 20;

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw RecordingError(fmt::format("cannot write \"{}\": {}", path, reason));
}

// False when another open file description holds the lock. File systems without locks count as unlocked.
bool lock(int descriptor) { return flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK; }

bool is_being_written(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return false;
  const bool locked = !lock(descriptor);
  ::close(descriptor);
  return locked;
}

}  // namespace

OutputFile::OutputFile(const std::string& path, bool overwrite)
    : path_(path), part_path_(path + ".part"), overwrite_(overwrite) {
  check_target();
  descriptor_ = open(part_path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(path_, std::strerror(errno));
  if (!lock(descriptor_)) {
    ::close(descriptor_);
    fail(path_, "another program is writing it");
  }
}

void OutputFile::close() {
  if (descriptor_ < 0) return;
  if (published_) {
    struct stat status = {};
    // Where this fails the room stays reserved; the recording itself is complete.
    std::ignore = fstat(descriptor_, &status) == 0 && ftruncate(descriptor_, status.st_size) == 0;
  } else {
    unlink(part_path_.c_str());
  }
  ::close(std::exchange(descriptor_, -1));
}

void OutputFile::check_target() const {
  std::error_code ignored;
  const auto status = std::filesystem::status(path_, ignored);
  if (!std::filesystem::exists(status)) return;
  if (std::filesystem::is_directory(status)) fail(path_, "it is a folder");
  if (!overwrite_) fail(path_, "it exists already");
  if (is_being_written(path_)) fail(path_, "another program is writing it");
}

void OutputFile::ensure_room(std::uint64_t used) {
  if (used + kMargin <= reserved_) return;
  reserve(used + kMargin + kStep);
}

void OutputFile::reserve(std::uint64_t size) {
  struct rlimit limit = {};
  if (getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY && size > limit.rlim_cur) {
    fail(path_, "the file would exceed the size limit of this process");
  }
  if (fallocate(descriptor_, FALLOC_FL_KEEP_SIZE, 0, static_cast<off_t>(size)) == 0) {
    reserved_ = size;
    return;
  }
  if (errno == ENOSPC || errno == EDQUOT || errno == EFBIG) fail(path_, "the disk is full");
  // This file system cannot reserve: look at what is free instead, every time.
  struct statvfs disk = {};
  if (fstatvfs(descriptor_, &disk) == 0 && std::uint64_t{disk.f_bavail} * disk.f_frsize < kMargin) {
    fail(path_, "the disk is full");
  }
}

void OutputFile::sync() {
  // File systems that cannot (some in memory, some over networks) say EINVAL or EROFS.
  if (fdatasync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) fail(path_, std::strerror(errno));
}

void OutputFile::publish() {
  if (published_) return;
  check_target();
  if (rename(part_path_.c_str(), path_.c_str()) != 0) fail(path_, std::strerror(errno));
  published_ = true;
  sync_folder();
}

// The new name is on the disk when the folder is. Where folders cannot be opened or synchronised, the name follows when
// the system sees fit.
void OutputFile::sync_folder() const {
  const std::string folder = std::filesystem::path(path_).parent_path().string();
  const int descriptor = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  std::ignore = fsync(descriptor);
  ::close(descriptor);
}

}  // namespace netpocket
