#include "render/output/write_animation.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/whole_file.h"
#include "engine/state/written_time.h"
#include "render/output/animated_parts.h"
#include "render/output/gltf_document.h"
#include "render/render_error.h"
#include "render/scene/pocket_scene.h"

namespace netpocket {
namespace {

constexpr double kCordWidth = 1.5e-3;  // of what cords and ropes span, so that they can be seen as a whole

// What the scene draws of a body, in body axes.
std::vector<std::size_t> body_meshes_in(GltfDocument& document, const PocketScene& scene, const std::string& body) {
  std::vector<std::size_t> meshes;
  for (const auto& [name, actor] : scene.objects()) {
    if (name != body) continue;
    if (const auto mesh = document.add_mesh(name, *actor)) meshes.push_back(*mesh);
  }
  return meshes;
}

}  // namespace

std::vector<std::size_t> key_frames(std::size_t frame_count, int most_keys) {
  std::vector<std::size_t> keys;
  if (frame_count == 0) return keys;
  const std::size_t most = static_cast<std::size_t>(std::max(most_keys, 2)), intervals = frame_count - 1;
  const std::size_t every = std::max<std::size_t>(1, (intervals + most - 2) / (most - 1));
  for (std::size_t frame = 0; frame < intervals; frame += every) keys.push_back(frame);
  keys.push_back(intervals);
  return keys;
}

RenderOutcome write_animation(const Recording& recording, const std::string& path, const AnimationOptions& options,
                              const RenderProgressCallback& progress, const std::stop_token& stop) {
  const std::vector<std::size_t> frames = key_frames(recording.frame_count(), options.most_keys);
  if (frames.empty()) throw RenderError(fmt::format("{} has no frame to export", recording.path()));
  const Structure& structure = recording.structure();
  const ProgressMeter meter(frames.size(), progress);
  AnimatedCords cords(structure);
  AnimatedRopes ropes(structure);
  AnimatedTubes tubes(structure);
  std::vector<GltfTrack> bodies;
  for (const StructureBody& body : structure.bodies) bodies.push_back({body.name, {}, {}});
  std::vector<float> times;
  for (const std::size_t frame : frames) {
    if (stop.stop_requested()) return RenderOutcome::cancelled;
    const Snapshot snapshot = recording.frame(frame);
    times.push_back(static_cast<float>(written_time(snapshot.time)));
    cords.add_key(snapshot);
    ropes.add_key(snapshot);
    tubes.add_key(snapshot);
    for (std::size_t i = 0; i < bodies.size(); ++i)
      bodies[i].add(snapshot.bodies[i].position, snapshot.bodies[i].attitude);
    meter.report(times.size());
  }
  const SceneOptions look;
  PocketScene scene(structure, look);
  scene.update(recording.frame(frames.front()));
  GltfDocument document;
  document.set_keys(times);
  for (const GltfTrack& body : bodies) document.add_moving(body, body_meshes_in(document, scene, body.name));
  tubes.add_to(document, palette(look.background));
  const Eigen::AlignedBox3d box = cords.box().merged(ropes.box());
  const double width = box.isEmpty() ? 0 : kCordWidth * box.sizes().maxCoeff();
  cords.add_to(document, palette(look.background), width);
  ropes.add_to(document, palette(look.background), 2 * width);
  write_whole_file(path, FileKind::gltf, document.bytes());
  return RenderOutcome::finished;
}

}  // namespace netpocket
