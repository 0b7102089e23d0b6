#pragma once
// One moment of a run as a three-dimensional model for Blender, browsers and slides.

#include <string>

#include "engine/recording/recording.h"
#include "render/scene/scene_options.h"

namespace netpocket {

// Writes binary glTF 2.0 (.glb): a named node for each thing in the scene, with normals and colours; what is not solid
// is blended; lines are unlit. World frame, m; the pocket's axis Y points up. Labels are left out. Shows the frame
// nearest to a time (s). Needs no OpenGL. Source: Khronos glTF 2.0 specification.
// Errors: RenderError or FileError with one sentence; only a whole file is left.
void write_gltf(const Recording& recording, double time, const std::string& path, const SceneOptions& options = {});

}  // namespace netpocket
