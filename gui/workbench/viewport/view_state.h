#pragma once
// Everything a picture of the viewport is made of, as a value: it can go to another thread. What a pointer holds is
// never changed, so equal pointers mean equal content.

#include <memory>

#include "engine/state/snapshot.h"
#include "engine/state/structure.h"
#include "render/scene/camera.h"
#include "render/scene/scene_history.h"
#include "render/scene/scene_options.h"

namespace netpocket {

struct ViewState {
  std::shared_ptr<const Structure> structure;  // null: nothing is shown
  std::shared_ptr<const Snapshot> snapshot;    // fits the structure
  std::shared_ptr<const SceneOptions> options;
  std::shared_ptr<const SceneHistory> history;  // null: nothing of other moments is shown
  CameraView camera;
  bool draft = false;  // drawn quickly, whatever the options say of smoothing

  bool complete() const { return structure && snapshot && options; }
  bool smoothed() const { return options && options->fast_smoothing && !draft; }
};

}  // namespace netpocket
