#include "gui/cluster/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "engine/base/file_error.h"

namespace netpocket {
namespace {

// A file in memory that takes one stream of the program.
class Stream {
 public:
  Stream() : descriptor_(memfd_create("netpocket", MFD_CLOEXEC)) {
    if (descriptor_ < 0) throw FileError(fmt::format("cannot make a file in memory: {}", std::strerror(errno)));
  }
  ~Stream() { close(descriptor_); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  int descriptor() const { return descriptor_; }
  std::string content() const {
    struct stat status {};
    fstat(descriptor_, &status);
    std::string text(static_cast<std::size_t>(status.st_size), '\0');
    const ssize_t size = pread(descriptor_, text.data(), text.size(), 0);
    text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
    return text;
  }

 private:
  int descriptor_;
};

// Without the mask of signals of this program, which waits for them on a thread of its own.
int spawn(pid_t& process, const std::vector<std::string>& words, int out, int error) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&files, out, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, error, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  const int failure = posix_spawnp(&process, words.front().c_str(), &files, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return failure;
}

}  // namespace

ChildResult run_child(const std::vector<std::string>& words) {
  const Stream out, error;
  pid_t process = -1;
  const int failure = spawn(process, words, out.descriptor(), error.descriptor());
  if (failure == ENOENT) return {.is_found = false, .exit_code = 127, .out = {}, .error = {}};
  if (failure != 0) throw FileError(fmt::format("cannot start {}: {}", words.front(), std::strerror(failure)));
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  const int exit_code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return {.is_found = true, .exit_code = exit_code, .out = out.content(), .error = error.content()};
}

}  // namespace netpocket
