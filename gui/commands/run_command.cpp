#include <fmt/format.h>

#include <memory>

#include "engine/analysis/report.h"
#include "engine/base/output_list.h"
#include "engine/capture/recorded_scenario.h"
#include "engine/capture/run.h"
#include "engine/scenario/parameter_text.h"
#include "gui/commands/command.h"
#include "gui/commands/interrupt.h"
#include "gui/commands/options.h"
#include "gui/commands/progress_line.h"
#include "gui/commands/recordings.h"
#include "gui/commands/run_log.h"
#include "gui/commands/standard_streams.h"
#include "gui/commands/version.h"

namespace netpocket {
namespace {

constexpr const char* kRunExamples = R"(Examples:
  netpocket run scenarios/case1.toml -o case1.h5
  netpocket run scenarios/case1.toml -o fast.h5 --set closing.duration=5 --until 15
  netpocket run --resume case1.h5
  netpocket run --resume case1.h5 --until 40

Ctrl-C ends a run cleanly: what was recorded is kept. --resume goes on from the last checkpoint (one for each simulated
second) of a run that was interrupted or killed and gives, to the last bit, what it would have given without that. It
is refused when the scenario or the program is another. RUN.h5.log, beside the recording, says what was run and how it went.

)";

struct RunChoice {
  ScenarioChoice scenario;
  std::string output;
  std::string resumed;  // recording to go on with; empty: from the start
  double until = 0;     // 0: as the scenario says
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

ExitCode ending_code(RunReason reason) {
  switch (reason) {
    case RunReason::finished:
      return ExitCode::ok;
    case RunReason::stopped:
      return ExitCode::interrupted;
    case RunReason::diverged:
    case RunReason::limited:
      return ExitCode::diverged;
    default:
      return ExitCode::io;
  }
}

// A run that did not finish says so on standard error.
ExitCode report_ending(const RunStatus& status, const std::string& path) {
  switch (status.reason) {
    case RunReason::finished:
      break;
    case RunReason::stopped:
      say(fmt::format("interrupted at t = {:.4g} s; \"{}\" holds what was recorded", status.time, path));
      break;
    case RunReason::diverged:
    case RunReason::limited:
      say(fmt::format("{}; \"{}\" holds what was recorded", status.message, path));
      break;
    default:
      throw CommandError(ExitCode::io, status.message);
  }
  return ending_code(status.reason);
}

// Runs `simulate` with a progress line, a log and an eye on Ctrl-C, then reports.
template <typename Simulate>
ExitCode run_watched(const RunChoice& choice, RunLog& log, const Simulate& simulate) {
  const Interrupt interrupt;
  const auto result = [&] {
    ProgressLine line(!choice.quiet);
    const auto show = [&](const RunProgress& p) {
      line.update(p.time / p.end_time, progress_text(p));
      log.note_progress(p);
    };
    try {
      return simulate(RunCallback(show), interrupt.token());
    } catch (const std::exception& error) {
      log.note_failure(error.what());
      throw;
    }
  }();
  log.note_end(result);
  if (!result.recorded && result.status.reason != RunReason::storage_failed) {
    throw CommandError(ending_code(result.status.reason),
                       fmt::format("{} at t = {:.4g} s, before it came further than \"{}\", which is as it was",
                                   result.status.message, result.status.time, choice.output));
  }
  const ExitCode code = report_ending(result.status, choice.output);
  if (!choice.quiet) print(summary_text(open_recording(choice.output)));
  if (log.problem().empty()) return code;
  say(log.problem());
  return code == ExitCode::ok ? ExitCode::io : code;
}

void check_log(OutputList& outputs, const RunChoice& choice) {
  outputs.add("the log", log_path(choice.output), FileKind::log);
}

// The recording of a new run.
void check_outputs(const RunChoice& choice) {
  OutputList outputs;
  for (const std::string& input : {choice.scenario.path, choice.resumed}) {
    if (!input.empty()) outputs.add_input(input);
  }
  outputs.add("--output", choice.output, FileKind::recording, ReadOnlyFiles::replaced);
  if (!choice.overwrite && find_destination(choice.output, FileKind::recording, ReadOnlyFiles::replaced).existing) {
    throw CommandError(ExitCode::io, fmt::format("\"{}\" exists already; --overwrite replaces it", choice.output));
  }
  check_log(outputs, choice);
}

// The recording that a run goes on with.
void check_continued(const RunChoice& choice) {
  OutputList outputs;
  if (!choice.scenario.path.empty()) outputs.add_input(choice.scenario.path);
  outputs.add_continued("--resume", choice.resumed, FileKind::recording, ReadOnlyFiles::replaced);
  if (!choice.overwrite &&
      is_read_only(find_destination(choice.resumed, FileKind::recording, ReadOnlyFiles::replaced))) {
    throw CommandError(ExitCode::io,
                       fmt::format("\"{}\" is read-only; --overwrite replaces it all the same", choice.resumed));
  }
  check_log(outputs, choice);
}

RunOptions run_options(const RunChoice& choice, const std::string& command_line) {
  return {choice.threads, choice.overwrite, program_version(), program_commit(), command_line};
}

ExitCode start(const RunChoice& choice, const std::string& command_line) {
  ScenarioChoice scenario_choice = choice.scenario;
  // A shorter run is a part of a valid one, even if something that the scenario waits for comes only later.
  const bool is_shorter = choice.until > 0 && choice.until < load_scenario(choice.scenario).output.end_time;
  if (choice.until > 0 && !is_shorter) {
    scenario_choice.settings.push_back(fmt::format("output.end_time={}", choice.until));
  }
  Scenario scenario = load_scenario(scenario_choice);
  if (is_shorter) scenario.output.end_time = choice.until;
  check_outputs(choice);
  RunLog log(log_path(choice.output));
  log.note_program(command_line, choice.threads);
  log.note_scenario(scenario, choice.output);
  return run_watched(choice, log, [&](const RunCallback& show, const std::stop_token& stop) {
    return run_to_recording(scenario, choice.output, run_options(choice, command_line), show, stop);
  });
}

Scenario valid(const ScenarioResult& recorded) {
  if (!recorded.ok()) throw CommandError(ExitCode::bad_input, recorded.diagnostics.text());
  return recorded.scenario;
}

// A scenario that is named along with --resume must be the recorded one; only the end may differ.
void require_same_scenario(const ScenarioChoice& choice, const Scenario& recorded, const std::string& path) {
  if (choice.path.empty()) {
    if (choice.settings.empty()) return;
    throw CommandError(ExitCode::usage, "--set needs a scenario; a resumed run keeps the one that was recorded");
  }
  const Scenario wanted = load_scenario(choice);
  for (const Parameter& parameter : parameters(recorded.system)) {
    if (parameter.key == "output.end_time" || parameter.get(wanted) == parameter.get(recorded)) continue;
    throw CommandError(ExitCode::bad_input, fmt::format("cannot resume \"{}\": {} is {} in \"{}\" and was {}", path,
                                                        parameter.key, toml_text(parameter, parameter.get(wanted)),
                                                        choice.path, toml_text(parameter, parameter.get(recorded))));
  }
}

// Also where links or another spelling lead to it.
bool is_same_place(const std::string& a, const std::string& b) {
  struct stat one = {}, other = {};
  return a == b || (stat(a.c_str(), &one) == 0 && stat(b.c_str(), &other) == 0 && is_same_file(one, other));
}

ExitCode resume(RunChoice choice, const std::string& command_line) {
  const bool in_place = choice.output.empty() || is_same_place(choice.output, choice.resumed);
  if (in_place) choice.output = choice.resumed;
  double time = 0;
  Scenario scenario;
  {
    const Recording recording = open_recording(choice.resumed);
    scenario = valid(recorded_scenario(recording));
    require_same_scenario(choice.scenario, scenario, choice.resumed);
    if (choice.until > 0) scenario.output.end_time = choice.until;
    if (recording.status().reason == RunReason::finished &&
        recording.status().time >= scenario.output.end_time - 1e-9) {
      print(fmt::format("\"{}\" is complete at t = {:.6g} s; --until goes on from there\n", choice.resumed,
                        recording.status().time));
      return ExitCode::ok;
    }
    if (!recording.checkpoint_times().empty()) time = recording.checkpoint_times().back();
  }
  if (in_place) {
    check_continued(choice);
    choice.overwrite = true;
  } else {
    check_outputs(choice);
  }
  RunLog log(log_path(choice.output));
  log.note_program(command_line, choice.threads);
  log.note_scenario(scenario, choice.output);
  log.note_resumed(choice.resumed, time);
  try {
    return run_watched(choice, log, [&](const RunCallback& show, const std::stop_token& stop) {
      return resume_recording(choice.resumed, choice.output, run_options(choice, command_line), choice.until, show,
                              stop);
    });
  } catch (const ResumeError& error) {
    throw CommandError(ExitCode::bad_input, fmt::format("cannot resume \"{}\": {}", choice.resumed, error.what()));
  }
}

}  // namespace

Action declare_run(CLI::App& app) {
  const auto choice = std::make_shared<RunChoice>();
  CLI::Option* scenario = add_scenario_options(app, choice->scenario);
  app.add_option("-o,--output", choice->output, "recording to write (HDF5); with --resume: instead of the same one")
      ->type_name("RUN.h5");
  app.add_option("--resume", choice->resumed, "go on with a recording from its last checkpoint")->type_name("RUN.h5");
  // One of the two is needed, which is checked when all is parsed.
  scenario->required(false);
  app.add_option("--until", choice->until, "simulated time at which the run ends, s; instead of output.end_time")
      ->type_name("T")
      ->check(positive_number())
      ->check(allowed_for("output.end_time"));
  app.add_option("--threads", choice->threads, "threads; the result is the same for any number")
      ->type_name("N")
      ->check(whole_number(1, 256))
      ->capture_default_str();
  app.add_flag("--overwrite", choice->overwrite, "replace an existing recording");
  app.add_flag("--quiet", choice->quiet, "no progress and no summary");
  app.footer(kRunExamples +
             exit_code_help({ExitCode::bad_input, ExitCode::diverged, ExitCode::io, ExitCode::interrupted}));
  return [choice](const std::string& command_line) {
    if (!choice->resumed.empty()) return resume(*choice, command_line);
    for (const auto& [value, name] : {std::pair(choice->scenario.path, "SCENARIO"), {choice->output, "--output"}}) {
      if (value.empty())
        throw CommandError(ExitCode::usage, fmt::format("{} is required; see netpocket run --help", name));
    }
    return start(*choice, command_line);
  };
}

}  // namespace netpocket
