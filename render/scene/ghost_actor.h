#pragma once
// The pocket as it was at the start, as pale lines behind the pocket as it is.

#include "render/scene/cord_actor.h"
#include "render/scene/scene_history.h"

namespace netpocket {

class GhostActor final : public SceneActor {
 public:
  GhostActor(const Structure& structure, const SceneOptions& options);

  void set_history(const SceneHistory& history);
  void adapt(const View& view) override;
  std::string name() const override { return "initial shape"; }

 private:
  ColorScale no_scale_;
  CordActor net_;
  CordActor frame_;  // rods and closing ropes
};

}  // namespace netpocket
