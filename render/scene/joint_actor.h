#pragma once
// What sits on the tubes: joints and reels. Drawn larger than life, to be seen.

#include "engine/state/structure.h"
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
  std::vector<std::int32_t> joint_nodes_, reel_nodes_;
  std::vector<std::int32_t> reel_gradients_;  // along the tube; -1: none
  RepeatedMesh joints_;
  RepeatedMesh reels_;
};

}  // namespace netpocket
