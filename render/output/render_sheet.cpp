#include "render/output/render_sheet.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analysis/run_labels.h"
#include "render/output/png_file.h"
#include "render/render_error.h"
#include "render/scene/time_label.h"

namespace netpocket {
namespace {

// (a) to (z), then (aa), (ab), ...
std::string letters(std::size_t index) {
  std::string text(1, static_cast<char>('a' + index % 26));
  return index < 26 ? text : letters(index / 26 - 1) + text;
}

std::string caption(std::size_t index, double time, const std::vector<Phase>& phases) {
  const auto label = fmt::format("({}) t = {:.4g} s", letters(index), time);
  const std::string phase = phase_name(phases, time);
  return phase.empty() ? label : fmt::format("{}, {}", label, phase);
}

int columns_of(const SheetOptions& options, std::size_t runs, std::size_t times) {
  if (runs > 1) return static_cast<int>(runs);
  const auto& frame = options.view.frame;
  const double aspect = static_cast<double>(frame.width) / frame.height;
  return options.columns.value_or(balanced_columns(static_cast<int>(times), aspect));
}

}  // namespace

RunView SheetOptions::panel_view() {
  RunView view;
  view.frame.width = 640;
  view.frame.height = 640;
  view.frame.supersampling = 3;
  view.frame.scene.time_label = false;
  view.frame.scene.line_scale = 1.15;
  view.frame.scene.annotation_scale = 1.25;
  return view;
}

void render_sheet(const Recording& recording, const std::vector<double>& times, const std::string& path,
                  const SheetOptions& options, const std::stop_token& stop) {
  render_sheet(std::vector{&recording}, times, path, options, stop);
}

std::optional<Image> draw_sheet(const std::vector<const Recording*>& recordings, const std::vector<double>& times,
                                const SheetOptions& options, const std::stop_token& stop) {
  if (recordings.empty() || times.empty()) throw RenderError("there are no times to draw");
  RunView view = options.view;
  // Without a legend nothing stands beside the pocket.
  if (view.frame.scene.color_by == ColorBy::none) view.share = {0.96, 0.92};
  view = common_view(recordings, view, times);
  SheetLayout layout = options.layout;
  // Captions of small panels must not run into each other.
  layout.caption_size = std::min(layout.caption_size, std::max(8, view.frame.width / 16));
  layout.columns = columns_of(options, recordings.size(), times.size());
  if (recordings.size() > 1) layout.headings = run_labels(recordings);
  std::vector<SheetPanel> panels(recordings.size() * times.size());
  // Run by run, because each has a scene of its own; row by row on the sheet.
  for (std::size_t run = 0; run < recordings.size(); ++run) {
    const auto& recording = *recordings[run];
    RunRenderer renderer(recording, view);
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (stop.stop_requested()) return std::nullopt;
      const std::size_t panel = i * recordings.size() + run;
      renderer.scene().show_annotations(panel == 0);
      const double shown = recording.times()[recording.frame_at(times[i])];
      panels[panel] = {smooth_frame(renderer.draw(times[i])), caption(panel, shown, renderer.scene_options().phases)};
    }
  }
  return make_contact_sheet(panels, layout);
}

void render_sheet(const std::vector<const Recording*>& recordings, const std::vector<double>& times,
                  const std::string& path, const SheetOptions& options, const std::stop_token& stop) {
  if (const auto sheet = draw_sheet(recordings, times, options, stop)) write_png(*sheet, path);
}

}  // namespace netpocket
