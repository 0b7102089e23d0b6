#pragma once
// A chart as a picture for the screen, in the colours of a palette.

#include <QColor>
#include <QImage>
#include <QPalette>
#include <QSize>
#include <vector>

#include "render/figures/figure.h"

namespace netpocket {

struct FigureImage {
  QImage image;
  std::vector<PanelFrame> panels;  // in logical pixels
};

// Draws the figure at `size` logical pixels; letters and lines are `scale` times as large as usual. On a dark palette
// colours keep their hue and swap light for dark.
FigureImage figure_image(const Figure& figure, const QSize& size, double device_pixel_ratio, const QPalette& palette,
                         double scale = 1);

// A colour of a figure as it appears on a dark palette.
QColor mirrored_lightness(const QColor& colour);

}  // namespace netpocket
