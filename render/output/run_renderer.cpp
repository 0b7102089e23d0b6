#include "render/output/run_renderer.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/scenario/read_scenario.h"
#include "render/render_error.h"
#include "render/scene/visible_points.h"

namespace netpocket {
namespace {

// Frames that are looked at before drawing, to choose the range of colours.
constexpr std::size_t kSampledFrames = 24;

// Mean over the run: a short peak must not take the colours of all other frames.
double sampled_high_value(const Recording& recording, ColorBy color_by) {
  const std::size_t count = recording.frame_count(), step = std::max<std::size_t>(1, count / kSampledFrames);
  double sum = 0;
  std::size_t samples = 0;
  for (std::size_t i = 0; i < count; i += step, ++samples) {
    sum += high_value(recording.structure(), recording.frame(i), color_by);
  }
  return sum / static_cast<double>(samples);
}

std::optional<PhaseTimes> recorded_phases(const Recording& recording) {
  const auto result = read_scenario_text(recording.origin().scenario_text, recording.path());
  return result.ok() ? std::optional(phase_times(result.scenario)) : std::nullopt;
}

FrameOptions completed(const Recording& recording, FrameOptions options) {
  if (recording.frame_count() == 0) throw RenderError(fmt::format("{} has no frame to draw", recording.path()));
  auto& scene = options.scene;
  if (!scene.phases) scene.phases = recorded_phases(recording);
  if (!scene.color_range && scene.color_by != ColorBy::none) {
    scene.color_range = ValueRange{0, round_up(sampled_high_value(recording, scene.color_by))};
  }
  return options;
}

// What is visible at the start and at the end: a view of it serves the whole run.
Eigen::Matrix3Xd run_points(const Recording& recording) {
  const auto& structure = recording.structure();
  const auto first = visible_points(structure, recording.frame(0));
  const auto last = visible_points(structure, recording.frame(recording.frame_count() - 1));
  Eigen::Matrix3Xd points(3, first.cols() + last.cols());
  points << first, last;
  return points;
}

Eigen::Vector3d followed_position(const Structure& structure, const Snapshot& snapshot) {
  const auto target = std::ranges::find(structure.bodies, BodyRole::target, &StructureBody::role);
  if (target != structure.bodies.end()) return snapshot.bodies[target - structure.bodies.begin()].position;
  return snapshot.positions.rowwise().mean();
}

}  // namespace

RunRenderer::RunRenderer(const Recording& recording, const RunView& view)
    : recording_(recording),
      options_(completed(recording, view.frame)),
      renderer_(make_gl_host(view.backend), recording.structure(), options_),
      follows_(view.camera == CameraPreset::follow && !view.view) {
  const auto first = recording.frame(0);
  followed_from_ = followed_position(recording.structure(), first);
  const auto points = follows_ ? visible_points(recording.structure(), first) : run_points(recording);
  view_ = view.view.value_or(frame_view(view.camera, points, renderer_.aspect(), view.share));
  renderer_.set_view(view_);
}

DrawnFrame RunRenderer::draw(double time, DrawnFrame used) {
  const auto snapshot = recording_.frame(recording_.frame_at(time));
  if (follows_) aim(snapshot);
  return renderer_.draw(snapshot, std::move(used));
}

void RunRenderer::aim(const Snapshot& snapshot) {
  const Eigen::Vector3d moved = followed_position(recording_.structure(), snapshot) - followed_from_;
  CameraView view = view_;
  view.position += moved;
  view.focal_point += moved;
  renderer_.set_view(view);
}

}  // namespace netpocket
