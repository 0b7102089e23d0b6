#include "gui/commands/spelling.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace netpocket {
namespace {

constexpr std::size_t kLongestWord = 64;  // bounds the effort

// Levenshtein's distance: letters to insert, remove or replace.
std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = std::exchange(row[j + 1], std::min({replaced, row[j] + 1, row[j + 1] + 1}));
    }
  }
  return row[to.size()];
}

}  // namespace

std::optional<std::string> nearest_name(std::string_view unknown, const std::vector<std::string>& names) {
  if (unknown.size() > kLongestWord) return std::nullopt;
  std::optional<std::string> best;
  std::size_t limit = std::max<std::size_t>(2, unknown.size() / 3) + 1;
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
