#pragma once
// Small pictures drawn in the colours of a palette: sharp at every scale and there on every desktop, whatever its icon
// theme has.

#include <QIcon>
#include <QPalette>

#include "gui/workbench/panels/tones.h"

namespace netpocket {

enum class Glyph {
  reset,    // an arrow that turns back
  restart,  // a closed circle of an arrow
  at_once,  // a flash
  yes,      // a tick
  no,       // a cross
  pending,  // a clock
  add,
  remove,
};

// An icon of 16 logical pixels.
QIcon glyph_icon(Glyph glyph, Tone tone, const QPalette& palette);

}  // namespace netpocket
