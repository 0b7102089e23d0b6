#include "gui/workbench/panels/tones.h"

#include <cmath>

namespace netpocket {
namespace {

QColor mixed(const QColor& a, const QColor& b, double amount_of_b) {
  const auto mix = [&](int from, int to) { return static_cast<int>(std::lround(from + (to - from) * amount_of_b)); };
  return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

}  // namespace

bool is_dark(const QPalette& palette) {
  return palette.color(QPalette::Base).lightness() < palette.color(QPalette::Text).lightness();
}

QColor tone_colour(Tone tone, const QPalette& palette) {
  const bool dark = is_dark(palette);
  switch (tone) {
    case Tone::good:
      return dark ? QColor(104, 211, 145) : QColor(22, 118, 64);
    case Tone::bad:
      return dark ? QColor(255, 138, 128) : QColor(179, 38, 30);
    case Tone::warning:
      return dark ? QColor(255, 193, 94) : QColor(142, 84, 0);
    case Tone::accent:
      return dark ? QColor(122, 184, 255) : QColor(0, 91, 171);
    case Tone::muted:
      break;
  }
  return mixed(palette.color(QPalette::Text), palette.color(QPalette::Base), 0.3);
}

QColor ground_colour(Tone tone, const QPalette& palette) {
  return mixed(palette.color(QPalette::Base), tone_colour(tone, palette), is_dark(palette) ? 0.18 : 0.1);
}

}  // namespace netpocket
