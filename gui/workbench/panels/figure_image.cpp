#include "gui/workbench/panels/figure_image.h"

#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "gui/workbench/panels/tones.h"

namespace netpocket {
namespace {

constexpr double kPointsPerPixel = 72.0 / 100;  // slightly larger than printed

using Ramp = std::array<int, 256>;

// From `ground` for 0 to `ink` for 255.
Ramp ramp(int ground, int ink) {
  Ramp values{};
  for (int i = 0; i < 256; ++i) values[i] = ground + (ink - ground) * i / 255;
  return values;
}

// What to add to all components to mirror the lightness of a colour; hue and chroma stay.
int mirror_shift(int red, int green, int blue) {
  return 255 - std::max({red, green, blue}) - std::min({red, green, blue});
}

// Charts are drawn on white. On a dark palette the lightness of each pixel is mirrored; then the ground takes the
// palette's colour.
void adapt_to_palette(QImage& image, const QPalette& palette) {
  const bool dark = is_dark(palette);
  const QColor base = palette.color(QPalette::Base);
  if (base == Qt::white) return;
  const auto component = [dark](int ground) { return dark ? ramp(ground, 255) : ramp(0, ground); };
  const std::array<Ramp, 3> tones = {component(base.red()), component(base.green()), component(base.blue())};
  const int width = image.width();
  for (int y = 0; y < image.height(); ++y) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < width; ++x) {
      const int red = qRed(line[x]);
      const int green = qGreen(line[x]);
      const int blue = qBlue(line[x]);
      const int shift = dark ? mirror_shift(red, green, blue) : 0;
      line[x] = qRgb(tones[0][red + shift], tones[1][green + shift], tones[2][blue + shift]);
    }
  }
}

PlotBox scaled(const PlotBox& box, double factor) {
  return {box.x * factor, box.y * factor, box.width * factor, box.height * factor};
}

}  // namespace

QColor mirrored_lightness(const QColor& colour) {
  const int shift = mirror_shift(colour.red(), colour.green(), colour.blue());
  return {colour.red() + shift, colour.green() + shift, colour.blue() + shift};
}

FigureImage figure_image(const Figure& figure, const QSize& size, double device_pixel_ratio, const QPalette& palette,
                         double scale) {
  const double pixels_per_point = scale / kPointsPerPixel;
  const QSize pixels = (QSizeF(size) * device_pixel_ratio).toSize().expandedTo({1, 1});
  FigureImage result;
  result.image = QImage(pixels, QImage::Format_RGB32);  // the layout of Cairo's RGB24
  {
    const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
        cairo_image_surface_create_for_data(result.image.bits(), CAIRO_FORMAT_RGB24, pixels.width(), pixels.height(),
                                            static_cast<int>(result.image.bytesPerLine())),
        &cairo_surface_destroy);
    const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context(cairo_create(surface.get()), &cairo_destroy);
    const double unit = device_pixel_ratio * pixels_per_point;
    cairo_set_antialias(context.get(), CAIRO_ANTIALIAS_FAST);  // spiky curves in half the time
    cairo_scale(context.get(), unit, unit);
    result.panels = draw_figure(figure, context.get(), pixels.width() / unit, pixels.height() / unit);
    cairo_surface_flush(surface.get());
  }
  for (PanelFrame& panel : result.panels) panel.box = scaled(panel.box, pixels_per_point);
  adapt_to_palette(result.image, palette);
  result.image.setDevicePixelRatio(device_pixel_ratio);
  return result;
}

}  // namespace netpocket
