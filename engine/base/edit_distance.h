#pragma once
// Edit distance of a misspelt name from a valid one. Pure functions.

#include <cstddef>
#include <string_view>

namespace netpocket {

// Callers do not compare longer names, to bound the computing time.
inline constexpr std::size_t kLongestComparedName = 64;

// Levenshtein distance: the least number of letters to insert, remove or replace.
std::size_t edit_distance(std::string_view from, std::string_view to);

// The largest distance at which `name` may still be a misspelling: a third of its letters, but at least two.
std::size_t largest_slip(std::string_view name);

}  // namespace netpocket
