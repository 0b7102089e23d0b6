#pragma once
// An sRGB colour.

#include <algorithm>
#include <array>
#include <cmath>

namespace netpocket {

using Color = std::array<double, 3>;  // red, green, blue in [0, 1]
using ByteColor = std::array<unsigned char, 3>;

inline ByteColor to_bytes(const Color& color) {
  const auto byte = [](double value) {
    return static_cast<unsigned char>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
  };
  return {byte(color[0]), byte(color[1]), byte(color[2])};
}

// `fraction` of the way from one colour to another.
inline Color mix(const Color& from, const Color& to, double fraction) {
  Color mixed;
  for (int i = 0; i < 3; ++i) mixed[i] = from[i] + fraction * (to[i] - from[i]);
  return mixed;
}

}  // namespace netpocket
