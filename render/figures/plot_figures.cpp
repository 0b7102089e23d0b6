#include "render/figures/plot_figures.h"

#include <fmt/format.h>

namespace netpocket {

std::vector<std::filesystem::path> plot_figures(const std::vector<RunSeries>& runs,
                                                const std::filesystem::path& directory, const PlotOptions& options) {
  const std::vector<std::string> names = options.names.empty() ? default_figure_names(runs.size()) : options.names;
  std::vector<Figure> figures;
  for (const std::string& name : names) figures.push_back(make_figure(name, runs));

  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) {
    throw FigureError(fmt::format("cannot make directory '{}': {}", directory.string(), error.message()));
  }
  std::vector<std::filesystem::path> files;
  for (std::size_t i = 0; i < names.size(); ++i) {
    files.push_back(directory / fmt::format("{}.{}", names[i], to_string(options.format)));
    save_figure(figures[i], files.back(), options.resolution);
  }
  return files;
}

}  // namespace netpocket
