#include "engine/base/folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "engine/base/file_error.h"

namespace netpocket {

void make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  std::error_code ignored;
  if (!error && !std::filesystem::is_directory(path, ignored)) error = std::make_error_code(std::errc::not_a_directory);
  if (error) throw FileError(fmt::format("cannot make the folder \"{}\": {}", path, error.message()));
  if (access(path.c_str(), W_OK | X_OK) == 0) return;
  throw FileError(fmt::format("cannot write into the folder \"{}\": {}", path, std::strerror(errno)));
}

bool sync_folder(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return true;
  const bool synced = fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS;
  const int error = errno;
  close(descriptor);
  errno = error;
  return synced;
}

}  // namespace netpocket
