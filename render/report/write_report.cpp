#include "render/report/write_report.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "render/figures/figure_file.h"
#include "render/figures/paper_figures.h"
#include "render/output/render_frames.h"
#include "render/output/render_sheet.h"
#include "render/output/whole_file.h"
#include "render/render_error.h"
#include "render/report/report_page.h"

namespace netpocket {
namespace {

namespace fs = std::filesystem;
using Recordings = std::vector<const Recording*>;

constexpr int kSheetPanels = 6;

// A folder that goes with the object.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string pattern = (fs::temp_directory_path() / "netpocket-report-XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw RenderError(fmt::format("cannot make a folder like {}", pattern));
    path_ = pattern;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

std::string content(const std::string& path) {
  std::stringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

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
  for (const auto& name : default_figure_names(runs.size())) {
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
  const ScratchFolder scratch;
  ReportMedia media;
  if (options.video) {
    auto video = video_options(recordings.size(), options);
    video.video = scratch.file("video.mp4");
    const auto times = frame_times(recordings, options.video_rate);
    if (render_frames(recordings, times, video, progress, stop) == RenderOutcome::cancelled) {
      return RenderOutcome::cancelled;
    }
    media.video = content(video.video);
  }
  const auto sheet = scratch.file("sheet.png");
  render_sheet(recordings, sheet_times(recordings), sheet, sheet_options(options), stop);
  if (stop.stop_requested()) return RenderOutcome::cancelled;
  media.sheet = content(sheet);
  media.figures = figures(recordings);
  WholeFile file(path);
  std::ofstream stream(file.temporary_path(), std::ios::binary);
  stream << report_page(recordings, media);
  stream.close();
  if (!stream) throw RenderError(fmt::format("cannot write {}", path));
  file.commit();
  return RenderOutcome::finished;
}

}  // namespace netpocket
