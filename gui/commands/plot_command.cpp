#include <fmt/format.h>

#include <memory>

#include "engine/analysis/run_labels.h"
#include "engine/base/folder.h"
#include "engine/base/output_list.h"
#include "gui/commands/command.h"
#include "gui/commands/interrupt.h"
#include "gui/commands/notes.h"
#include "gui/commands/options.h"
#include "gui/commands/recordings.h"
#include "gui/commands/standard_streams.h"
#include "render/figures/plot_figures.h"

namespace netpocket {
namespace {

struct PlotChoice {
  std::vector<std::string> recordings;
  std::string output;
  std::vector<std::string> figures;
  std::string format = "png";
  double resolution = kPrintResolution;
};

std::string figure_list() {
  std::string text = "Figures:\n";
  for (const std::string& name : figure_names()) text += "  " + name + "\n";
  return text;
}

ExitCode plot(const PlotChoice& choice) {
  const std::vector<Recording> recordings = open_recordings(choice.recordings);
  const std::vector<RunSeries> runs = run_series(pointers(recordings));
  const PlotOptions options{figure_format(choice.format), choice.figures, choice.resolution};
  note_missing_letters(run_labels(pointers(recordings)));
  make_folder(choice.output);
  OutputList outputs;
  for (const std::string& recording : choice.recordings) outputs.add_input(recording);
  for (const auto& file : figure_files(runs, choice.output, options)) {
    outputs.add("--output", file.string(), file_kind(options.format));
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
  app.add_option("RUN.h5", choice->recordings, "recordings to draw")->required()->type_name("FILE");
  app.add_option("-o,--output", choice->output, "folder for the figures")->required()->type_name("DIR");
  app.add_option("--figure", choice->figures, "only this figure; may be repeated (default: all that suit the runs)")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->check(one_of(figure_names()));
  add_choice(app, "--format", choice->format, "file format", {"png", "svg", "pdf"});
  app.add_option("--dpi", choice->resolution, "dots per inch of PNG figures")
      ->type_name("N")
      ->check(number_between(20, 2400))
      ->capture_default_str();
  app.footer(figure_list() + R"(
Examples:
  netpocket plot case1.h5 -o figures
  netpocket plot case1.h5 case2.h5 case3.h5 -o figures --figure figure09_force --format svg

)" + exit_code_help({ExitCode::bad_input, ExitCode::io, ExitCode::rendering, ExitCode::interrupted}));
  return [choice](const std::string&) { return plot(*choice); };
}

}  // namespace netpocket
