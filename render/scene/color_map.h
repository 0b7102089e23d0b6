#pragma once
// Perceptually uniform colour maps that people with colour-vision deficiencies can read.

#include <string_view>

#include "render/scene/color.h"

namespace netpocket {

enum class ColorMap { viridis, cividis, plasma };

// `fraction` from 0 (lowest) to 1; values outside are clamped, NaN is drawn as 0.
Color map_color(ColorMap map, double fraction);

// Throws RenderError for an unknown name.
ColorMap color_map_from_name(std::string_view name);

}  // namespace netpocket
