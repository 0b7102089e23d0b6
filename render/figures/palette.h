#pragma once
// Colours that stay apart for colour-blind readers: Okabe & Ito (2008), "Color Universal Design".

#include <array>
#include <cstddef>

namespace netpocket {

// Components in [0, 1], sRGB.
struct FigureColour {
  double red = 0;
  double green = 0;
  double blue = 0;
};

constexpr FigureColour colour_from_bytes(int red, int green, int blue) {
  return {red / 255.0, green / 255.0, blue / 255.0};
}

// Mixes with white: amount 0 leaves the colour, 1 gives white.
constexpr FigureColour lighter(FigureColour c, double amount) {
  return {c.red + (1 - c.red) * amount, c.green + (1 - c.green) * amount, c.blue + (1 - c.blue) * amount};
}

inline constexpr FigureColour kBlack = colour_from_bytes(0, 0, 0);
inline constexpr FigureColour kGrey = colour_from_bytes(110, 110, 110);
inline constexpr FigureColour kBlue = colour_from_bytes(0, 114, 178);
inline constexpr FigureColour kVermillion = colour_from_bytes(213, 94, 0);
inline constexpr FigureColour kGreen = colour_from_bytes(0, 158, 115);
inline constexpr FigureColour kOrange = colour_from_bytes(230, 159, 0);
inline constexpr FigureColour kPurple = colour_from_bytes(204, 121, 167);
inline constexpr FigureColour kSkyBlue = colour_from_bytes(86, 180, 233);

// The paper draws the closing phase blue and the towing phase red.
inline constexpr FigureColour kClosingBlue = colour_from_bytes(20, 90, 170);
inline constexpr FigureColour kTowingRed = colour_from_bytes(200, 36, 32);

// Colours of runs drawn over each other, used in turn.
inline constexpr std::array<FigureColour, 6> kRunColours = {kBlue, kVermillion, kGreen, kPurple, kOrange, kSkyBlue};

constexpr FigureColour run_colour(std::size_t index) { return kRunColours[index % kRunColours.size()]; }

}  // namespace netpocket
