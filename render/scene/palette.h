#pragma once
// The colours of a scene. Hues follow Okabe and Ito's set, which people with colour-vision deficiencies can tell apart.

#include "render/scene/color.h"
#include "render/scene/scene_options.h"

namespace netpocket {

struct Palette {
  Color background;
  Color background_top;
  Color text;
  Color net;
  Color rods;
  Color joints;
  Color retractors;
  Color closing_ropes;
  Color target;
  Color target_panels;  // every second panel of the target
  Color target_seams;
  Color contact;  // forces
  Color target_trail;
  Color spacecraft_trail;
};

const Palette& palette(Background background);

// The spacecraft looks the same everywhere.
inline constexpr Color kFoil = {0.86, 0.66, 0.27};
inline constexpr Color kBusEdge = {0.55, 0.56, 0.58};
inline constexpr Color kBusPanel = {0.80, 0.81, 0.83};
inline constexpr Color kSolarCell = {0.10, 0.18, 0.42};
inline constexpr Color kSolarGrid = {0.62, 0.70, 0.84};
inline constexpr Color kMetal = {0.66, 0.68, 0.71};
inline constexpr Color kDarkMetal = {0.25, 0.26, 0.29};

}  // namespace netpocket
