#pragma once
// The directions of the world's axes, in the lower left corner.

#include <array>

#include "render/scene/overlay.h"
#include "render/scene/scene_actor.h"
#include "render/scene/scene_options.h"

namespace netpocket {

class AxesTriad final : public SceneActor {
 public:
  AxesTriad(const SceneOptions& options, const Color& text);

  void adapt(const View& view) override;

 private:
  void add_arrow(const Eigen::Vector2d& from, const Eigen::Vector2d& along, double unit, const Color& color);

  double annotation_scale_;
  OverlayShapes arrows_;
  std::array<OverlayText, 3> names_;
};

}  // namespace netpocket
