#pragma once
// The fonts of everything that is drawn: DejaVu Sans, and DejaVu Sans Mono for texts in columns. They are looked for by
// name, so that pictures are the same on every machine, whatever it would choose by itself.

#include <string>

namespace netpocket {

inline constexpr const char* kFontFamily = "DejaVu Sans";
inline constexpr const char* kMonoFontFamily = "DejaVu Sans Mono";

struct FontStyle {
  bool bold = false;
  bool italic = false;
  bool mono = false;
};

// The font's file. Throws RenderError when it is not installed: another font would have other sizes and might lack
// signs. Any thread.
const std::string& font_file(const FontStyle& style = {});

}  // namespace netpocket
