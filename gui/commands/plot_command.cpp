#include <fmt/format.h>

#include <memory>

#include "engine/analysis/run_labels.h"
#include "engine/base/folder.h"
#include "engine/base/output_list.h"
#include "engine/study/draft_runs.h"
#include "engine/study/study_folder.h"
#include "engine/study/study_manifest.h"
#include "gui/commands/command.h"
#include "gui/commands/interrupt.h"
#include "gui/commands/notes.h"
#include "gui/commands/options.h"
#include "gui/commands/progress_line.h"
#include "gui/commands/recordings.h"
#include "gui/commands/spelling.h"
#include "gui/commands/standard_streams.h"
#include "gui/commands/version.h"
#include "render/figures/figure_table.h"
#include "render/figures/plot_figures.h"
#include "render/figures/rich_text.h"
#include "render/figures/study_figures.h"
#include "render/report/capture_pictures.h"

namespace netpocket {
namespace {

struct PlotChoice {
  std::vector<std::string> recordings;
  std::string output;
  std::vector<std::string> figures;
  std::string format = "png";
  double resolution = kPrintResolution;
  bool csv = false;
  std::string sheet;
  CaptureRanking ranking;
  bool quiet = false;
};

std::string figure_list() {
  std::string text = "Figures of recordings:\n";
  for (const std::string& name : figure_names()) text += "  " + name + "\n";
  text += "Figures of a study:\n";
  for (const std::string& name : study_figure_names()) text += "  " + name + "\n";
  return text;
}

std::vector<std::string> all_figure_names() {
  std::vector<std::string> names = figure_names();
  names.insert(names.end(), study_figure_names().begin(), study_figure_names().end());
  return names;
}

StudyResults load_results(const std::string& folder) {
  try {
    return read_study_results(folder);
  } catch (const FileError& error) {
    throw CommandError(ExitCode::bad_input, error.what());
  }
}

std::vector<std::string> column_names(const StudyResults& results) {
  std::vector<std::string> names;
  for (const auto* columns : {&results.measures, &results.inputs}) {
    for (const ResultColumn& column : *columns) names.push_back(column.name);
  }
  return names;
}

ExitCode draw_capture_sheet(const PlotChoice& choice, const StudyResults& results) {
  const std::string& folder = choice.recordings.front();
  OutputList outputs;
  outputs.add("--sheet", choice.sheet, FileKind::png);
  if (read_study_manifest(folder).program != std::string(program_version()) + program_commit()) {
    say("another version of the program ran this study: its captures run again may differ a little");
  }
  CaptureSheetOptions options;
  options.ranking = choice.ranking;
  const Interrupt interrupt;
  const auto outcome = [&] {
    ProgressLine line(!choice.quiet);
    const auto show = [&line](const RenderProgress& p) {
      line.update(static_cast<double>(p.done) / static_cast<double>(p.total),
                  fmt::format("capture {} of {}, {} left", p.done, p.total, duration_text(p.seconds_left)));
    };
    return write_capture_sheet(folder, results, choice.sheet, options, show, interrupt.token());
  }();
  if (outcome == RenderOutcome::finished) return ExitCode::ok;
  say(fmt::format("interrupted; \"{}\" was not written", choice.sheet));
  return ExitCode::interrupted;
}

ExitCode plot_study(const PlotChoice& choice) {
  if (choice.recordings.size() > 1) {
    throw CommandError(ExitCode::usage, "a study is drawn by itself: name one folder and nothing else");
  }
  const std::string& folder = choice.recordings.front();
  const StudyResults results = load_results(folder);
  if (!choice.sheet.empty() && results.find(choice.ranking.by) == nullptr) {
    throw CommandError(ExitCode::bad_input,
                       fmt::format("--by: \"{}\" has no column \"{}\" with numbers{}", folder, choice.ranking.by,
                                   suggestion(choice.ranking.by, column_names(results))));
  }
  if (choice.output.empty()) return draw_capture_sheet(choice, results);
  const FigureFormat format = figure_format(choice.format);
  make_folder(choice.output);
  const std::vector<std::string> names = choice.figures.empty() ? suitable_study_figures(results) : choice.figures;
  std::vector<std::string> files;
  OutputList outputs;
  for (const std::string& name : names) {
    files.push_back(fmt::format("{}/{}.{}", choice.output, name, to_string(format)));
    outputs.add("--output", files.back(), file_kind(format));
    if (choice.csv) outputs.add("--csv", table_beside(files.back()).string(), FileKind::csv);
  }
  const std::string drafts = recorded_drafts_text(folder);
  for (std::size_t i = 0; i < names.size(); ++i) {
    Figure figure = make_study_figure(names[i], results);
    figure.note = plain_text(drafts);
    save_figure(figure, files[i], choice.resolution);
    if (choice.csv) save_figure_csv(figure, table_beside(files[i]));
  }
  return choice.sheet.empty() ? ExitCode::ok : draw_capture_sheet(choice, results);
}

ExitCode plot(const PlotChoice& choice) {
  if (choice.output.empty() && choice.sheet.empty()) throw CommandError(ExitCode::usage, "--output is required");
  if (holds_study(choice.recordings.front())) return plot_study(choice);
  if (!choice.sheet.empty()) {
    throw CommandError(ExitCode::usage,
                       "--sheet draws captures of a study: name its folder (netpocket render --sheet "
                       "draws a recording)");
  }
  const std::vector<Recording> recordings = open_recordings(choice.recordings);
  const std::vector<RunSeries> runs = run_series(pointers(recordings));
  const PlotOptions options{figure_format(choice.format), choice.figures, choice.resolution, choice.csv};
  note_missing_letters(run_labels(pointers(recordings)));
  make_folder(choice.output);
  OutputList outputs;
  for (const std::string& recording : choice.recordings) outputs.add_input(recording);
  for (const auto& file : figure_files(runs, choice.output, options)) {
    outputs.add("--output", file.string(), file_kind(options.format));
    if (choice.csv) outputs.add("--csv", table_beside(file).string(), FileKind::csv);
  }
  const Interrupt interrupt;
  plot_figures(runs, choice.output, options, interrupt.token());
  if (!interrupt.token().stop_requested()) return ExitCode::ok;
  say("interrupted; the figures finished so far are kept");
  return ExitCode::interrupted;
}

}  // namespace

Action declare_plot(CLI::App& app) {
  const auto choice = std::make_shared<PlotChoice>();
  app.add_option("RUN.h5", choice->recordings, "recordings to draw, or the folder of a study")
      ->required()
      ->type_name("FILE");
  app.add_option("-o,--output", choice->output, "folder for the figures")->type_name("DIR");
  app.add_option("--figure", choice->figures, "only this figure; may be repeated (default: all that suit the runs)")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->check(one_of(all_figure_names()));
  add_choice(app, "--format", choice->format, "file format", {"png", "svg", "pdf"});
  app.add_option("--dpi", choice->resolution, "dots per inch of PNG figures")
      ->type_name("N")
      ->check(number_between(20, 2400))
      ->capture_default_str();
  app.add_flag("--csv", choice->csv, "also the numbers of each figure, in NAME.csv beside it");
  app.add_option("--sheet", choice->sheet,
                 "of a study: run its twelve worst and four typical captures again and draw them")
      ->type_name("FILE.png");
  app.add_option("--by", choice->ranking.by, "column by which captures of the sheet are bad: small numbers are")
      ->type_name("COLUMN")
      ->capture_default_str();
  app.add_flag("--largest", choice->ranking.largest_is_worst, "large numbers are bad, as of a load");
  app.add_flag("--quiet", choice->quiet, "no progress");
  app.footer(figure_list() + R"(
Examples:
  netpocket plot case1.h5 -o figures
  netpocket plot case1.h5 case2.h5 case3.h5 -o figures --figure figure09_force --format svg
  netpocket plot case1.h5 -o figures --figure energy --csv
  netpocket plot campaign -o figures --figure capture_map
  netpocket plot campaign --sheet worst.png
  netpocket plot campaign --sheet loads.png --by load_body --largest

)" + exit_code_help({ExitCode::bad_input, ExitCode::io, ExitCode::rendering, ExitCode::interrupted}));
  return [choice](const std::string&) { return plot(*choice); };
}

}  // namespace netpocket
