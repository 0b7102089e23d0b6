#include <fmt/format.h>

#include <memory>

#include "engine/analysis/run_labels.h"
#include "engine/base/folder.h"
#include "engine/base/output_list.h"
#include "engine/study/study_folder.h"
#include "gui/commands/command.h"
#include "gui/commands/interrupt.h"
#include "gui/commands/notes.h"
#include "gui/commands/options.h"
#include "gui/commands/recordings.h"
#include "gui/commands/standard_streams.h"
#include "render/figures/figure_table.h"
#include "render/figures/plot_figures.h"
#include "render/figures/study_figures.h"

namespace netpocket {
namespace {

struct PlotChoice {
  std::vector<std::string> recordings;
  std::string output;
  std::vector<std::string> figures;
  std::string format = "png";
  double resolution = kPrintResolution;
  bool csv = false;
};

std::string figure_list() {
  std::string text = "Figures of recordings:\n";
  for (const std::string& name : figure_names()) text += "  " + name + "\n";
  text += "Figures of a study with uncertain inputs:\n";
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

ExitCode plot_study(const PlotChoice& choice) {
  if (choice.recordings.size() > 1) {
    throw CommandError(ExitCode::usage, "a study is drawn by itself: name one folder and nothing else");
  }
  const StudyResults results = load_results(choice.recordings.front());
  const FigureFormat format = figure_format(choice.format);
  make_folder(choice.output);
  const std::vector<std::string>& names = choice.figures.empty() ? study_figure_names() : choice.figures;
  std::vector<std::string> files;
  OutputList outputs;
  for (const std::string& name : names) {
    files.push_back(fmt::format("{}/{}.{}", choice.output, name, to_string(format)));
    outputs.add("--output", files.back(), file_kind(format));
    if (choice.csv) outputs.add("--csv", table_beside(files.back()).string(), FileKind::csv);
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Figure figure = make_study_figure(names[i], results);
    save_figure(figure, files[i], choice.resolution);
    if (choice.csv) save_figure_csv(figure, table_beside(files[i]));
  }
  return ExitCode::ok;
}

ExitCode plot(const PlotChoice& choice) {
  if (holds_study(choice.recordings.front())) return plot_study(choice);
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
  app.add_option("-o,--output", choice->output, "folder for the figures")->required()->type_name("DIR");
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
  app.footer(figure_list() + R"(
Examples:
  netpocket plot case1.h5 -o figures
  netpocket plot case1.h5 case2.h5 case3.h5 -o figures --figure figure09_force --format svg
  netpocket plot case1.h5 -o figures --figure energy --csv
  netpocket plot campaign -o figures --figure capture_map

)" + exit_code_help({ExitCode::bad_input, ExitCode::io, ExitCode::rendering, ExitCode::interrupted}));
  return [choice](const std::string&) { return plot(*choice); };
}

}  // namespace netpocket
