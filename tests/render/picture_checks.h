#pragma once
// What tests ask of pictures.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "render/output/image.h"

namespace netpocket::pictures {

// Where the tests leave their pictures, for people to look at. Made if need be.
inline std::string folder(const std::string& test) {
  const auto path = std::filesystem::path(NETPOCKET_PICTURE_DIR) / test;
  std::filesystem::create_directories(path);
  return path.string();
}

// Fraction of the pixels that differ from the first one, the background's, by more than a little.
inline double drawn_fraction(const Image& image) {
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    int difference = 0;
    for (int c = 0; c < 3; ++c) difference = std::max(difference, std::abs(image.rgb[i + c] - image.rgb[c]));
    drawn += difference > 12;
  }
  return static_cast<double>(drawn) / (static_cast<double>(image.rgb.size()) / 3);
}

// Fraction of the pixels of two pictures of one size that differ in a channel by more than `tolerance` levels of 255.
inline double differing_fraction(const Image& a, const Image& b, int tolerance) {
  if (a.rgb.size() != b.rgb.size()) return 1;
  std::size_t differing = 0;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
    bool differs = false;
    for (int c = 0; c < 3; ++c) differs |= std::abs(a.rgb[i + c] - b.rgb[i + c]) > tolerance;
    differing += differs;
  }
  return static_cast<double>(differing) / (static_cast<double>(a.rgb.size()) / 3);
}

// Number of pixels within `tolerance` levels of a colour.
inline std::size_t count_color(const Image& image, int red, int green, int blue, int tolerance) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    count += std::abs(image.rgb[i] - red) <= tolerance && std::abs(image.rgb[i + 1] - green) <= tolerance &&
             std::abs(image.rgb[i + 2] - blue) <= tolerance;
  }
  return count;
}

}  // namespace netpocket::pictures
