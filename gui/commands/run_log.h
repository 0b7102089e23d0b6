#pragma once
// The log of a run: which program simulated what, how far it came and how it ended. One line each, with date and time.

#include <memory>
#include <string>

#include "engine/capture/run.h"

namespace spdlog {
class logger;
}

namespace netpocket {

class RunLog {
 public:
  // Goes on at the end of the file when there is one: whoever runs twice sees both. That it is a log of this program,
  // FileKind::log, is checked before. Throws FileError.
  explicit RunLog(const std::string& path);
  ~RunLog();

  // Versions, processor and command.
  void note_program(const std::string& command_line, int threads);
  void note_scenario(const Scenario& scenario, const std::string& recording);
  void note_resumed(const std::string& recording, double time);
  // A line for every tenth of the run.
  void note_progress(const RunProgress& progress);
  void note_end(const RunResult& result);
  void note_failure(const std::string& reason);
  // Why the log lacks lines, in one sentence; empty when it has all.
  const std::string& problem() const { return *problem_; }

 private:
  std::shared_ptr<spdlog::logger> logger_;
  std::shared_ptr<std::string> problem_ = std::make_shared<std::string>();
  int tenths_ = 0;
};

// "case1.h5.log" of "case1.h5": each recording has its own.
std::string log_path(const std::string& recording);

}  // namespace netpocket
