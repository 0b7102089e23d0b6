#include "render/report/write_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/whole_file.h"
#include "render/figures/figure_file.h"
#include "render/figures/paper_figures.h"
#include "render/output/png_file.h"
#include "render/output/render_frames.h"
#include "render/output/render_sheet.h"
#include "render/render_error.h"
#include "render/report/report_page.h"

namespace netpocket {
namespace {

using Recordings = std::vector<const Recording*>;

constexpr int kSheetPanels = 6;

std::vector<double> sheet_times(const Recordings& recordings) {
  double start = recordings.front()->times().front(), end = start;
  for (const auto* recording : recordings) end = std::max(end, recording->times().back());
  std::vector<double> times;
  for (int i = 0; i < kSheetPanels; ++i) times.push_back(start + (end - start) * i / (kSheetPanels - 1));
  return times;
}

RenderOptions video_options(std::size_t runs, const ReportOptions& options) {
  RenderOptions render;
  render.view.backend = options.backend;
  render.view.frame.width = runs == 1 ? 960 : 480;
  render.view.frame.height = runs == 1 ? 540 : 480;
  render.video_rate = options.video_rate;
  return render;
}

SheetOptions sheet_options(const ReportOptions& options) {
  SheetOptions sheet;
  sheet.view.backend = options.backend;
  return sheet;
}

std::vector<std::pair<std::string, std::string>> figures(const Recordings& recordings) {
  const auto runs = run_series(recordings);
  std::vector<std::pair<std::string, std::string>> drawn;
  for (const auto& name : default_figure_names(runs)) {
    drawn.emplace_back(name, encode_figure(make_figure(name, runs), FigureFormat::svg));
  }
  return drawn;
}

}  // namespace

RenderOutcome write_report(const Recordings& recordings, const std::string& path, const ReportOptions& options,
                           const RenderProgressCallback& progress, const std::stop_token& stop) {
  if (recordings.empty()) throw RenderError("a report needs a recording");
  for (const auto* recording : recordings) {
    if (recording->frame_count() == 0) throw RenderError(fmt::format("{} has no frame to draw", recording->path()));
  }
  ReportMedia media;
  if (options.video) {
    auto video = video_options(recordings.size(), options);
    video.video = path;
    video.video_bytes = &media.video;
    const auto times = frame_times(recordings, options.video_rate);
    if (render_frames(recordings, times, video, progress, stop) == RenderOutcome::cancelled) {
      return RenderOutcome::cancelled;
    }
  }
  const auto sheet = draw_sheet(recordings, sheet_times(recordings), sheet_options(options), stop);
  if (!sheet) return RenderOutcome::cancelled;
  media.sheet = png_bytes(*sheet);
  media.figures = figures(recordings);
  write_whole_file(path, FileKind::html, report_page(recordings, media));
  return RenderOutcome::finished;
}

}  // namespace netpocket
