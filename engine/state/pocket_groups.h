#pragma once
// The groups of a pocket's nodes and elements. Code that judges or draws pockets finds them by these names. Recordings
// of version 0.1 hold no other groups.

#include <cstdint>
#include <vector>

#include "engine/state/structure.h"

namespace netpocket {

inline constexpr const char* kRodRoots = "rod roots";  // clamped ends, by rod
inline constexpr const char* kRodKinks = "rod kinks";
inline constexpr const char* kRodTips = "rod tips";  // where the retractors are

// In the order of pocket_groups().
enum class PocketGroup : std::int32_t { net, rods, closing_ropes };

constexpr std::int32_t index_of(PocketGroup group) { return static_cast<std::int32_t>(group); }

inline std::vector<ElementGroup> pocket_groups() {
  return {{"net", "the net", CableLook::cord},
          {"rods", "a rod", CableLook::tube},
          {"closing ropes", "a closing rope", CableLook::rope}};
}

}  // namespace netpocket
