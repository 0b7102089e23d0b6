#pragma once
// Draws the frames of a recorded run, all framed and coloured alike.
// Thread contract: the thread that made it. The recording must outlive it and be used by nobody else meanwhile.

#include <optional>

#include "engine/recording/recording.h"
#include "render/output/frame_renderer.h"

namespace netpocket {

struct RunView {
  FrameOptions frame;  // an absent range of colours or times of phases are taken from the run
  CameraPreset camera = CameraPreset::iso;
  FramingShare share;
  std::optional<CameraView> view;  // instead of a preset
  GlBackend backend = GlBackend::automatic;
};

class RunRenderer {
 public:
  // Throws RenderError when nothing can be drawn, also when the recording has no frame.
  RunRenderer(const Recording& recording, const RunView& view);

  // Draws the frame nearest to a time (s).
  DrawnFrame draw(double time, DrawnFrame used = {});

  // The scene's options with what was taken from the run.
  const SceneOptions& scene_options() const { return options_.scene; }
  PocketScene& scene() { return renderer_.scene(); }

 private:
  void aim(const Snapshot& snapshot);

  const Recording& recording_;
  FrameOptions options_;
  FrameRenderer renderer_;
  CameraView view_;
  bool follows_;
  Eigen::Vector3d followed_from_;  // m, where the followed body was when the view was framed
};

}  // namespace netpocket
