#pragma once
// The time and the phase of the capture, under the title.

#include "render/scene/overlay.h"
#include "render/scene/scene_actor.h"
#include "render/scene/scene_options.h"

namespace netpocket {

// Name of the phase at a time (s), such as "closing"; empty if there is none. Frames that lie a step short of the
// beginning of a phase count as in it.
std::string phase_name(const std::vector<Phase>& phases, double time);

class TimeLabel final : public SceneActor {
 public:
  TimeLabel(const SceneOptions& options, const Color& color);

  void update(const Snapshot& snapshot) override;
  void adapt(const View& view) override;

 private:
  SceneOptions options_;
  OverlayText title_;
  OverlayText time_;
  OverlayText phase_;
};

}  // namespace netpocket
