#include "render/scene/scene_options.h"

#include <fmt/format.h>

#include "render/render_error.h"

namespace netpocket {

ColorBy color_by_from_name(std::string_view name) {
  if (name == "none") return ColorBy::none;
  if (name == "tension") return ColorBy::tension;
  if (name == "strain") return ColorBy::strain;
  if (name == "speed") return ColorBy::speed;
  if (name == "contact") return ColorBy::contact;
  throw RenderError(fmt::format("cannot colour by '{}': use none, tension, strain, speed or contact", name));
}

Background background_from_name(std::string_view name) {
  if (name == "white") return Background::white;
  if (name == "space") return Background::space;
  throw RenderError(fmt::format("unknown background '{}': use white or space", name));
}

}  // namespace netpocket
