#pragma once
// What sits on the rods: a joint at each kink, a retractor at each tip. Drawn larger than life, to be seen.

#include "engine/recording/structure.h"
#include "render/scene/palette.h"
#include "render/scene/repeated_mesh.h"
#include "render/scene/scene_actor.h"

namespace netpocket {

class JointActor final : public SceneActor {
 public:
  JointActor(const Structure& structure, Background background);

  void update(const Snapshot& snapshot) override;
  std::string name() const override { return "joints"; }

 private:
  const Structure& structure_;
  // The gradient along the rod at each tip.
  std::vector<std::int32_t> tip_gradients_;
  RepeatedMesh kinks_;
  RepeatedMesh retractors_;
};

}  // namespace netpocket
