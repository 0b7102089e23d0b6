#pragma once
// Colours that carry a meaning, readable on the palette's base colour in light and dark schemes (contrast 4.5 or more,
// as WCAG 2.1 asks of text).

#include <QColor>
#include <QPalette>

namespace netpocket {

bool is_dark(const QPalette& palette);

enum class Tone { good, bad, warning, accent, muted };

QColor tone_colour(Tone tone, const QPalette& palette);

// The colour, thinned to a ground on which the palette's text stays readable.
QColor ground_colour(Tone tone, const QPalette& palette);

}  // namespace netpocket
