#include "render/output/side_by_side.h"

#include <algorithm>

namespace netpocket {
namespace {

void copy_rows(const std::vector<std::uint8_t>& from, std::size_t from_row, std::uint8_t* to, std::size_t to_row) {
  for (std::size_t first = 0; first < from.size(); first += from_row, to += to_row) {
    std::copy_n(from.data() + first, from_row, to);
  }
}

}  // namespace

Image side_by_side(const std::vector<Image>& images) {
  Image row{0, images.empty() ? 0 : images.front().height, {}};
  bool transparent = false;
  for (const auto& image : images) {
    row.width += image.width;
    transparent |= !image.alpha.empty();
  }
  row.rgb.resize(row.row_bytes() * row.height);
  if (transparent) row.alpha.assign(static_cast<std::size_t>(row.width) * row.height, 255);
  std::size_t left = 0;
  for (const auto& image : images) {
    copy_rows(image.rgb, image.row_bytes(), row.rgb.data() + 3 * left, row.row_bytes());
    if (!image.alpha.empty()) copy_rows(image.alpha, image.width, row.alpha.data() + left, row.width);
    left += image.width;
  }
  return row;
}

}  // namespace netpocket
