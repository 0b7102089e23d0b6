#pragma once
// The colour scale with its values, at the picture's right edge.

#include <vector>

#include "render/scene/color_scale.h"
#include "render/scene/overlay.h"
#include "render/scene/scene_actor.h"

namespace netpocket {

class Legend final : public SceneActor {
 public:
  Legend(const ColorScale& scale, const SceneOptions& options, const Color& text);

  void adapt(const View& view) override;

 private:
  const ColorScale& scale_;
  double annotation_scale_;
  Color text_color_;
  OverlayShapes bar_;
  OverlayText label_;
  std::vector<OverlayText> values_;
};

}  // namespace netpocket
