#pragma once
// What a picture of a pocket shows and how.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/state/phase.h"
#include "render/scene/color_map.h"

namespace netpocket {

enum class ColorBy { none, tension, strain, speed, contact };
enum class Background { white, space };

// "none", "tension", "strain", "speed" or "contact"; "white" or "space". Throw RenderError for any other name.
ColorBy color_by_from_name(std::string_view name);
Background background_from_name(std::string_view name);

struct ValueRange {
  double low = 0;
  double high = 1;
};

// What a person chooses to see.
struct DisplayOptions {
  Background background = Background::white;
  ColorBy color_by = ColorBy::none;
  std::optional<ValueRange> color_range;  // N, 1 or m/s; absent: grows with what has been drawn
  std::optional<ColorMap> color_map;      // absent: the one that reads best on the background
  double target_opacity = 1;              // 0 to 1
  bool contact_arrows = false;            // the force of each contact on a body, pointing at the place it acts on
  std::optional<double> arrow_force;      // N, of the longest arrow, also for larger ones; absent: grows
  bool trails = false;                    // paths of the bodies' centres of mass so far; need a SceneHistory
  bool ghost = false;                     // the pocket's initial shape; needs a SceneHistory
  bool legend = true;                     // when something is coloured by a value
  bool time_label = true;
  bool scale_bar = true;
  bool axes = true;
  std::string title;
};

struct SceneOptions : DisplayOptions {
  std::vector<Phase> phases;    // named beside the time; empty: the time stands alone
  double line_scale = 1;        // of the widths of lines
  double annotation_scale = 1;  // of labels, legend, scale bar and axes
  std::string legend_title;     // in another language; empty: color_label()
  bool legend_ground = false;   // the legend's texts stand on the background's colour, so that no cord crosses them
  bool fast_smoothing = false;  // FXAA, for windows; files are better smoothed by supersampling
  bool transparent_background = false;  // the picture's alpha tells where something is drawn
};

}  // namespace netpocket
