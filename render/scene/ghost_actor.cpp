#include "render/scene/ghost_actor.h"

#include "render/scene/palette.h"

namespace netpocket {
namespace {

SceneOptions without_colors(SceneOptions options) {
  options.color_by = ColorBy::none;
  return options;
}

CordStyle ghost_style(const SceneOptions& options, std::vector<CableLook> looks, double width, double strength) {
  const auto& colors = palette(options.background);
  return {.name = {},
          .looks = std::move(looks),
          .color = mix(colors.background, colors.net, strength),
          .width = width * options.line_scale,
          .smallest_width = 0.7,
          .distance_color = colors.background,
          .fading = 0.4,
          .nearer = -0.002,  // behind the pocket while that has not moved
          .segments = 3};
}

}  // namespace

GhostActor::GhostActor(const Structure& structure, const SceneOptions& options)
    : no_scale_(structure, without_colors(options)),
      net_(structure, no_scale_, ghost_style(options, {CableLook::cord}, 0.7, 0.22)),
      frame_(structure, no_scale_, ghost_style(options, {CableLook::tube, CableLook::rope}, 2.0, 0.36)) {
  for (const auto* part : {&net_, &frame_}) {
    for (const auto& prop : part->props()) {
      prop->VisibilityOff();
      props_.push_back(prop);
    }
  }
}

void GhostActor::set_history(const SceneHistory& history) {
  for (const auto& prop : props_) prop->SetVisibility(history.initial.has_value());
  if (!history.initial) return;
  net_.update(*history.initial);
  frame_.update(*history.initial);
}

void GhostActor::adapt(const View& view) {
  net_.adapt(view);
  frame_.adapt(view);
}

}  // namespace netpocket
