#pragma once
// A camera of one's own as a text file (TOML):
//   position = [30.0, 20.0, 35.0]   # m, world
//   focal_point = [0.0, 5.0, 0.0]   # m, world
//   view_up = [0.0, 1.0, 0.0]       # optional
//   view_angle = 26.0               # degrees, vertical; or half_height, m: parallel projection

#include <string>
#include <string_view>

#include "render/scene/camera.h"

namespace netpocket {

// Throws RenderError with one sentence that names the file, the line and what is wrong.
CameraView read_view_file(const std::string& path);
// `name` stands for the file in messages.
CameraView read_view_text(std::string_view text, const std::string& name);

std::string view_text(const CameraView& view);

}  // namespace netpocket
