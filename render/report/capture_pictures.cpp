#include "render/report/capture_pictures.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <optional>

#include "engine/base/file_error.h"
#include "engine/capture/simulation.h"
#include "engine/study/record_files.h"
#include "engine/study/study_manifest.h"
#include "render/figures/study_figures.h"
#include "render/output/contact_sheet.h"
#include "render/output/frame_renderer.h"
#include "render/output/png_file.h"
#include "render/render_error.h"
#include "render/scene/visible_points.h"

namespace netpocket {
namespace {

constexpr std::size_t kInputsInCaption = 2;

// The last record of each point.
std::map<std::size_t, RecordPlace> places_by_point(const std::string& folder) {
  std::map<std::size_t, RecordPlace> places;
  scan_records(folder, [&places](const RecordPlace& place) { places[place.point] = place; });
  return places;
}

std::size_t point_at_row(const StudyResults& results, std::size_t row) {
  return static_cast<std::size_t>(results.points[row]);
}

// Which run of its point a row is: rows of a point follow each other by variant.
std::size_t run_of_row(const StudyResults& results, std::size_t row) {
  std::size_t first = row;
  while (first > 0 && results.points[first - 1] == results.points[row]) --first;
  return row - first;
}

class Scenarios {
 public:
  explicit Scenarios(const std::string& folder)
      : folder_(folder), manifest_(read_study_manifest(folder)), places_(places_by_point(folder)) {}

  Scenario at(std::size_t point, std::size_t run) {
    const auto place = places_.find(point);
    if (place == places_.end()) throw FileError(fmt::format("\"{}\" has no record of point {}", folder_, point));
    const StudyRecord record = reader_.read(place->second);
    StudyScenario made = recorded_scenario(manifest_, record, run);
    if (!made.diagnostics.ok()) {
      throw FileError(fmt::format("point {} cannot be run again: {}", point, made.diagnostics.text()));
    }
    if (!is_as_recorded(manifest_, record, manifest_.program)) {
      throw FileError(fmt::format("point {} cannot be run again as it was: its scenario or mesh has changed", point));
    }
    return std::move(made.scenario);
  }

 private:
  const std::string& folder_;
  StudyManifest manifest_;
  std::map<std::size_t, RecordPlace> places_;
  RecordReader reader_;
};

FrameOptions frame_options(const CapturePictureOptions& options) {
  FrameOptions frame;
  frame.width = frame.height = options.size;
  frame.supersampling = 3;
  frame.scene.time_label = false;
  frame.scene.axes = false;
  frame.scene.scale_bar = false;
  frame.scene.line_scale = 1.15;
  return frame;
}

// Nothing when it was stopped.
std::optional<Image> draw_end(const Scenario& scenario, const CapturePictureOptions& options,
                              const std::stop_token& stop) {
  Simulation simulation(scenario);
  const RunStatus status = simulation.advance(scenario.output.end_time, stop);
  if (status.reason == RunReason::stopped) return std::nullopt;
  const Snapshot snapshot = simulation.snapshot();
  FrameRenderer renderer(make_gl_host(options.backend), simulation.structure(), frame_options(options));
  renderer.set_view(
      frame_view(CameraPreset::iso, visible_points(simulation.structure(), snapshot), renderer.aspect(), {0.96, 0.92}));
  return renderer.render(snapshot);
}

std::string outcome_text(double captured) {
  return std::isnan(captured) ? "not judged" : captured == 1 ? "captured" : "missed";
}

std::string value_text(const ResultColumn& column, std::size_t row) {
  const std::string unit = column.unit.empty() || column.unit == "1" ? "" : " " + column.unit;
  const double value = column.values[row];
  return fmt::format("{} {}{:.3g}{}", column.name, value < 0 ? "\u2212" : "", std::abs(value), unit);
}

// Outcome, the ranked value and the inputs that decide most, a line each.
std::string capture_caption(const StudyResults& results, std::size_t row, const std::string& by) {
  std::string text = fmt::format("Point {}: {}\n{}", point_at_row(results, row), outcome_text(results.captured[row]),
                                 value_text(*results.find(by), row));
  std::size_t shown = 0;
  for (const InputInfluence& influence : input_influences(results)) {
    const ResultColumn& input = results.inputs[influence.input];
    if (std::isnan(input.values[row]) || shown++ >= kInputsInCaption) continue;
    text += "\n" + value_text(input, row);
  }
  return text;
}

}  // namespace

std::vector<Image> draw_captures(const std::string& folder, const StudyResults& results,
                                 const std::vector<std::size_t>& rows, const CapturePictureOptions& options,
                                 const RenderProgressCallback& progress, const std::stop_token& stop) {
  Scenarios scenarios(folder);
  const ProgressMeter meter(rows.size(), progress);
  std::vector<Image> pictures;
  for (const std::size_t row : rows) {
    auto picture = draw_end(scenarios.at(point_at_row(results, row), run_of_row(results, row)), options, stop);
    if (!picture) return {};
    pictures.push_back(std::move(*picture));
    meter.report(pictures.size());
  }
  return pictures;
}

RenderOutcome write_capture_sheet(const std::string& folder, const StudyResults& results, const std::string& path,
                                  const CaptureSheetOptions& options, const RenderProgressCallback& progress,
                                  const std::stop_token& stop) {
  const std::string& by = options.ranking.by;
  std::vector<std::size_t> rows = worst_captures(results, options.ranking, options.worst);
  const std::size_t worst = rows.size();
  for (const std::size_t row : typical_captures(results, by, options.typical)) rows.push_back(row);
  if (rows.empty()) throw RenderError(fmt::format("no capture has a number in a column \"{}\"", by));
  std::vector<Image> pictures = draw_captures(folder, results, rows, options.picture, progress, stop);
  if (pictures.size() < rows.size()) return RenderOutcome::cancelled;
  std::vector<SheetPanel> panels;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string kind = i < worst ? fmt::format("Worst {}. ", i + 1) : "Typical. ";
    panels.push_back({std::move(pictures[i]), kind + capture_caption(results, rows[i], by)});
  }
  SheetLayout layout;
  layout.columns = options.columns;
  layout.caption_size = std::max(10, options.picture.size / 24);
  write_png(make_contact_sheet(panels, layout), path);
  return RenderOutcome::finished;
}

}  // namespace netpocket
