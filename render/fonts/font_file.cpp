#include "render/fonts/font_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/fonts/installed_fonts.h"
#include "render/render_error.h"

namespace netpocket {
namespace {

const char* family(const FontStyle& style) { return style.mono ? kMonoFontFamily : kFontFamily; }

bool is_wanted(const InstalledFont& font, const FontStyle& style) {
  return font.family == family(style) && font.width == FC_WIDTH_NORMAL &&
         font.weight == (style.bold ? FC_WEIGHT_BOLD : FC_WEIGHT_NORMAL) &&
         (font.slant != FC_SLANT_ROMAN) == style.italic;
}

}  // namespace

const std::string& font_file(const FontStyle& style) {
  const auto& fonts = installed_fonts();
  const auto font = std::ranges::find_if(fonts, [&](const auto& candidate) { return is_wanted(candidate, style); });
  if (font != fonts.end()) return font->file;
  throw RenderError(fmt::format("the font {}{}{} is not installed (Debian: fonts-dejavu-{})", family(style),
                                style.bold ? " Bold" : "", style.italic ? " Oblique" : "",
                                style.italic ? "extra" : "core"));
}

}  // namespace netpocket
