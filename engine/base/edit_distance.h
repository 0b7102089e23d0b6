#pragma once
// How far a misspelt name is from a valid one.

#include <cstddef>
#include <string_view>

namespace netpocket {

// Names longer than this are not compared: it bounds the effort.
inline constexpr std::size_t kLongestComparedName = 64;

// Levenshtein's distance: letters to insert, remove or replace.
std::size_t edit_distance(std::string_view from, std::string_view to);

// The largest distance at which `name` may still be a slip of the pen: a third of its letters, and two of a short one.
std::size_t largest_slip(std::string_view name);

}  // namespace netpocket
