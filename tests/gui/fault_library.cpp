// Preloaded into the program by tests: makes the system fail as it seldom does by itself.
// NETPOCKET_FAIL_SYNC=n: the n-th synchronisation of a file fails, all others succeed.
// NETPOCKET_UNREADABLE=path: that file cannot be opened.

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdarg>
#include <cstdlib>
#include <cstring>

namespace {

template <typename Function>
Function system_function(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

bool fails_now() {
  static std::atomic<int> count = 0;
  const char* number = std::getenv("NETPOCKET_FAIL_SYNC");
  return number != nullptr && ++count == std::atoi(number);
}

bool is_folder(int file) {
  struct stat status = {};
  return fstat(file, &status) == 0 && S_ISDIR(status.st_mode);
}

bool is_unreadable(const char* path) {
  const char* named = std::getenv("NETPOCKET_UNREADABLE");
  return named != nullptr && std::strcmp(path, named) == 0;
}

int synchronise(const char* name, int file) {
  if (!is_folder(file) && fails_now()) {
    errno = EIO;
    return -1;
  }
  return system_function<int (*)(int)>(name)(file);
}

int open_with(const char* name, const char* path, int flags, mode_t mode) {
  if (is_unreadable(path)) {
    errno = EACCES;
    return -1;
  }
  return system_function<int (*)(const char*, int, ...)>(name)(path, flags, mode);
}

}  // namespace

extern "C" {

int fdatasync(int file) { return synchronise("fdatasync", file); }
int fsync(int file) { return synchronise("fsync", file); }

int open(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(more, mode_t) : 0;
  va_end(more);
  return open_with("open", path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(more, mode_t) : 0;
  va_end(more);
  return open_with("open64", path, flags, mode);
}
}
