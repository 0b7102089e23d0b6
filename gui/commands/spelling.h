#pragma once
// Finds what a misspelt word was meant to be.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace netpocket {

// The name that differs in the fewest letters, if few enough for a slip of the pen.
std::optional<std::string> nearest_name(std::string_view unknown, const std::vector<std::string>& names);

// "; did you mean "render"?", or nothing when no name is near.
std::string suggestion(std::string_view unknown, const std::vector<std::string>& names);

}  // namespace netpocket
