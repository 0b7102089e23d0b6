#include "render/fonts/drawable_text.h"

#include <algorithm>
#include <tuple>

#include "render/fonts/installed_fonts.h"

namespace netpocket {
namespace {

using Letters = std::u32string;

constexpr char32_t kReplacement = 0xFFFD;

Letters letters_of(std::string_view text) {
  Letters letters;
  const auto* next = reinterpret_cast<const FcChar8*>(text.data());
  int left = static_cast<int>(text.size());
  while (left > 0) {
    FcChar32 letter = 0;
    const int length = FcUtf8ToUcs4(next, &letter, left);
    const bool valid = length > 0 && letter <= 0x10FFFF && (letter < 0xD800 || letter > 0xDFFF);
    letters += valid ? static_cast<char32_t>(letter) : kReplacement;
    next += valid ? length : 1;
    left -= valid ? length : 1;
  }
  return letters;
}

std::string utf8_of(const Letters& letters) {
  std::string text;
  for (const char32_t letter : letters) {
    FcChar8 bytes[FC_UTF8_MAX_LEN];
    const int length = FcUcs4ToUtf8(letter, bytes);
    text.append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(length));
  }
  return text;
}

// Control characters, joiners and selectors of variants have no look of their own.
bool is_invisible(char32_t letter) {
  return letter < 0x20 || (letter >= 0x200B && letter <= 0x200F) || (letter >= 0xFE00 && letter <= 0xFE0F);
}

bool lacks(const InstalledFont& font, char32_t letter) { return !is_invisible(letter) && !font.has(letter); }

// The fewer letters a font lacks and the nearer its style, the better.
auto badness(const InstalledFont& font, const Letters& letters, const FontStyle& style) {
  const auto missing = std::ranges::count_if(letters, [&](char32_t letter) { return lacks(font, letter); });
  const int weight = style.bold ? FC_WEIGHT_BOLD : FC_WEIGHT_NORMAL;
  return std::tuple(missing, (font.slant != FC_SLANT_ROMAN) != style.italic, std::abs(font.weight - weight),
                    std::abs(font.width - FC_WIDTH_NORMAL));
}

const InstalledFont& best_font(const Letters& letters, const FontStyle& style) {
  const auto& fonts = installed_fonts();
  const auto own = std::ranges::find(fonts, font_file(style), &InstalledFont::file);
  if (std::ranges::none_of(letters, [&](char32_t letter) { return lacks(*own, letter); })) return *own;
  return *std::ranges::min_element(fonts, {}, [&](const auto& font) { return badness(font, letters, style); });
}

}  // namespace

DrawableText drawable_text(std::string_view text, const FontStyle& style) {
  Letters letters = letters_of(text);
  const InstalledFont& font = best_font(letters, style);
  const char32_t sign = font.has(kReplacement) ? kReplacement : U'?';
  std::ranges::replace_if(
      letters, [&](char32_t letter) { return lacks(font, letter); }, sign);
  return {utf8_of(letters), font.file};
}

std::set<std::string> missing_letters(std::string_view text, const FontStyle& style) {
  const Letters letters = letters_of(text);
  const InstalledFont& font = best_font(letters, style);
  std::set<std::string> missing;
  for (const char32_t letter : letters) {
    if (lacks(font, letter)) missing.insert(utf8_of({letter}));
  }
  return missing;
}

}  // namespace netpocket
