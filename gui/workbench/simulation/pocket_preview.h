#pragma once
// A scenario as it looks before anything moves: quick enough to follow edits.

#include <memory>

#include "engine/scenario/scenario.h"
#include "engine/state/snapshot.h"
#include "engine/state/structure.h"

namespace netpocket {

struct PocketPreview {
  std::shared_ptr<const Structure> structure;
  std::shared_ptr<const Snapshot> snapshot;  // at t = 0, free of stress
};

// The scenario must pass check_scenario. Any thread may call it.
PocketPreview preview_pocket(const Scenario& scenario);

}  // namespace netpocket
