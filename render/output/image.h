#pragma once
// A picture in memory.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace netpocket {

struct Image {
  int width = 0;                  // pixels
  int height = 0;                 // pixels
  std::vector<std::uint8_t> rgb;  // 3 bytes a pixel, rows from the top, no padding
  // 1 byte a pixel, 255 where the picture hides what is behind it; empty: it does everywhere.
  std::vector<std::uint8_t> alpha = {};

  std::size_t row_bytes() const { return 3 * static_cast<std::size_t>(width); }
};

}  // namespace netpocket
