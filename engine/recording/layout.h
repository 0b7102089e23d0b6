#pragma once
// Names that writing and reading share; the whole layout is in FORMAT.md.

#include <cstddef>
#include <cstdint>

namespace netpocket::layout {

inline constexpr char kFormat[] = "netpocket-recording";
inline constexpr std::int32_t kVersion = 3;
// Groups of elements were four fixed kinds, those of nodes three fixed lists.
inline constexpr std::int32_t kVersionWithKinds = 2;

// Numbers of a body's state: position, attitude (w, x, y, z), velocity, angular velocity.
inline constexpr std::size_t kBodyNumbers = 13;

}  // namespace netpocket::layout
