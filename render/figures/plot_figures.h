#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "render/figures/figure_file.h"
#include "render/figures/paper_figures.h"

namespace netpocket {

struct PlotOptions {
  FigureFormat format = FigureFormat::png;
  std::vector<std::string> names;        // of figure_names(); empty: those that suit the runs
  double resolution = kPrintResolution;  // dots per inch, PNG only
};

// Writes DIRECTORY/NAME.FORMAT for each figure and returns the files written, in order. Makes the directory when it is
// missing. All names are checked before anything is written. Throws FigureError.
// With recordings: plot_figures(run_series(recordings), directory).
std::vector<std::filesystem::path> plot_figures(const std::vector<RunSeries>& runs,
                                                const std::filesystem::path& directory,
                                                const PlotOptions& options = {});

}  // namespace netpocket
