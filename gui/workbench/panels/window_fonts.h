#pragma once

namespace netpocket {

// All of the window in DejaVu Sans, as large as the desktop's letters: widths were chosen for it, and it has every sign
// that is used. Needs the application. Texts are English, so numbers and dates keep a form that goes with it.
void use_window_fonts();

// Throws RenderError when a font of the window is not installed: Qt would show texts in another one, or in boxes.
void require_window_fonts();

}  // namespace netpocket
