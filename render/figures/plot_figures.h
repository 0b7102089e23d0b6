#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "render/figures/figure_file.h"
#include "render/figures/paper_figures.h"

namespace netpocket {

struct PlotOptions {
  FigureFormat format = FigureFormat::png;
  std::vector<std::string> names;        // of figure_names(); empty: those that suit the runs
  double resolution = kPrintResolution;  // dots per inch, PNG only
  bool tables = false;                   // the numbers of each figure beside it, as CSV
};

// The figures that plot_figures() writes, in order; their tables are at table_beside(). A figure that is named twice is
// written once.
std::vector<std::filesystem::path> figure_files(const std::vector<RunSeries>& runs,
                                                const std::filesystem::path& directory, const PlotOptions& options);

// Writes DIRECTORY/NAME.FORMAT for each figure, with NAME.csv beside it if asked for, and returns the figures written,
// in order. Makes the directory when it is
// missing. All names are checked before anything is written. When stopped, those finished so far stay. Throws
// FigureError and FileError.
// With recordings: plot_figures(run_series(recordings), directory).
std::vector<std::filesystem::path> plot_figures(const std::vector<RunSeries>& runs,
                                                const std::filesystem::path& directory, const PlotOptions& options = {},
                                                const std::stop_token& stop = {});

}  // namespace netpocket
