#include "render/fonts/installed_fonts.h"

#include <algorithm>

namespace netpocket {
namespace {

using Pattern = std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)>;
using ObjectSet = std::unique_ptr<FcObjectSet, decltype(&FcObjectSetDestroy)>;
using FontSet = std::unique_ptr<FcFontSet, decltype(&FcFontSetDestroy)>;

std::string text_of(const FcPattern* pattern, const char* property) {
  FcChar8* text = nullptr;
  const bool found = FcPatternGetString(pattern, property, 0, &text) == FcResultMatch;
  return found ? reinterpret_cast<const char*>(text) : "";
}

int number_of(const FcPattern* pattern, const char* property, int otherwise) {
  int number = otherwise;
  return FcPatternGetInteger(pattern, property, 0, &number) == FcResultMatch ? number : otherwise;
}

InstalledFont installed_font(const FcPattern* pattern) {
  InstalledFont font;
  font.family = text_of(pattern, FC_FAMILY);
  font.file = text_of(pattern, FC_FILE);
  font.weight = number_of(pattern, FC_WEIGHT, FC_WEIGHT_NORMAL);
  font.slant = number_of(pattern, FC_SLANT, FC_SLANT_ROMAN);
  font.width = number_of(pattern, FC_WIDTH, FC_WIDTH_NORMAL);
  FcCharSet* letters = nullptr;
  if (FcPatternGetCharSet(pattern, FC_CHARSET, 0, &letters) == FcResultMatch) {
    font.letters.reset(FcCharSetCopy(letters));
  }
  return font;
}

std::vector<InstalledFont> list_fonts() {
  const Pattern wanted(FcPatternCreate(), FcPatternDestroy);
  FcPatternAddBool(wanted.get(), FC_OUTLINE, FcTrue);
  FcPatternAddInteger(wanted.get(), FC_INDEX, 0);
  const ObjectSet properties(
      FcObjectSetBuild(FC_FAMILY, FC_FILE, FC_WEIGHT, FC_SLANT, FC_WIDTH, FC_CHARSET, static_cast<char*>(nullptr)),
      FcObjectSetDestroy);
  const FontSet found(FcFontList(nullptr, wanted.get(), properties.get()), FcFontSetDestroy);
  std::vector<InstalledFont> fonts;
  for (int i = 0; found && i < found->nfont; ++i) {
    InstalledFont font = installed_font(found->fonts[i]);
    if (font.letters) fonts.push_back(std::move(font));
  }
  std::ranges::sort(fonts, {}, &InstalledFont::file);
  return fonts;
}

}  // namespace

const std::vector<InstalledFont>& installed_fonts() {
  static const std::vector<InstalledFont> fonts = list_fonts();
  return fonts;
}

}  // namespace netpocket
