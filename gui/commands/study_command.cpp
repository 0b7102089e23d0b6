#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <thread>

#include "engine/base/folder.h"
#include "engine/base/output_list.h"
#include "engine/base/whole_file.h"
#include "engine/scenario/parameter_text.h"
#include "engine/study/campaign_report.h"
#include "engine/study/draft_runs.h"
#include "engine/study/read_study.h"
#include "engine/study/run_study.h"
#include "engine/study/search_report.h"
#include "engine/study/study_folder.h"
#include "engine/study/study_status.h"
#include "gui/cluster/slurm.h"
#include "gui/cluster/slurm_study.h"
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

A campaign says what is uncertain, and ends with the probability of capture and its interval:

  sampling = "sobol"
  samples = 1000
  [uncertain]
  target.mass = { distribution = "normal", mean = 200, deviation = 20 }
  "target.position[0]" = { distribution = "uniform", min = -1.5, max = 1.5 }
  [until]
  half_width = 0.02

The folder, a new or empty one, gets study.csv (a row for each run), study_columns.csv (units and meanings), study.h5 (both in
one HDF5 file), study_timings.csv and study.json (everything, with the findings' rules). Points whose scenario is not valid are listed with the reason. Ctrl-C
keeps the points that are done; --resume goes on. scenarios/studies/README.md describes the file.

--part 3/8 runs the third of eight parts; others may run at the same time, here or on other machines, into the same folder.
The one that is last writes the tables. --status tells how far a folder is.

--slurm submits the parts to Slurm as a job array, and a job that puts the tables together when they have ended; the folder
must be one that all nodes see. --slurm --resume submits only the parts with points that are missing.

Examples:
  netpocket study scenarios/studies/pocket_shape.toml -o shapes --jobs 4
  netpocket study scenarios/studies/pocket_shape.toml -o shapes --jobs 4 --resume
  netpocket study scenarios/studies/findings.toml -o findings --report findings.md
  seq 8 | parallel netpocket study s.toml -o out --jobs 1 --quiet --part {}/8
  netpocket study --status out
  netpocket study s.toml -o out --slurm --parts 100 --partition compute --time 1:00:00

)";

struct StudyChoice {
  std::string study;
  std::string output;
  std::string report;
  std::string part;
  std::string status;
  int jobs = 1;
  bool resume = false;
  bool merge = false;
  bool slurm = false;
  int parts = 0;
  std::string partition, time;
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
  std::string text = fmt::format("{} of {} points done", outcome.points_done, outcome.points);
  if (outcome.refused > 0) text += fmt::format(", {} of them refused as not valid", outcome.refused);
  if (outcome.diverged > 0) text += fmt::format(", {} with a run that diverged", outcome.diverged);
  if (outcome.limited > 0) text += fmt::format(", {} with a run that reached its limit of steps", outcome.limited);
  if (outcome.has_tables) text += fmt::format("; \"{0}/study.csv\" and \"{0}/study.json\" hold them", folder);
  return text + "\n";
}

std::string throughput_text(const StudyOutcome& outcome, int jobs) {
  if (outcome.runs_made == 0 || !(outcome.wall_seconds > 0) || jobs == 0) return "";
  return fmt::format("{} captures in {}, {:.3g} a minute and job\n", outcome.runs_made,
                     duration_text(outcome.wall_seconds),
                     60 * static_cast<double>(outcome.runs_made) / outcome.wall_seconds / jobs);
}

// "3/8": part 3 of 8.
StudyPart parse_part(const std::string& text) {
  constexpr int kMostParts = 100000;
  StudyPart part;
  char rest = 0;
  const bool is_read = std::sscanf(text.c_str(), "%6d/%6d%c", &part.part, &part.parts, &rest) == 2;
  if (is_read && part.part >= 1 && part.part <= part.parts && part.parts <= kMostParts) return part;
  throw CommandError(
      ExitCode::usage,
      fmt::format("--part: expects PART/PARTS, such as 3/8 for the third of eight, not {}", netpocket::quoted(text)));
}

void check_outputs(const StudyChoice& choice) {
  OutputList outputs;
  outputs.add_input(choice.study);
  outputs.add("--output", choice.output + "/study.csv", FileKind::csv);
  outputs.add("--output", choice.output + "/study_columns.csv", FileKind::csv);
  outputs.add("--output", choice.output + "/study_estimates.csv", FileKind::csv);
  outputs.add("--output", choice.output + "/study_sensitivity.csv", FileKind::csv);
  outputs.add("--output", choice.output + "/study_optimisation.csv", FileKind::csv);
  outputs.add("--output", choice.output + "/study_rare.csv", FileKind::csv);
  outputs.add("--output", choice.output + "/study_timings.csv", FileKind::csv);
  outputs.add("--output", choice.output + "/study.json", FileKind::json);
  outputs.add("--output", choice.output + "/study.h5", FileKind::recording);
  if (!choice.report.empty()) outputs.add("--report", choice.report, FileKind::markdown);
}

