#include "render/figures/drawn_captures.h"

#include <fmt/format.h>

#include "engine/sampling/random.h"

namespace netpocket {

bool is_drawn(std::size_t row, std::size_t rows, std::size_t most) {
  constexpr std::uint64_t kSeed = 1;
  return rows <= most || random_fraction(kSeed, row, 0) * static_cast<double>(rows) < static_cast<double>(most);
}

std::string drawn_text(std::size_t rows, std::size_t most) {
  return rows <= most ? "" : fmt::format("about {} of {} captures drawn", most, rows);
}

std::string title_with_drawn(const std::string& title, std::size_t rows) {
  return rows <= kMostDrawn ? title : title + ", " + drawn_text(rows);
}

}  // namespace netpocket
