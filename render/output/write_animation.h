#pragma once
// A whole capture as a three-dimensional animation for browsers, Blender and slides.

#include <stop_token>
#include <string>
#include <vector>

#include "engine/recording/recording.h"
#include "render/output/render_progress.h"

namespace netpocket {

struct AnimationOptions {
  int most_keys = 300;  // moments that are written; at least 2
};

// The frames that become keys: the first, the last, and every n-th between, with the least n that keeps to the limit.
std::vector<std::size_t> key_frames(std::size_t frame_count, int most_keys);

// Writes binary glTF 2.0 (.glb) with the animation "capture", in which a second is a second of the run. Spacecraft and
// target move and turn as they are; rods, cords and ropes through rings are skins on joints (animated_parts.h). Joints
// and bodies have their places at each key, in m, world frame, with Y along the pocket's axis; between keys viewers
// interpolate linearly. The file grows by 12 bytes for each node of a cord or rope and 28 for each ring of a rod and
// key. Needs no OpenGL. Errors: RenderError or FileError with one sentence; only a whole file is left. When stopped,
// nothing is written.
RenderOutcome write_animation(const Recording& recording, const std::string& path, const AnimationOptions& options = {},
                              const RenderProgressCallback& progress = {}, const std::stop_token& stop = {});

}  // namespace netpocket
