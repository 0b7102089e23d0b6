#include "render/scene/palette.h"

namespace netpocket {
namespace {

constexpr Palette kWhite = {
    .background = {1, 1, 1},
    .background_top = {1, 1, 1},
    .text = {0.10, 0.11, 0.13},
    .net = {0.15, 0.18, 0.23},
    .rods = {0.00, 0.45, 0.70},
    .joints = {0.05, 0.30, 0.48},
    .retractors = {0.22, 0.24, 0.28},
    .closing_ropes = {0.84, 0.37, 0.00},
    .target = {0.87, 0.85, 0.80},
    .target_panels = {0.80, 0.78, 0.73},
    .target_seams = {0.62, 0.60, 0.55},
    .contact = {0.72, 0.10, 0.24},
    .target_trail = {0.64, 0.20, 0.52},
    .spacecraft_trail = {0.00, 0.50, 0.37},
};

constexpr Palette kSpace = {
    .background = {0.015, 0.02, 0.035},
    .background_top = {0.05, 0.075, 0.13},
    .text = {0.90, 0.92, 0.95},
    .net = {0.74, 0.80, 0.88},
    .rods = {0.34, 0.71, 0.91},
    .joints = {0.20, 0.52, 0.74},
    .retractors = {0.70, 0.73, 0.78},
    .closing_ropes = {0.96, 0.56, 0.12},
    .target = {0.58, 0.56, 0.52},
    .target_panels = {0.51, 0.49, 0.46},
    .target_seams = {0.36, 0.35, 0.33},
    .contact = {1.00, 0.36, 0.42},
    .target_trail = {0.93, 0.56, 0.80},
    .spacecraft_trail = {0.25, 0.85, 0.65},
};

}  // namespace

const Palette& palette(Background background) { return background == Background::space ? kSpace : kWhite; }

}  // namespace netpocket
