#include "render/fonts/shortened.h"

#include <vector>

namespace netpocket {
namespace {

// Where letters begin.
std::vector<std::size_t> letter_starts(std::string_view text) {
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) starts.push_back(i);
  }
  return starts;
}

}  // namespace

std::string shortened(std::string_view text, const std::function<bool(const std::string&)>& fits) {
  if (fits(std::string(text))) return std::string(text);
  const auto starts = letter_starts(text);
  const auto beginning = [&](std::size_t letters) {
    std::string kept(text.substr(0, letters < starts.size() ? starts[letters] : text.size()));
    while (kept.ends_with(' ')) kept.pop_back();
    return kept + "\u2026";
  };
  std::size_t fitting = 0, too_long = starts.size();
  while (too_long - fitting > 1) {
    const std::size_t middle = (fitting + too_long) / 2;
    (fits(beginning(middle)) ? fitting : too_long) = middle;
  }
  return beginning(fitting);
}

}  // namespace netpocket
