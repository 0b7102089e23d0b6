#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "engine/dynamics/run.h"
#include "engine/recording/report.h"
#include "gui/commands/command.h"
#include "gui/commands/interrupt.h"
#include "gui/commands/options.h"
#include "gui/commands/progress_line.h"
#include "gui/commands/recordings.h"
#include "gui/commands/version.h"

namespace netpocket {
namespace {

constexpr const char* kExamples = R"(Examples:
  netpocket run scenarios/case1.toml -o case1.h5
  netpocket run scenarios/case1.toml -o fast.h5 --set closing.duration=5 --until 15

Ctrl-C ends a run cleanly: what was recorded is kept.

)";

struct RunChoice {
  ScenarioChoice scenario;
  std::string output;
  double until = 0;  // 0: as the scenario says
  int threads = 1;
  bool overwrite = false;
  bool quiet = false;
};

std::string progress_text(const RunProgress& progress) {
  const double fraction = progress.time / progress.end_time;
  return fmt::format("t = {:.2f} of {:g} s, {:.2f} x real time, {} left", progress.time, progress.end_time,
                     progress.time / progress.wall_seconds,
                     duration_text(seconds_left(fraction, progress.wall_seconds)));
}

// A run that did not finish says so on standard error.
ExitCode report_ending(const RunStatus& status, const std::string& path) {
  switch (status.reason) {
    case RunReason::finished:
      return ExitCode::ok;
    case RunReason::stopped:
      fmt::print(stderr, "netpocket: interrupted at t = {:.4g} s; \"{}\" holds what was recorded\n", status.time, path);
      return ExitCode::interrupted;
    case RunReason::diverged:
      fmt::print(stderr, "netpocket: {}; \"{}\" holds what was recorded\n", status.message, path);
      return ExitCode::diverged;
    default:
      throw CommandError(ExitCode::io, status.message);
  }
}

ExitCode run(const RunChoice& choice, const std::string& command_line) {
  ScenarioChoice scenario_choice = choice.scenario;
  if (choice.until > 0) scenario_choice.settings.push_back(fmt::format("output.end_time={}", choice.until));
  const Scenario scenario = load_scenario(scenario_choice);
  require_writable(choice.output);
  if (!choice.overwrite && std::filesystem::exists(choice.output)) {
    throw CommandError(ExitCode::io, fmt::format("\"{}\" exists already; --overwrite replaces it", choice.output));
  }
  const RunOptions options = {choice.threads, choice.overwrite, program_version(), program_commit(), command_line};
  const Interrupt interrupt;
  const auto result = [&] {
    ProgressLine line(!choice.quiet);
    const auto show = [&](const RunProgress& p) { line.update(p.time / p.end_time, progress_text(p)); };
    return run_to_recording(scenario, choice.output, options, show, interrupt.token());
  }();
  const ExitCode code = report_ending(result.status, choice.output);
  if (!choice.quiet) fmt::print("{}", summary_text(open_recording(choice.output)));
  return code;
}

}  // namespace

Action declare_run(CLI::App& app) {
  const auto choice = std::make_shared<RunChoice>();
  add_scenario_options(app, choice->scenario);
  app.add_option("-o,--output", choice->output, "recording to write (HDF5)")->required()->type_name("RUN.h5");
  app.add_option("--until", choice->until, "simulated time at which the run ends, s; instead of output.end_time")
      ->type_name("T")
      ->check(positive_number());
  app.add_option("--threads", choice->threads, "threads; the result is the same for any number")
      ->type_name("N")
      ->check(whole_number(1, 256))
      ->capture_default_str();
  app.add_flag("--overwrite", choice->overwrite, "replace an existing recording");
  app.add_flag("--quiet", choice->quiet, "no progress and no summary");
  app.footer(kExamples +
             exit_code_help({ExitCode::bad_input, ExitCode::diverged, ExitCode::io, ExitCode::interrupted}));
  return [choice](const std::string& command_line) { return run(*choice, command_line); };
}

}  // namespace netpocket
