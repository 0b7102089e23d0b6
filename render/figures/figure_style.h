#pragma once
// Sizes and tones that all figures share; points.

#include "render/figures/rich_text.h"

namespace netpocket::style {

inline constexpr FigureColour kFrame = colour_from_bytes(50, 50, 50);
inline constexpr FigureColour kGrid = colour_from_bytes(228, 228, 228);
inline constexpr FigureColour kLegendFrame = colour_from_bytes(205, 205, 205);
inline constexpr FigureColour kZeroLine = colour_from_bytes(150, 150, 150);

inline constexpr TextStyle kFigureTitle{9, true, kBlack};
inline constexpr TextStyle kPanelTitle{8, false, kBlack};
inline constexpr TextStyle kPanelLetter{8, true, kBlack};
inline constexpr TextStyle kAxisTitle{8, false, kBlack};
inline constexpr TextStyle kTickLabel{7, false, kBlack};
inline constexpr TextStyle kLegend{7, false, kBlack};
inline constexpr TextStyle kPhaseLabel{6.5, false, kBlack};
inline constexpr TextStyle kNote{9, false, kGrey};
inline constexpr TextStyle kFootnote{6.5, false, kFrame};

inline constexpr double kFrameLine = 0.6;
inline constexpr double kGridLine = 0.4;
inline constexpr double kMajorTick = 3;
inline constexpr double kMinorTick = 1.6;
inline constexpr double kGap = 3;             // between neighbouring texts and lines
inline constexpr double kOuterMargin = 4;     // around the figure
inline constexpr double kRightMargin = 9;     // right of a frame: half of the last tick label
inline constexpr double kPhaseStrip = 10.5;   // height for phase labels at the top of a frame
inline constexpr double kCurveMargin = 0.06;  // of the range, between curves and frame
inline constexpr double kTickSpacingX = 30;   // least distance between labelled ticks
inline constexpr double kTickSpacingY = 15;

}  // namespace netpocket::style
