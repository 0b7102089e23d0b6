#pragma once
// The groups of a pocket's nodes and elements, by which what judges or draws pockets finds them. Recordings by version
// 0.1 hold no others.

#include <cstdint>
#include <vector>

#include "engine/state/structure.h"

namespace netpocket {

inline constexpr const char* kRodRoots = "rod roots";  // clamped ends, by rod
inline constexpr const char* kRodKinks = "rod kinks";
inline constexpr const char* kRodTips = "rod tips";  // retractors sit here

// In the order of pocket_groups().
enum class PocketGroup : std::int32_t { net, rods, closing_ropes };

constexpr std::int32_t index_of(PocketGroup group) { return static_cast<std::int32_t>(group); }

inline std::vector<ElementGroup> pocket_groups() {
  return {{"net", "the net", CableLook::cord},
          {"rods", "a rod", CableLook::tube},
          {"closing ropes", "a closing rope", CableLook::rope}};
}

}  // namespace netpocket
