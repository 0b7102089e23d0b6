#include <fmt/format.h>

#include <memory>

#include "engine/analysis/run_labels.h"
#include "engine/base/output_list.h"
#include "engine/study/study_folder.h"
#include "gui/commands/command.h"
#include "gui/commands/interrupt.h"
#include "gui/commands/notes.h"
#include "gui/commands/options.h"
#include "gui/commands/progress_line.h"
#include "gui/commands/recordings.h"
#include "gui/commands/standard_streams.h"
#include "render/report/study_page.h"
#include "render/report/write_report.h"

namespace netpocket {
namespace {

constexpr const char* kReportHelp =
    R"(One HTML file that opens without a network: results, the capture as a sheet and a video, the paper's findings and
figures, and the scenarios. Several recordings stand next to each other. The page of a study's folder has the probability of
capture, a map on which each capture can be pointed at, and pictures of the worst and of typical captures.

Examples:
  netpocket report case1.h5 -o case1.html
  netpocket report case1.h5 case2.h5 case3.h5 -o cases.html
  netpocket report campaign -o campaign.html

)";

struct ReportChoice {
  std::vector<std::string> recordings;
  std::string output;
  std::string backend = "auto";
  bool no_video = false;
  double rate = ReportOptions{}.video_rate;
  bool quiet = false;
};

template <typename Write>
ExitCode write_with_progress(const ReportChoice& choice, const Write& write) {
  const Interrupt interrupt;
  const auto outcome = [&] {
    ProgressLine line(!choice.quiet);
    const auto show = [&](const RenderProgress& p) {
      line.update(static_cast<double>(p.done) / static_cast<double>(p.total),
                  fmt::format("picture {} of {}, {} left", p.done, p.total, duration_text(p.seconds_left)));
    };
    return write(show, interrupt.token());
  }();
  if (outcome == RenderOutcome::finished) return ExitCode::ok;
  say(fmt::format("interrupted; \"{}\" was not written", choice.output));
  return ExitCode::interrupted;
}

ExitCode report_study(const ReportChoice& choice) {
  if (choice.recordings.size() > 1) {
    throw CommandError(ExitCode::usage, "a study has a report of its own: name one folder and nothing else");
  }
  OutputList outputs;
  outputs.add("--output", choice.output, FileKind::html);
  StudyReportOptions options;
  options.picture.backend = gl_backend_from_name(choice.backend);
  return write_with_progress(choice, [&](const RenderProgressCallback& show, const std::stop_token& stop) {
    return write_study_report(choice.recordings.front(), choice.output, options, show, stop);
  });
}

ExitCode report(const ReportChoice& choice) {
  if (holds_study(choice.recordings.front())) return report_study(choice);
  const std::vector<Recording> recordings = open_recordings(choice.recordings);
  if (!choice.no_video) require_fewer_pictures(pointers(recordings), choice.rate);
  OutputList outputs;
  for (const std::string& recording : choice.recordings) outputs.add_input(recording);
  outputs.add("--output", choice.output, FileKind::html);
  note_missing_letters(run_labels(pointers(recordings)));
  const ReportOptions options{gl_backend_from_name(choice.backend), !choice.no_video, choice.rate};
  return write_with_progress(choice, [&](const RenderProgressCallback& show, const std::stop_token& stop) {
    return write_report(pointers(recordings), choice.output, options, show, stop);
  });
}

}  // namespace

Action declare_report(CLI::App& app) {
  const auto choice = std::make_shared<ReportChoice>();
  app.add_option("RUN.h5", choice->recordings, "recordings to report on, or the folder of a study")
      ->required()
      ->type_name("FILE");
  app.add_option("-o,--output", choice->output, "page to write")->required()->type_name("FILE.html");
  app.add_option("--fps", choice->rate, "pictures of the video per simulated second")
      ->type_name("N")
      ->check(number_between(kLowestRate, kHighestRate))
      ->capture_default_str();
  app.add_flag("--no-video", choice->no_video, "leave the video out; then ffmpeg is not needed");
  add_choice(app, "--backend", choice->backend, "OpenGL without a display", {"auto", "osmesa", "egl"});
  app.add_flag("--quiet", choice->quiet, "no progress");
  app.footer(kReportHelp +
             exit_code_help({ExitCode::bad_input, ExitCode::io, ExitCode::rendering, ExitCode::interrupted}));
  return [choice](const std::string&) { return report(*choice); };
}

}  // namespace netpocket
