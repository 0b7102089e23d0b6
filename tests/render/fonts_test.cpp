// Texts and the fonts that draw them.
#include <gtest/gtest.h>

#include "render/fonts/drawable_text.h"
#include "render/fonts/shortened.h"

namespace netpocket {
namespace {

// In DejaVu Serif, which is installed with DejaVu Sans, but not in that.
constexpr const char* kOnlyInOthers = "\u2900";
// For private use: in no font that is to be had.
constexpr const char* kNowhere = "\U0010FFFD";

TEST(DrawableText, IsInDejaVuSansWhereItCanBe) {
  const auto drawable = drawable_text("Größe ∑ µ – Ωмега");
  EXPECT_EQ(drawable.text, "Größe ∑ µ – Ωмега");
  EXPECT_EQ(drawable.font, font_file());
  EXPECT_EQ(drawable_text("x", {.bold = true}).font, font_file({.bold = true}));
  EXPECT_NE(font_file({.mono = true}), font_file());
}

TEST(DrawableText, FallsBackToAnInstalledFont) {
  const auto drawable = drawable_text(std::string("run ") + kOnlyInOthers);
  EXPECT_EQ(drawable.text, std::string("run ") + kOnlyInOthers);
  EXPECT_NE(drawable.font, font_file());
  EXPECT_TRUE(missing_letters(kOnlyInOthers).empty());
}

TEST(DrawableText, PutsASignForWhatNoFontHas) {
  EXPECT_EQ(drawable_text(std::string("a") + kNowhere + "b\xff").text, "a\uFFFDb\uFFFD");
  EXPECT_EQ(missing_letters(std::string("a") + kNowhere + kNowhere), std::set<std::string>{kNowhere});
  EXPECT_TRUE(missing_letters("line\nbreak, tab\t, joiner \u200D, variant \uFE0F").empty());
}

TEST(Shortened, KeepsWhatFits) {
  const auto up_to = [](std::size_t bytes) { return [=](const std::string& text) { return text.size() <= bytes; }; };
  EXPECT_EQ(shortened("a long title", up_to(12)), "a long title");
  EXPECT_EQ(shortened("a long title", up_to(11)), "a long t\u2026");
  EXPECT_EQ(shortened("a long title", up_to(9)), "a long\u2026");  // no space before it
  EXPECT_EQ(shortened("\u00e4\u00f6\u00fc", up_to(5)), "\u00e4\u2026");
  EXPECT_EQ(shortened("abc", up_to(0)), "\u2026");
}

}  // namespace
}  // namespace netpocket
