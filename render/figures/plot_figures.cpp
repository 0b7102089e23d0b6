#include "render/figures/plot_figures.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/folder.h"
#include "render/figures/figure_table.h"

namespace netpocket {
namespace {

// Each once.
std::vector<std::string> chosen_names(const PlotOptions& options, const std::vector<RunSeries>& runs) {
  if (options.names.empty()) return default_figure_names(runs);
  std::vector<std::string> names;
  for (const std::string& name : options.names) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

}  // namespace

std::vector<std::filesystem::path> figure_files(const std::vector<RunSeries>& runs,
                                                const std::filesystem::path& directory, const PlotOptions& options) {
  std::vector<std::filesystem::path> files;
  for (const std::string& name : chosen_names(options, runs)) {
    files.push_back(directory / fmt::format("{}.{}", name, to_string(options.format)));
  }
  return files;
}

std::vector<std::filesystem::path> plot_figures(const std::vector<RunSeries>& runs,
                                                const std::filesystem::path& directory, const PlotOptions& options,
                                                const std::stop_token& stop) {
  std::vector<Figure> figures;
  for (const std::string& name : chosen_names(options, runs)) figures.push_back(make_figure(name, runs));
  make_folder(directory.string());
  auto files = figure_files(runs, directory, options);
  std::size_t written = 0;
  for (; written < files.size() && !stop.stop_requested(); ++written) {
    save_figure(figures[written], files[written], options.resolution);
    if (options.tables) save_figure_csv(figures[written], table_beside(files[written]));
  }
  files.resize(written);
  return files;
}

}  // namespace netpocket
