#include "tests/gui/program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
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

std::vector<char*> environment_without_display() {
  std::vector<char*> result;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text = *variable;
    if (!text.starts_with("DISPLAY=") && !text.starts_with("WAYLAND_DISPLAY=")) result.push_back(*variable);
  }
  result.push_back(nullptr);
  return result;
}

}  // namespace

RunningProgram::RunningProgram(const std::vector<std::string>& arguments, const std::string& out) {
  // In memory: a pipe would have to be read while the program runs.
  out_ = out.empty() ? memfd_create("out", MFD_CLOEXEC) : open(out.c_str(), O_WRONLY | O_CLOEXEC);
  error_ = memfd_create("error", MFD_CLOEXEC);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, out_, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, error_, STDERR_FILENO);
  // Test drivers may ignore SIGINT; the program is to see it.
  sigset_t defaults;
  sigemptyset(&defaults);
  sigaddset(&defaults, SIGINT);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigdefault(&attributes, &defaults);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);

  std::vector<std::string> words = {NETPOCKET_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  EXPECT_EQ(
      posix_spawn(&process_, NETPOCKET_PROGRAM, &files, &attributes, argv.data(), environment_without_display().data()),
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

ProgramResult run_program(const std::vector<std::string>& arguments) { return RunningProgram(arguments).wait(); }

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
