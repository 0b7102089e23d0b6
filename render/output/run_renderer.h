#pragma once
// Draws the frames of a recorded run, all framed and coloured alike.
// Thread contract: the thread that made it. The recording must outlive it and be used by nobody else meanwhile.

#include <optional>

#include "engine/recording/recording.h"
#include "render/output/frame_renderer.h"

namespace netpocket {

struct RunView {
  FrameOptions frame;  // absent ranges of colours and arrows and times of phases are taken from the run
  CameraPreset camera = CameraPreset::iso;
  FramingShare share;
  std::optional<CameraView> view;           // instead of a preset
  std::optional<CameraView> followed_view;  // of the preset `follow`: with the followed body's centre as the origin
  GlBackend backend = GlBackend::automatic;
};

// The view with everything filled in that pictures of these runs must have in common: ranges of colours and arrows, and
// where they are looked at from. What is seen at `times` (s) is in the picture as a whole; of the rest of the runs,
// what is seen at moments that are chosen evenly, and closer at the start. Throws RenderError when a recording has no
// frame.
RunView common_view(const std::vector<const Recording*>& recordings, RunView view,
                    const std::vector<double>& times = {});

// What trails and ghost are drawn from.
SceneHistory recorded_history(const Recording& recording);

class RunRenderer {
 public:
  // Throws RenderError when nothing can be drawn, also when the recording has no frame.
  RunRenderer(const Recording& recording, const RunView& view);

  // Draws the frame nearest to a time (s).
  DrawnFrame draw(double time, DrawnFrame used = {});

  // The scene's options with what was taken from the run.
  const SceneOptions& scene_options() const { return complete_.frame.scene; }
  PocketScene& scene() { return renderer_.scene(); }

 private:
  void aim(const Snapshot& snapshot);

  const Recording& recording_;
  RunView complete_;
  FrameRenderer renderer_;
};

}  // namespace netpocket
