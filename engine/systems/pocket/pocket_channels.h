#pragma once
// The channels that only a pocket has: its mouth, its closing ropes, and whether the target is inside.

#include <vector>

#include "engine/dynamics/system/cable_system.h"
#include "engine/systems/pocket/pocket.h"
#include "engine/systems/pocket/pocket_interior.h"

namespace netpocket {

class PocketChannels {
 public:
  explicit PocketChannels(const Pocket& pocket);

  // Fills these channels of `snapshot`, whose state must just have been captured from `system`.
  void fill(const CableSystem& system, Snapshot& snapshot) const;

 private:
  bool target_is_inside(const Snapshot& snapshot) const;
  void fill_tensions(Snapshot& snapshot) const;

  std::int32_t base_, target_;  // bodies; base_: on which the rods stand
  PocketInterior interior_;
  std::vector<std::int32_t> net_, closing_ropes_;  // elements
};

}  // namespace netpocket
