#include "tests/gui/program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string_view>
#include <utility>

extern char** environ;

namespace netpocket {
namespace {

std::string content(int file) {
  std::string text(static_cast<std::size_t>(lseek(file, 0, SEEK_END)), '\0');
  const ssize_t read = pread(file, text.data(), text.size(), 0);
  text.resize(read < 0 ? 0 : static_cast<std::size_t>(read));
  return text;
}

std::string_view name_of(std::string_view variable) { return variable.substr(0, variable.find('=')); }

// Without a display, and with what is added.
std::vector<char*> environment_with(const std::vector<std::string>& added) {
  std::vector<char*> result;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view name = name_of(*variable);
    const bool replaced = std::any_of(added.begin(), added.end(), [&](const auto& a) { return name_of(a) == name; });
    if (!replaced && name != "DISPLAY" && name != "WAYLAND_DISPLAY") result.push_back(*variable);
  }
  for (const std::string& variable : added) result.push_back(const_cast<char*>(variable.c_str()));
  result.push_back(nullptr);
  return result;
}

// A program takes over the limit of who starts it. SIGXFSZ would end the test: it only writes less than that.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(std::size_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit = {bytes, before_.rlim_max};
    if (bytes > 0) setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_ = {};
};

int open_stream(const std::string& path) {
  // In memory: a pipe would have to be read while the program runs.
  return path.empty() ? memfd_create("stream", MFD_CLOEXEC) : open(path.c_str(), O_WRONLY | O_CLOEXEC);
}

}  // namespace

RunningProgram::RunningProgram(const std::vector<std::string>& arguments, const Surroundings& surroundings) {
  out_ = open_stream(surroundings.out);
  error_ = open_stream(surroundings.error);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, out_, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, error_, STDERR_FILENO);
  for (const int stream : surroundings.closed) posix_spawn_file_actions_addclose(&files, stream);
  // Test drivers may ignore SIGINT; the program is to see it.
  sigset_t defaults;
  sigemptyset(&defaults);
  sigaddset(&defaults, SIGINT);
  sigaddset(&defaults, SIGHUP);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigdefault(&attributes, &defaults);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);

  std::vector<std::string> words = {NETPOCKET_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const FileSizeLimit limit(surroundings.largest_file);
  EXPECT_EQ(posix_spawn(&process_, NETPOCKET_PROGRAM, &files, &attributes, argv.data(),
                        environment_with(surroundings.environment).data()),
            0);
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&attributes);
}

RunningProgram::~RunningProgram() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  close(out_);
  close(error_);
}

void RunningProgram::signal(int number) const { kill(process_, number); }

ProgramResult RunningProgram::wait() {
  int status = 0;
  rusage usage = {};
  EXPECT_EQ(wait4(process_, &status, 0, &usage), process_);
  process_ = -1;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), content(out_), content(error_),
          usage.ru_maxrss};
}

ProgramResult run_program(const std::vector<std::string>& arguments, const Surroundings& surroundings) {
  return RunningProgram(arguments, surroundings).wait();
}

TestFolder::TestFolder() {
  std::string name = testing::TempDir() + "/netpocket-XXXXXX";
  EXPECT_NE(mkdtemp(name.data()), nullptr);
  path_ = name;
}

TestFolder::~TestFolder() { std::filesystem::remove_all(path_); }

std::string TestFolder::write(const std::string& name, const std::string& text) const {
  std::ofstream(file(name)) << text;
  return file(name);
}

std::string scenario_file(const std::string& name) { return NETPOCKET_SOURCE_DIR "/scenarios/" + name; }

std::string short_recording(const TestFolder& folder, const std::vector<std::string>& more) {
  const std::string path = folder.file("run.h5");
  std::vector<std::string> arguments = {"run", scenario_file("case1.toml"), "-o", path, "--until", "0.1", "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const auto result = run_program(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.error;
  return path;
}

}  // namespace netpocket
