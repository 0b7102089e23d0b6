#include "render/output/write_gltf.h"

#include <fmt/format.h>

#include "engine/base/whole_file.h"
#include "render/output/gltf_document.h"
#include "render/output/run_renderer.h"
#include "render/render_error.h"
#include "render/scene/pocket_scene.h"

namespace netpocket {

void write_gltf(const Recording& recording, double time, const std::string& path, const SceneOptions& options) {
  if (recording.frame_count() == 0) throw RenderError(fmt::format("{} has no frame to draw", recording.path()));
  PocketScene scene(recording.structure(), options);
  if (options.trails || options.ghost) scene.set_history(recorded_history(recording));
  scene.update(recording.frame(recording.frame_at(time)));
  GltfDocument document;
  for (const auto& [name, actor] : scene.objects()) document.add(name, *actor);
  write_whole_file(path, FileKind::gltf, document.bytes());
}

}  // namespace netpocket
