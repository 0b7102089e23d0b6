#pragma once
// A bar of a round length, true at the distance of the camera's focal point.

#include "render/scene/overlay.h"
#include "render/scene/scene_actor.h"
#include "render/scene/scene_options.h"

namespace netpocket {

// World length of one pixel at the focal point, m.
double pixel_length(const View& view);

class ScaleBar final : public SceneActor {
 public:
  ScaleBar(const SceneOptions& options, const Color& color);

  void adapt(const View& view) override;

 private:
  double annotation_scale_;
  Color color_;
  OverlayShapes bar_;
  OverlayText label_;
};

}  // namespace netpocket
