#include "render/fonts/font_file.h"

#include <fmt/format.h>
#include <fontconfig/fontconfig.h>

#include <memory>

#include "render/render_error.h"

namespace netpocket {
namespace {

using Pattern = std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)>;

std::string text_of(const FcPattern* pattern, const char* property) {
  FcChar8* text = nullptr;
  const bool found = pattern && FcPatternGetString(pattern, property, 0, &text) == FcResultMatch;
  return found ? reinterpret_cast<const char*>(text) : "";
}

std::string find_font(bool bold) {
  const Pattern wanted(FcPatternCreate(), FcPatternDestroy);
  FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(kFontFamily));
  FcPatternAddInteger(wanted.get(), FC_WEIGHT, bold ? FC_WEIGHT_BOLD : FC_WEIGHT_NORMAL);
  FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult result = FcResultNoMatch;
  const Pattern nearest(FcFontMatch(nullptr, wanted.get(), &result), FcPatternDestroy);
  // The nearest font may be any other.
  if (text_of(nearest.get(), FC_FAMILY) == kFontFamily) return text_of(nearest.get(), FC_FILE);
  throw RenderError(fmt::format("the font {} is not installed (Debian: fonts-dejavu-core)", kFontFamily));
}

}  // namespace

const std::string& font_file(bool bold) {
  static const std::string normal_file = find_font(false);
  static const std::string bold_file = find_font(true);
  return bold ? bold_file : normal_file;
}

}  // namespace netpocket
