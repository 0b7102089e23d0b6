#include "engine/base/destination.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <tuple>

namespace netpocket {
namespace {

namespace fs = std::filesystem;

std::string folder_of(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

// Path to which the last component of a path leads, which need not exist. It does not resolve links of the system such
// as "/proc/self/fd/1"; their target is known only after opening them.
std::string follow_links(const std::string& name) {
  constexpr int kMostLinks = 40;  // as in Linux
  fs::path path = name;
  for (int i = 0; i < kMostLinks; ++i) {
    std::error_code error;
    const fs::path target = fs::read_symlink(path, error);
    if (error) return path.string();     // no link, or nothing there
    path = path.parent_path() / target;  // operator/ drops the left side if the target is absolute
  }
  throw write_error(name, ELOOP);
}

const char* kind_of_file(mode_t mode) {
  if (S_ISDIR(mode)) return "it is a folder";
  if (S_ISFIFO(mode)) return "it is a pipe, not a file";
  if (S_ISSOCK(mode)) return "it is a socket, not a file";
  return "it is a device, not a file";
}

std::optional<struct stat> status_of(const std::string& name) {
  struct stat status = {};
  if (stat(name.c_str(), &status) == 0) return status;
  if (errno != ENOENT) throw write_error(name, errno);
  return std::nullopt;
}

void require_folder(const Destination& destination) {
  const std::string& folder = destination.folder;
  struct stat status = {};
  if (stat(folder.c_str(), &status) != 0) throw write_error(destination.name, errno);
  if (!S_ISDIR(status.st_mode)) throw write_error(destination.name, ENOTDIR);
  if (access(folder.c_str(), W_OK | X_OK) != 0) throw write_error(destination.name, errno);
}

// The first bytes of the existing file. Throws if it cannot be read: its kind is then unknown, so it must not be
// replaced.
std::string content_of(const Destination& destination) {
  const int file = open(destination.path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) throw write_error(destination.name, errno);
  std::string bytes(kContentBytes, '\0');
  const ssize_t count = pread(file, bytes.data(), bytes.size(), 0);
  const int error = errno;
  close(file);
  if (count < 0) throw write_error(destination.name, error);
  bytes.resize(static_cast<std::size_t>(count));
  return bytes;
}

void require_kind(const Destination& destination, FileKind kind) {
  const std::string content = content_of(destination);
  if (may_replace(kind, content)) return;
  throw OutputRefused(fmt::format("\"{}\" is {}, which {} would destroy; name another file, or remove it first",
                                  destination.name, content_description(content), description(kind)));
}

}  // namespace

bool is_read_only(const Destination& destination) {
  if (!destination.existing) return false;
  constexpr mode_t kAnyWriter = S_IWUSR | S_IWGRP | S_IWOTH;
  const bool protected_by_mode = (destination.existing->st_mode & kAnyWriter) == 0;  // access() lets root write it
  return protected_by_mode || access(destination.path.c_str(), W_OK) != 0;
}

void require_readable(const std::string& path) {
  // O_NONBLOCK: otherwise opening a pipe without a writer would wait.
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0 && errno != ENOENT && errno != ENOTDIR) {
    throw FileError(fmt::format("cannot read \"{}\": {}", path, std::strerror(errno)));
  }
  if (file >= 0) close(file);
}

bool is_same_file(const struct stat& a, const struct stat& b) { return a.st_dev == b.st_dev && a.st_ino == b.st_ino; }

Destination find_destination(const std::string& path, FileKind kind, ReadOnlyFiles read_only) {
  Destination destination{path, path, folder_of(path), status_of(path)};
  if (destination.existing && !S_ISREG(destination.existing->st_mode)) {
    throw write_error(path, kind_of_file(destination.existing->st_mode));
  }
  destination.path = follow_links(path);
  destination.folder = folder_of(destination.path);
  if (destination.existing) {
    struct stat end = {};
    if (lstat(destination.path.c_str(), &end) != 0 || !is_same_file(end, *destination.existing)) {
      throw write_error(path, "it leads to a file that has no name");
    }
  }
  require_folder(destination);
  if (fs::path(destination.path).filename().empty()) throw write_error(path, "it is a folder");
  if (!destination.existing) return destination;
  require_kind(destination, kind);
  if (read_only == ReadOnlyFiles::refused && is_read_only(destination)) throw write_error(path, "it is read-only");
  return destination;
}

void keep_permissions(int descriptor, const Destination& destination) {
  if (!destination.existing) return;
  // The owner is set first, because changing it clears special permissions. Only root may give files away; for other
  // users the new file remains their own.
  std::ignore = fchown(descriptor, destination.existing->st_uid, destination.existing->st_gid);
  std::ignore = fchmod(descriptor, destination.existing->st_mode & 07777);
}

Place place_of(const Destination& destination) {
  struct stat folder = {};
  if (stat(destination.folder.c_str(), &folder) != 0) throw write_error(destination.name, errno);
  return {folder.st_dev, folder.st_ino, fs::path(destination.path).filename().string()};
}

}  // namespace netpocket
