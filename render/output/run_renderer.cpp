#include "render/output/run_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

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

Eigen::Vector3d followed_position(const Structure& structure, const Snapshot& snapshot) {
  const auto target = std::ranges::find(structure.bodies, BodyRole::target, &StructureBody::role);
  if (target != structure.bodies.end()) return snapshot.bodies[target - structure.bodies.begin()].position;
  return snapshot.positions.rowwise().mean();
}

// Frames by which a run is framed: at the given times, and evenly from the first to the last one. A thrown net is
// largest in its flight, a short time at the start of a long run: more frames lie there.
std::set<std::size_t> framed_by(const Recording& recording, const std::vector<double>& times) {
  constexpr std::size_t kEven = 12, kEarly = 24;
  const std::size_t last = recording.frame_count() - 1;
  std::set<std::size_t> frames;
  for (std::size_t i = 0; i <= kEven; ++i) frames.insert(i * last / kEven);
  for (std::size_t i = 0; i <= kEarly; ++i) frames.insert(i * i * last / (kEarly * kEarly));
  for (const double time : times) frames.insert(recording.frame_at(time));
  return frames;
}

// What must be in the picture, m: in the world, or from the followed body's centre.
Eigen::Matrix3Xd run_points(const std::vector<const Recording*>& recordings, const std::vector<double>& times,
                            bool followed) {
  Eigen::Matrix3Xd points(3, 0);
  for (const auto* recording : recordings) {
    for (const std::size_t frame : framed_by(*recording, times)) {
      const Snapshot snapshot = recording->frame(frame);
      Eigen::Matrix3Xd more = visible_points(recording->structure(), snapshot);
      if (followed) more.colwise() -= followed_position(recording->structure(), snapshot);
      points.conservativeResize(3, points.cols() + more.cols());
      points.rightCols(more.cols()) = more;
    }
  }
  return points;
}

}  // namespace

SceneHistory recorded_history(const Recording& recording) {
  return {recording.frame(0), body_paths(recording.structure(), [&](Channel c) -> const std::vector<double>& {
            return recording.channel(c);
          })};
}

RunView common_view(const std::vector<const Recording*>& recordings, RunView view, const std::vector<double>& times) {
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
  const bool follows = view.camera == CameraPreset::follow;
  std::optional<CameraView>& framed = follows ? view.followed_view : view.view;
  if (!view.view && !framed) {
    const double aspect = static_cast<double>(view.frame.width) / view.frame.height;
    framed = frame_view(view.camera, run_points(recordings, times, follows), aspect, view.share);
  }
  return view;
}

RunRenderer::RunRenderer(const Recording& recording, const RunView& view)
    : recording_(recording),
      complete_(completed(recording, view)),
      renderer_(make_gl_host(complete_.backend), recording.structure(), complete_.frame) {
  if (complete_.view) renderer_.set_view(*complete_.view);
  const auto& scene = complete_.frame.scene;
  if (scene.trails || scene.ghost) renderer_.scene().set_history(recorded_history(recording));
}

DrawnFrame RunRenderer::draw(double time, DrawnFrame used) {
  const auto snapshot = recording_.frame(recording_.frame_at(time));
  if (!complete_.view) aim(snapshot);
  return renderer_.draw(snapshot, std::move(used));
}

void RunRenderer::aim(const Snapshot& snapshot) {
  const Eigen::Vector3d followed = followed_position(recording_.structure(), snapshot);
  CameraView view = complete_.followed_view.value();
  view.position += followed;
  view.focal_point += followed;
  renderer_.set_view(view);
}

}  // namespace netpocket
