#pragma once
// The icons of actions: drawn, so that they are sharp at every scale and follow light and dark.

#include <QIcon>

namespace netpocket {

enum class ActionIcon {
  run,
  pause,
  step,
  restart,
  branch,
  play,
  play_back,
  next_frame,
  previous_frame,
  first,
  last,
  loop,
  mark,
  fit,
  measure,
  follow,
  move,
  split,
  open,
  save,
};

QIcon action_icon(ActionIcon icon);

}  // namespace netpocket
