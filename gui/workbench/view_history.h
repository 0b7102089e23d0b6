#pragma once
// What a view shows of other moments of a run: the paths so far and the pocket as it was at the start.
// Thread contract: the user interface's thread.

#include <memory>

#include "gui/workbench/session/run.h"
#include "render/scene/scene_history.h"
#include "render/scene/scene_options.h"

namespace netpocket {

class ViewHistory {
 public:
  // Null when the options show nothing of the kind; the same pointer as before when nothing has changed.
  std::shared_ptr<const SceneHistory> of(const Run& run, const DisplayOptions& options);

 private:
  struct Content {
    RunId run = -1;
    std::size_t frames = 0;
    bool trails = false;
    bool ghost = false;
    bool operator==(const Content&) const = default;
  };

  Content content_;
  std::shared_ptr<const SceneHistory> history_;
};

}  // namespace netpocket
