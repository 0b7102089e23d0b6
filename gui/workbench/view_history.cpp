#include "gui/workbench/view_history.h"

namespace netpocket {

std::shared_ptr<const SceneHistory> ViewHistory::of(const Run& run, const DisplayOptions& options) {
  if (!options.trails && !options.ghost) return nullptr;
  const Content content{run.id, options.trails ? run.frame_count() : 0, options.trails, options.ghost};
  if (history_ && content == content_) return history_;
  content_ = content;
  auto history = std::make_shared<SceneHistory>();
  if (options.ghost && run.first_frame) history->initial = *run.first_frame;
  if (options.trails) {
    const auto channel = [&run](Channel c) -> const std::vector<double>& { return run.series.channel(c); };
    history->paths = body_paths(*run.structure, channel);
  }
  history_ = std::move(history);
  return history_;
}

}  // namespace netpocket
