#include "gui/commands/run_log.h"

#include <fmt/format.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/spdlog.h>
#include <sys/utsname.h>

#include <cerrno>
#include <cmath>
#include <thread>

#include "engine/base/file_error.h"
#include "engine/base/fingerprint.h"
#include "engine/math/instruction_set.h"
#include "engine/scenario/write_scenario.h"
#include "gui/commands/version.h"

namespace netpocket {

RunLog::RunLog(const std::string& path) {
  try {
    auto sink = std::make_shared<spdlog::sinks::basic_file_sink_mt>(path);
    logger_ = std::make_shared<spdlog::logger>("run", std::move(sink));
  } catch (const spdlog::spdlog_ex&) {
    throw write_error(path, errno);
  }
  // Otherwise it would say so itself, on standard error.
  logger_->set_error_handler([path, problem = problem_](const std::string&) {
    if (problem->empty()) *problem = write_error(path, errno).what();
  });
  logger_->set_pattern("%Y-%m-%d %H:%M:%S %v");
  logger_->flush_on(spdlog::level::info);
}

RunLog::~RunLog() = default;

void RunLog::note_program(const std::string& command_line, int threads) {
  std::string versions = version_text();
  for (std::size_t line = versions.find('\n'); line != std::string::npos; line = versions.find('\n', line)) {
    versions.replace(line, 1, ", ");
  }
  utsname system = {};
  uname(&system);
  logger_->info("{}", versions);
  logger_->info("{} {} {}, {} processors, kernels for {}, {} threads", system.sysname, system.release, system.machine,
                std::thread::hardware_concurrency(), to_string(instruction_set()), threads);
  logger_->info("command: {}", command_line);
}

void RunLog::note_scenario(const Scenario& scenario, const std::string& recording) {
  logger_->info("scenario {}, hash {}, to t = {} s, recorded in \"{}\"", scenario.name,
                Fingerprint().add(write_scenario_text(scenario)).text(), scenario.output.end_time, recording);
}

void RunLog::note_resumed(const std::string& recording, double time) {
  logger_->info("goes on from t = {} s of \"{}\"", time, recording);
}

void RunLog::note_progress(const RunProgress& progress) {
  const int tenths = static_cast<int>(std::floor(10 * progress.time / progress.end_time + 1e-9));
  if (tenths <= tenths_) return;
  tenths_ = tenths;
  logger_->info("t = {:.6g} s after {:.1f} s", progress.time, progress.wall_seconds);
}

void RunLog::note_end(const RunResult& result) {
  const RunStatistics& s = result.statistics;
  logger_->info("{} elements, {} coordinates, {} steps, smallest {:.4g} s, limited by {}", s.elements, s.coordinates,
                s.steps, s.time_step, s.step_limit);
  if (!result.symmetry.reason.empty()) {
    logger_->info("all sectors computed from t = {:.6g} s on: {}", result.symmetry.since, result.symmetry.reason);
  }
  logger_->info("{} at t = {:.6g} s after {:.1f} s, {:.1f} s of processor time: {}", to_string(result.status.reason),
                result.status.time, s.wall_seconds, s.cpu_seconds, result.status.message);
}

void RunLog::note_failure(const std::string& reason) { logger_->error("failed: {}", reason); }

std::string log_path(const std::string& recording) { return recording + ".log"; }

}  // namespace netpocket
