#include "tests/pictures/picture_comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace netpocket::pictures {
namespace {

constexpr int kTolerance = 7;  // of 255 levels: 3 % are 7.65

// Of what a transparent picture looks like on white.
int level(const Image& image, std::size_t pixel, int channel) {
  const int color = image.rgb[3 * pixel + static_cast<std::size_t>(channel)];
  if (image.alpha.empty()) return color;
  const int alpha = image.alpha[pixel];
  return (color * alpha + 255 * (255 - alpha) + 127) / 255;
}

std::size_t pixel_count(const Image& image) { return image.rgb.size() / 3; }

}  // namespace

PictureDifference compare_pictures(const Image& actual, const Image& baseline) {
  PictureDifference difference;
  difference.same_size = actual.width == baseline.width && actual.height == baseline.height &&
                         actual.alpha.empty() == baseline.alpha.empty();
  if (!difference.same_size) return difference;
  std::size_t beyond = 0;
  double squares = 0;
  for (std::size_t i = 0; i < pixel_count(actual); ++i) {
    int largest = 0;
    for (int c = 0; c < 3; ++c) {
      const int apart = std::abs(level(actual, i, c) - level(baseline, i, c));
      largest = std::max(largest, apart);
      squares += apart * apart;
    }
    beyond += largest > kTolerance;
  }
  difference.beyond = static_cast<double>(beyond) / static_cast<double>(pixel_count(actual));
  difference.rmse = std::sqrt(squares / static_cast<double>(actual.rgb.size())) / 255;
  return difference;
}

bool equal_enough(const PictureDifference& difference) {
  return difference.same_size && difference.beyond <= kLargestBeyond && difference.rmse <= kLargestRmse;
}

bool is_blank(const Image& image) {
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < pixel_count(image); ++i) {
    int largest = 0;
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(level(image, i, c) - level(image, 0, c)));
    drawn += largest > kTolerance;
  }
  return drawn <= pixel_count(image) / 1000;
}

Image difference_picture(const Image& actual, const Image& baseline) {
  Image picture{std::max(actual.width, baseline.width), std::max(actual.height, baseline.height), {}};
  picture.rgb.assign(picture.row_bytes() * picture.height, 255);
  const int width = std::min(actual.width, baseline.width), height = std::min(actual.height, baseline.height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto of = [&](const Image& image) { return static_cast<std::size_t>(y) * image.width + x; };
      int largest = 0;
      for (int c = 0; c < 3; ++c) {
        largest = std::max(largest, std::abs(level(actual, of(actual), c) - level(baseline, of(baseline), c)));
      }
      // Small differences must be seen too.
      const auto light = static_cast<std::uint8_t>(largest == 0 ? 255 : 200 - 200 * largest / 255);
      auto* rgb = picture.rgb.data() + 3 * of(picture);
      rgb[1] = rgb[2] = light;
    }
  }
  return picture;
}

}  // namespace netpocket::pictures
