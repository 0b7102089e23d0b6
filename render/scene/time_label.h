#pragma once
// The time and the phase of the capture, under the title.

#include "render/scene/overlay.h"
#include "render/scene/scene_actor.h"
#include "render/scene/scene_options.h"

namespace netpocket {

// "closing", "closed" or "towing"; "open" before closing starts.
std::string phase_name(const PhaseTimes& phases, double time);

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