void require_valid_point(const StudyOutcome& outcome) {
  if (!outcome.has_tables || outcome.points_done == 0 || outcome.refused < outcome.points_done) return;
  throw CommandError(ExitCode::bad_input, fmt::format("none of the {} points makes a valid scenario; the first: {}",
                                                      outcome.points, outcome.first_refusal));
}

// What goes together and what does not.
void check_choice(const StudyChoice& choice, const Study& study) {
  const bool is_part = !choice.part.empty() || choice.slurm;
  if (is_part && study.until.half_width > 0) {
    throw CommandError(ExitCode::bad_input, "a study that ends by [until] looks at all its points: it has no parts");
  }
  if ((is_part || choice.merge) && study.is_search()) {
    throw CommandError(ExitCode::bad_input,
                       "a study with [optimise] or [rare] chooses its points one after the other: "
                       "it has no parts");
  }
  if (choice.part.empty() && !choice.merge && !choice.resume && holds_study(choice.output)) {
    throw CommandError(ExitCode::io, fmt::format("\"{}\" holds a study already; --resume goes on with it, or name "
                                                 "another folder",
                                                 choice.output));
  }
  if (choice.merge && !holds_study(choice.output)) {
    throw CommandError(ExitCode::bad_input, fmt::format("\"{}\" holds no study to put together", choice.output));
  }
}

ExitCode show_status(const std::string& folder) {
  try {
    const StudyStatus status = study_status(folder);
    print(status_text(status) + slurm_status_text(folder, status));
  } catch (const FileError& error) {
    throw CommandError(ExitCode::bad_input, error.what());
  }
  return ExitCode::ok;
}

void print_outcome(const StudyChoice& choice, const Study& study, const StudyOutcome& outcome) {
  print(outcome_text(outcome, choice.output));
  print(throughput_text(outcome, choice.merge ? 0 : choice.jobs));
  print(draft_runs_text(study));
  if (outcome.optimisation) {
    print(optimisation_text(study, *outcome.optimisation));
    print(fmt::format("\"{}/best.toml\" is the scenario\n", choice.output));
  }
  if (outcome.rare_failure) print(rare_failure_text(study, *outcome.rare_failure));
  if (outcome.has_tables && !outcome.estimates.empty()) print(estimates_text(study, outcome.estimates));
  if (outcome.has_tables && !outcome.sensitivities.empty()) print(sensitivity_text(study, outcome.sensitivities));
}

std::string submission_text(const SlurmSubmission& made, const std::string& folder) {
  std::string text;
  if (made.alive > 0) text += fmt::format("{} parts with missing points are still in the queue\n", made.alive);
  if (made.missing == 0) text += "no point is missing; --merge puts the tables together\n";
  if (made.submitted.empty()) return text;
  return text + fmt::format(
                    "submitted {0} of {1} parts as job {2}, {3} points are missing; job {4} puts the tables together\n"
                    "\"{5}/slurm\" has their logs; netpocket study --status {5} tells how far they are\n",
                    made.submitted.size(), made.parts, made.array, made.missing, made.collector, folder);
}

ExitCode hand_over(const StudyChoice& choice, const Study& study) {
  try {
    const SlurmSubmission made =
        submit_study(study, {.study = choice.study,
                             .folder = choice.output,
                             .report = choice.report,
                             .parts = choice.parts,
                             .partition = choice.partition,
                             .time = choice.time,
                             .program = std::filesystem::read_symlink("/proc/self/exe").string(),
                             .version = std::string(program_version()) + program_commit()});
    if (!choice.quiet) print(submission_text(made, choice.output));
    return ExitCode::ok;
  } catch (const SlurmError& error) {
    throw CommandError(error.kind() == SlurmError::Kind::refused ? ExitCode::bad_input : ExitCode::io, error.what());
  }
}

