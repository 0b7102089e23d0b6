#include "render/output/render_sheet.h"

#include <fmt/format.h>

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

std::string caption(std::size_t index, double time, const std::optional<PhaseTimes>& phases) {
  const auto label = fmt::format("({}) t = {:.4g} s", letters(index), time);
  return phases ? fmt::format("{}, {}", label, phase_name(*phases, time)) : label;
}

}  // namespace

RunView SheetOptions::panel_view() {
  RunView view;
  view.frame.width = 800;
  view.frame.height = 640;
  view.frame.supersampling = 3;
  view.frame.scene.time_label = false;
  view.frame.scene.line_scale = 1.15;
  view.frame.scene.annotation_scale = 1.25;
  return view;
}

void render_sheet(const Recording& recording, const std::vector<double>& times, const std::string& path,
                  const SheetOptions& options, const std::stop_token& stop) {
  if (times.empty()) throw RenderError("there are no times to draw");
  RunView view = options.view;
  // Without a legend nothing stands beside the pocket.
  if (view.frame.scene.color_by == ColorBy::none) view.share = {0.96, 0.92};
  RunRenderer renderer(recording, view);
  std::vector<SheetPanel> panels;
  for (const double time : times) {
    if (stop.stop_requested()) return;
    renderer.scene().show_annotations(panels.empty());
    const double shown = recording.times()[recording.frame_at(time)];
    auto image = smooth_frame(renderer.draw(time));
    panels.push_back({std::move(image), caption(panels.size(), shown, renderer.scene_options().phases)});
  }
  write_png(make_contact_sheet(panels, options.layout), path);
}

}  // namespace netpocket
