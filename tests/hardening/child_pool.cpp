#include "tests/hardening/child_pool.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <exception>
#include <map>
#include <stdexcept>
#include <thread>

namespace netpocket::test {
namespace {

struct Child {
  int trial;
  int pipe;  // its end to read from
};

// Results are a line: they fit into what a pipe holds, so that the child can end before it is read.
constexpr std::size_t kLongestResult = 4096;

[[noreturn]] void be_child(int trial, unsigned seconds, const ChildTrial& make, int pipe) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // not to outlive the trials
  const rlimit time = {seconds, seconds};
  setrlimit(RLIMIT_CPU, &time);
  std::string text;
  try {
    text = make(trial);
  } catch (const std::exception& error) {
    text = std::string("threw \"") + error.what() + "\"";
  }
  const std::string line = text.substr(0, kLongestResult);
  _exit(write(pipe, line.data(), line.size()) == static_cast<ssize_t>(line.size()) ? 0 : 1);
}

ChildResult result_of(int pipe, int status) {
  std::string text(kLongestResult, '\0');
  const ssize_t length = read(pipe, text.data(), text.size());
  text.resize(length < 0 ? 0 : static_cast<std::size_t>(length));
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {true, text};
  if (!WIFSIGNALED(status)) return {false, "ended with status " + std::to_string(WEXITSTATUS(status))};
  const int number = WTERMSIG(status);
  return {false, number == SIGKILL || number == SIGXCPU ? "took too long" : std::string(strsignal(number))};
}

}  // namespace

void run_in_children(int first, int last, unsigned seconds, const ChildTrial& trial, const ChildResultSink& sink) {
  const std::size_t most = std::max(1u, std::thread::hardware_concurrency());
  std::map<pid_t, Child> children;
  for (int next = first; next <= last || !children.empty();) {
    while (next <= last && children.size() < most) {
      int ends[2];
      if (pipe(ends) != 0) throw std::runtime_error("no pipe");
      const pid_t process = fork();
      if (process < 0) throw std::runtime_error("no process");
      if (process == 0) be_child(next, seconds, trial, ends[1]);
      close(ends[1]);
      children[process] = {next++, ends[0]};
    }
    int status = 0;
    const auto child = children.find(wait(&status));
    if (child == children.end()) continue;
    sink(child->second.trial, result_of(child->second.pipe, status));
    close(child->second.pipe);
    children.erase(child);
  }
}

}  // namespace netpocket::test
