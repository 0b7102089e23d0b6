#include "engine/recording/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <tuple>
#include <utility>

#include "engine/base/folder.h"

namespace netpocket {

namespace {

// Bytes. More than HDF5 writes between two checks of the room, and when it closes the file.
constexpr std::uint64_t kMargin = 8u << 20;
constexpr std::uint64_t kStep = 32u << 20;

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

OutputFile::OutputFile(const std::string& path, bool overwrite) : name_(path), overwrite_(overwrite) {
  path_ = checked_target().path;
  part_path_ = path_ + ".part";
  open_and_lock();
  try {
    // Check again: another program may have published its recording before it released the lock.
    keep_permissions(descriptor_, checked_target());
  } catch (...) {
    close();
    throw;
  }
}

// The previous owner of the lock may have renamed or removed the file meanwhile. The lock would then be on a file
// without a name, and the next program would lock another one.
void OutputFile::open_and_lock() {
  struct stat left = {};
  if (stat(part_path_.c_str(), &left) == 0) {  // left by a killed program, or a file of somebody else
    find_destination(part_path_, FileKind::recording, ReadOnlyFiles::replaced);
  }
  while (true) {
    descriptor_ = open(part_path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor_ < 0) throw write_error(name_, errno);
    if (!lock(descriptor_)) {
      ::close(std::exchange(descriptor_, -1));
      throw write_error(name_, "another program is writing it");
    }
    if (has_name(part_path_)) return;
    ::close(std::exchange(descriptor_, -1));
  }
}

bool OutputFile::has_name(const std::string& path) const {
  struct stat named = {}, ours = {};
  return lstat(path.c_str(), &named) == 0 && fstat(descriptor_, &ours) == 0 && is_same_file(named, ours);
}

void OutputFile::close() {
  if (descriptor_ < 0) return;
  if (published_) {
    struct stat status = {};
    // If this fails, the room stays reserved. The recording itself is complete.
    std::ignore = fstat(descriptor_, &status) == 0 && ftruncate(descriptor_, status.st_size) == 0;
  } else if (has_name(part_path_)) {
    unlink(part_path_.c_str());
  }
  ::close(std::exchange(descriptor_, -1));
}

Destination OutputFile::checked_target() const {
  struct stat there = {};
  if (!overwrite_ && stat(name_.c_str(), &there) == 0 && S_ISREG(there.st_mode)) {
    throw write_error(name_, "it exists already");
  }
  Destination target =
      find_destination(name_, FileKind::recording, overwrite_ ? ReadOnlyFiles::replaced : ReadOnlyFiles::refused);
  if (target.existing && is_being_written(target.path)) throw write_error(name_, "another program is writing it");
  return target;
}

void OutputFile::ensure_room(std::uint64_t used) {
  if (used + kMargin <= reserved_) return;
  reserve(used + kMargin + kStep);
}

void OutputFile::reserve(std::uint64_t size) {
  struct rlimit limit = {};
  if (getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY && size > limit.rlim_cur) {
    throw write_error(name_, "the file would exceed the size limit of this process");
  }
  if (fallocate(descriptor_, FALLOC_FL_KEEP_SIZE, 0, static_cast<off_t>(size)) == 0) {
    reserved_ = size;
    return;
  }
  if (errno == ENOSPC || errno == EDQUOT || errno == EFBIG) throw write_error(name_, "the disk is full");
  // This file system cannot reserve room, so the free room is checked every time.
  struct statvfs disk = {};
  if (fstatvfs(descriptor_, &disk) == 0 && std::uint64_t{disk.f_bavail} * disk.f_frsize < kMargin) {
    throw write_error(name_, "the disk is full");
  }
}

void OutputFile::sync() {
  require_whole();
  // File systems that cannot synchronise (some in memory, some on networks) report EINVAL or EROFS.
  if (fdatasync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) throw write_error(name_, errno);
  require_whole();  // syncing may take long, and the next write would hide that the file was truncated
}

void OutputFile::require_name() const {
  if (!has_name()) fail_nameless();
}

void OutputFile::fail_nameless() const {
  throw write_error(name_, "it was deleted, moved or replaced while it was being written");
}

// A write may make the file as long again before its size is asked for. Then it has a hole, and the room that was
// reserved for it is gone.
bool OutputFile::has_its_room(const struct stat& status) const {
  constexpr std::uint64_t kBlock = 512;  // bytes, of st_blocks on every system
  return static_cast<std::uint64_t>(status.st_blocks) * kBlock + kMargin / 2 >= reserved_;
}

void OutputFile::require_whole() {
  struct stat status = {};
  if (fstat(descriptor_, &status) == 0 && status.st_size >= seen_size_ && has_its_room(status)) {
    seen_size_ = status.st_size;
    return;
  }
  throw write_error(name_, "another program has cut it short while it was being written");
}

void OutputFile::publish() {
  if (published_) return;
  require_name();
  const Destination target = checked_target();
  if (rename(part_path_.c_str(), target.path.c_str()) != 0) throw write_error(name_, errno);
  path_ = target.path;
  published_ = true;
  if (!sync_folder(target.folder)) throw write_error(name_, errno);
}

}  // namespace netpocket
