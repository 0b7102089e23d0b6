#pragma once
// Texts that people write, in letters that DejaVu Sans may lack: which installed font draws them.

#include <set>
#include <string>
#include <string_view>

#include "render/fonts/font_file.h"

namespace netpocket {

struct DrawableText {
  std::string text;  // UTF-8, whatever came; a sign stands for each letter that the font lacks
  std::string font;  // file
};

// DejaVu Sans where it has all letters, else the installed font that lacks the fewest. Throws RenderError when DejaVu
// Sans is not installed. Any thread.
DrawableText drawable_text(std::string_view text, const FontStyle& style = {});

// The letters that are replaced; empty when all can be drawn.
std::set<std::string> missing_letters(std::string_view text, const FontStyle& style = {});

}  // namespace netpocket
