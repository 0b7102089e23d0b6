#include "gui/commands/spelling.h"

#include <algorithm>

#include "engine/base/edit_distance.h"

namespace netpocket {

std::optional<std::string> nearest_name(std::string_view unknown, const std::vector<std::string>& names) {
  if (unknown.size() > kLongestComparedName) return std::nullopt;
  std::optional<std::string> best;
  std::size_t limit = largest_slip(unknown) + 1;
  for (const std::string& name : names) {
    const std::size_t distance = edit_distance(unknown, name);
    // A word of which nothing is left was not meant.
    if (distance < limit && distance < std::min(unknown.size(), name.size())) {
      limit = distance;
      best = name;
    }
  }
  return best;
}

std::string suggestion(std::string_view unknown, const std::vector<std::string>& names) {
  const auto name = nearest_name(unknown, names);
  return name ? "; did you mean \"" + *name + "\"?" : "";
}

}  // namespace netpocket
