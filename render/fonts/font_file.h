#pragma once
// The font of all labels: DejaVu Sans, so that pictures are the same on every machine.

#include <string>

namespace netpocket {

inline constexpr const char* kFontFamily = "DejaVu Sans";

// The font's file. Throws RenderError when it is not installed: another font would have other sizes and might lack
// signs. Any thread.
const std::string& font_file(bool bold = false);

}  // namespace netpocket