std::string plain_report_of(const StudyChoice& choice, const Study& study, const StudyOutcome& outcome) {
  if (outcome.optimisation) return optimisation_report(study, *outcome.optimisation);
  if (outcome.rare_failure) return rare_failure_report(study, *outcome.rare_failure);
  const bool judges = study.has_findings || study.report.of == ReportOf::statements;
  if (judges) return study_report(study, outcome.records);
  return campaign_report(study, outcome, read_study_results(choice.output));
}

// Says below the title which results are drafts.
std::string report_of(const StudyChoice& choice, const Study& study, const StudyOutcome& outcome) {
  std::string text = plain_report_of(choice, study, outcome);
  const std::string drafts = draft_runs_text(study);
  const std::size_t title_end = text.find("\n\n");
  if (!drafts.empty() && title_end != std::string::npos) text.insert(title_end + 2, drafts + "\n");
  return text;
}

ExitCode run(const StudyChoice& choice, const std::string& command_line) {
  if (!choice.status.empty()) return show_status(choice.status);
  if (choice.study.empty()) throw CommandError(ExitCode::usage, "STUDY is required");
  if (choice.output.empty()) throw CommandError(ExitCode::usage, "--output is required");
  const StudyPart part = choice.part.empty() ? StudyPart{} : parse_part(choice.part);
  const Study study = load_study(choice.study);
  check_choice(choice, study);
  make_folder(choice.output);
  check_outputs(choice);
  if (choice.slurm) return hand_over(choice, study);
  const StudyOptions options = {.jobs = choice.merge ? 0 : choice.jobs,
                                .resume = choice.resume || choice.merge || part.parts > 1,
                                .version = program_version(),
                                .commit = program_commit(),
                                .command = command_line,
                                .part = part};
  const Interrupt interrupt;
  const StudyOutcome outcome = [&] {
    ProgressLine line(!choice.quiet);
    const auto show = [&](const StudyProgress& p) { line.update(p.fraction, progress_text(p)); };
    return run_study(study, choice.output, options, show, interrupt.token());
  }();
  if (!choice.quiet) print_outcome(choice, study, outcome);
  if (outcome.stopped && !choice.merge) {
    say("interrupted; the points that are done are kept, --resume goes on");
    return ExitCode::interrupted;
  }
  if (!choice.report.empty() && (study.has_findings || outcome.has_tables)) {
    write_whole_file(choice.report, FileKind::markdown, report_of(choice, study, outcome));
  }
  require_valid_point(outcome);
  return ExitCode::ok;
}

}  // namespace

Action declare_study(CLI::App& app) {
  const auto choice = std::make_shared<StudyChoice>();
  choice->jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  app.add_option("STUDY", choice->study, "study file (TOML)")->type_name("FILE");
  CLI::Option* output =
      app.add_option("-o,--output", choice->output, "folder to write; made when missing")->type_name("DIR");
  CLI::Option* jobs = app.add_option("--jobs", choice->jobs, "runs at a time; each takes one processor core")
                          ->type_name("N")
                          ->check(whole_number(1, 256))
                          ->capture_default_str();
  app.add_flag("--resume", choice->resume, "go on with a study in the same folder: only what is missing is run");
  CLI::Option* part =
      app.add_option("--part", choice->part, "only this part of the points, e.g. 3/8; what is done is kept")
          ->type_name("PART/PARTS");
  CLI::Option* merge =
      app.add_flag("--merge", choice->merge, "run nothing, only put the tables together from what is done")
          ->excludes(part);
  CLI::Option* slurm = app.add_flag("--slurm", choice->slurm, "submit the points to Slurm, as a job array of parts")
                           ->excludes(part)
                           ->excludes(merge)
                           ->excludes(jobs);
  app.add_option("--parts", choice->parts, "number of parts; default: twenty points each, at most 1000 parts")
      ->type_name("K")
      ->check(whole_number(1, 100000))
      ->needs(slurm);
  app.add_option("--partition", choice->partition, "partition of the cluster")->type_name("P")->needs(slurm);
  app.add_option("--time", choice->time, "time limit of a part, as sbatch takes it, e.g. 1:00:00")
      ->type_name("T")
      ->needs(slurm);
  app.add_option("--status", choice->status, "tell how far the study in this folder is")
      ->type_name("DIR")
      ->excludes(output);
  app.add_option("--report", choice->report, "also write what was found as a report (Markdown)")->type_name("FILE.md");
  app.add_flag("--quiet", choice->quiet, "no progress and no last line");
  app.footer(kStudyFooter + exit_code_help({ExitCode::bad_input, ExitCode::io, ExitCode::interrupted}));
  return [choice](const std::string& command_line) { return run(*choice, command_line); };
}

}  // namespace netpocket
