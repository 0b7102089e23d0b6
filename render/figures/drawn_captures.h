#pragma once
// Which captures of a large campaign a picture shows: so many marks that one can still see and point at them. They are
// chosen by a hash of their place in the table, so that they are a fair sample whatever the order of the table, and
// those of a table that grows remain a sample of the same kind. Pure functions: any thread may call them.

#include <cstddef>
#include <string>

namespace netpocket {

inline constexpr std::size_t kMostDrawn = 4000;

// Of `rows` rows about `most` are drawn; all if there are no more than that.
bool is_drawn(std::size_t row, std::size_t rows, std::size_t most = kMostDrawn);

// "about 4000 of 100000 captures drawn"; empty if all are.
std::string drawn_text(std::size_t rows, std::size_t most = kMostDrawn);
// A title that says so.
std::string title_with_drawn(const std::string& title, std::size_t rows);

}  // namespace netpocket
