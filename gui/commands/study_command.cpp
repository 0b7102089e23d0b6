#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <thread>

#include "engine/base/folder.h"
#include "engine/base/output_list.h"
#include "engine/base/whole_file.h"
#include "engine/study/read_study.h"
#include "engine/study/run_study.h"
#include "engine/study/search_report.h"
#include "engine/study/study_folder.h"
#include "gui/commands/command.h"
#include "gui/commands/interrupt.h"
#include "gui/commands/options.h"
#include "gui/commands/progress_line.h"
#include "gui/commands/standard_streams.h"
#include "gui/commands/version.h"

namespace netpocket {
namespace {

constexpr const char* kStudyFooter =
    R"(A study names a base scenario, keys with lists or ranges, and variants to run at each point, for example:

  base = "../case1.toml"
  [vary]
  target.radius = { from = 4.0, to = 4.8, steps = 5 }
  contact.friction = [0.2, 0.4, 0.6]
  [[variant]]
  name = "slow"
  closing.duration = 10
  [[variant]]
  name = "fast"
  closing.duration = 5

The folder, a new or empty one, gets study.csv (a row for each run) and study.json (everything, with the findings' rules). Points whose
scenario is not valid are listed with the reason. Ctrl-C keeps the points that are done; --resume goes on.
scenarios/studies/README.md describes the file.

Examples:
  netpocket study scenarios/studies/pocket_shape.toml -o shapes --jobs 4
  netpocket study scenarios/studies/pocket_shape.toml -o shapes --jobs 4 --resume
  netpocket study scenarios/studies/findings.toml -o findings --report findings.md

)";

struct StudyChoice {
  std::string study;
  std::string output;
  std::string report;
  int jobs = 1;
  bool resume = false;
  bool quiet = false;
};

Study load_study(const std::string& path) {
  require_readable(path);
  StudyResult result = read_study_file(path);
  if (!result.ok()) throw CommandError(ExitCode::bad_input, result.diagnostics.text());
  return std::move(result.study);
}

std::string progress_text(const StudyProgress& progress) {
  return fmt::format("{} of {} points, {} left", progress.points_done, progress.points,
                     duration_text(seconds_left(progress.fraction, progress.wall_seconds)));
}

// What came out, one line each.
std::string outcome_text(const StudyOutcome& outcome, const std::string& folder) {
  std::size_t refused = 0;
  std::size_t unfinished = 0;
  for (const StudyRecord& record : outcome.records) {
    refused += record["runs"].empty() ? 1 : 0;
    for (const auto& run : record["runs"]) unfinished += run["reason"] == "finished" ? 0 : 1;
  }
  std::string text = fmt::format("{} of {} points done", outcome.records.size(), outcome.points);
  if (refused > 0) text += fmt::format(", {} of them refused as not valid", refused);
  if (unfinished > 0) text += fmt::format(", {} runs diverged", unfinished);
  return text + fmt::format("; \"{0}/study.csv\" and \"{0}/study.json\" hold them\n", folder);
}

void check_outputs(const StudyChoice& choice) {
  OutputList outputs;
  outputs.add_input(choice.study);
  outputs.add("--output", choice.output + "/study.csv", FileKind::csv);
  outputs.add("--output", choice.output + "/study.json", FileKind::json);
  if (!choice.report.empty()) outputs.add("--report", choice.report, FileKind::markdown);
}

void require_valid_point(const StudyOutcome& outcome) {
  const auto is_valid = [](const StudyRecord& record) { return !record["runs"].empty(); };
  if (outcome.records.empty() || std::any_of(outcome.records.begin(), outcome.records.end(), is_valid)) return;
  throw CommandError(ExitCode::bad_input,
                     fmt::format("none of the {} points makes a valid scenario; the first: {}", outcome.points,
                                 outcome.records.front()["refused"].get<std::string>()));
}

ExitCode run(const StudyChoice& choice, const std::string& command_line) {
  const Study study = load_study(choice.study);
  make_folder(choice.output);
  if (!choice.resume && holds_study(choice.output)) {
    throw CommandError(ExitCode::io, fmt::format("\"{}\" holds a study already; --resume goes on with it, or name "
                                                 "another folder",
                                                 choice.output));
  }
  check_outputs(choice);
  const StudyOptions options = {choice.jobs, choice.resume, program_version(), program_commit(), command_line};
  const Interrupt interrupt;
  const StudyOutcome outcome = [&] {
    ProgressLine line(!choice.quiet);
    const auto show = [&](const StudyProgress& p) { line.update(p.fraction, progress_text(p)); };
    return run_study(study, choice.output, options, show, interrupt.token());
  }();
  if (!choice.quiet) print(outcome_text(outcome, choice.output));
  if (outcome.stopped) {
    say("interrupted; the points that are done are kept, --resume goes on");
    return ExitCode::interrupted;
  }
  if (!choice.report.empty()) write_whole_file(choice.report, FileKind::markdown, study_report(study, outcome.records));
  require_valid_point(outcome);
  return ExitCode::ok;
}

}  // namespace

Action declare_study(CLI::App& app) {
  const auto choice = std::make_shared<StudyChoice>();
  choice->jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  app.add_option("STUDY", choice->study, "study file (TOML)")->required()->type_name("FILE");
  app.add_option("-o,--output", choice->output, "folder to write; made when missing")->required()->type_name("DIR");
  app.add_option("--jobs", choice->jobs, "runs at a time; each takes one processor core")
      ->type_name("N")
      ->check(whole_number(1, 256))
      ->capture_default_str();
  app.add_flag("--resume", choice->resume, "go on with a study in the same folder: only what is missing is run");
  app.add_option("--report", choice->report, "also write what was found as a report (Markdown)")->type_name("FILE.md");
  app.add_flag("--quiet", choice->quiet, "no progress and no last line");
  app.footer(kStudyFooter + exit_code_help({ExitCode::bad_input, ExitCode::io, ExitCode::interrupted}));
  return [choice](const std::string& command_line) { return run(*choice, command_line); };
}

}  // namespace netpocket
