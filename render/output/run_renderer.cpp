#include "render/output/run_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "engine/scenario/read_scenario.h"
#include "render/render_error.h"
#include "render/scene/visible_points.h"

namespace netpocket {
namespace {

// Frames that are looked at before drawing, to choose the range of colours.
constexpr std::size_t kSampledFrames = 24;

// Mean over frames of the run where there is something to see: a short peak must not take the colours of all others.
double sampled_mean(const Recording& recording, const std::function<double(const Snapshot&)>& high_value) {
  const std::size_t count = recording.frame_count(), step = std::max<std::size_t>(1, count / kSampledFrames);
  double sum = 0;
  std::size_t samples = 0;
  for (std::size_t i = 0; i < count; i += step) {
    const double value = high_value(recording.frame(i));
    sum += value;
    samples += value > 0;
  }
  return samples ? sum / static_cast<double>(samples) : 0;
}

// The largest over some runs.
double sampled_mean(const std::vector<const Recording*>& recordings,
                    const std::function<double(const Structure&, const Snapshot&)>& high_value) {
  double largest = 0;
  for (const auto* recording : recordings) {
    const auto value = [&](const Snapshot& snapshot) { return high_value(recording->structure(), snapshot); };
    largest = std::max(largest, sampled_mean(*recording, value));
  }
  return largest;
}

RunView completed(const Recording& recording, const RunView& view) {
  RunView complete = common_view({&recording}, view);
  auto& scene = complete.frame.scene;
  if (scene.phases.empty()) scene.phases = recording.origin().phases;
  return complete;
}

// What is visible at the start, at the end and at moments between: a view of it serves the whole run. A thrown net is
// largest in the middle of its flight.
Eigen::Matrix3Xd run_points(const std::vector<const Recording*>& recordings) {
  Eigen::Matrix3Xd points(3, 0);
  for (const auto* recording : recordings) {
    constexpr std::size_t kMoments = 12;
    for (std::size_t i = 0; i <= kMoments; ++i) {
      const std::size_t frame = i * (recording->frame_count() - 1) / kMoments;
      const auto more = visible_points(recording->structure(), recording->frame(frame));
      points.conservativeResize(3, points.cols() + more.cols());
      points.rightCols(more.cols()) = more;
    }
  }
  return points;
}

Eigen::Vector3d followed_position(const Structure& structure, const Snapshot& snapshot) {
  const auto target = std::ranges::find(structure.bodies, BodyRole::target, &StructureBody::role);
  if (target != structure.bodies.end()) return snapshot.bodies[target - structure.bodies.begin()].position;
  return snapshot.positions.rowwise().mean();
}

}  // namespace

SceneHistory recorded_history(const Recording& recording) {
  return {recording.frame(0), body_paths(recording.structure(), [&](Channel c) -> const std::vector<double>& {
            return recording.channel(c);
          })};
}

RunView common_view(const std::vector<const Recording*>& recordings, RunView view) {
  for (const auto* recording : recordings) {
    if (recording->frame_count() == 0) throw RenderError(fmt::format("{} has no frame to draw", recording->path()));
  }
  auto& scene = view.frame.scene;
  if (!scene.color_range && scene.color_by != ColorBy::none) {
    const auto high = [&](const auto& structure, const auto& snapshot) {
      return high_value(structure, snapshot, scene.color_by);
    };
    scene.color_range = ValueRange{0, round_up(sampled_mean(recordings, high))};
  }
  if (scene.contact_arrows && !scene.arrow_force) {
    const auto high = [](const auto&, const auto& snapshot) { return high_contact_force(snapshot); };
    scene.arrow_force = round_up(sampled_mean(recordings, high));
  }
  if (!view.view && view.camera != CameraPreset::follow) {
    const double aspect = static_cast<double>(view.frame.width) / view.frame.height;
    view.view = frame_view(view.camera, run_points(recordings), aspect, view.share);
  }
  return view;
}

RunRenderer::RunRenderer(const Recording& recording, const RunView& view)
    : recording_(recording),
      complete_(completed(recording, view)),
      renderer_(make_gl_host(complete_.backend), recording.structure(), complete_.frame),
      follows_(!complete_.view) {
  const auto first = recording.frame(0);
  followed_from_ = followed_position(recording.structure(), first);
  view_ = complete_.view.value_or(
      frame_view(complete_.camera, visible_points(recording.structure(), first), renderer_.aspect(), complete_.share));
  renderer_.set_view(view_);
  const auto& scene = complete_.frame.scene;
  if (scene.trails || scene.ghost) renderer_.scene().set_history(recorded_history(recording));
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
