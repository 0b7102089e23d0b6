#pragma once
// Names and numbers that writing and reading share. FORMAT.md describes the whole layout.

#include <cstddef>
#include <cstdint>

namespace netpocket::layout {

inline constexpr char kFormat[] = "netpocket-recording";
inline constexpr std::int32_t kVersion = 3;
// In this version, groups of elements were four fixed kinds and groups of nodes three fixed lists.
inline constexpr std::int32_t kVersionWithKinds = 2;

// Numbers in the state of a body: position (3), attitude (w, x, y, z), velocity (3), angular velocity (3).
inline constexpr std::size_t kBodyNumbers = 13;

}  // namespace netpocket::layout
