#include "render/figures/rich_text.h"

#include <gtest/gtest.h>

namespace netpocket {
namespace {

using Runs = std::vector<TextRun>;

TEST(RichText, KnowsItalicAndScripts) {
  EXPECT_EQ(parse_rich_text("*F*_{y} (N)"), (Runs{{"F", true, 0}, {"y", false, -1}, {" (N)", false, 0}}));
  EXPECT_EQ(parse_rich_text("×10^{−3}"), (Runs{{"×10", false, 0}, {"−3", false, +1}}));
  EXPECT_EQ(parse_rich_text(""), Runs{});
}

TEST(RichText, LeavesOrdinaryPunctuationAlone) {
  EXPECT_EQ(parse_rich_text("a_b ^ {c}"), (Runs{{"a_b ^ {c}", false, 0}}));
}

TEST(RichText, ShowsNamesAsTheyAre) {
  for (const char* name : {"case1", "a*b", "x_{1}", "back\\slash", "2^{3}"}) {
    EXPECT_EQ(parse_rich_text(plain_text(name)), (Runs{{name, false, 0}}));
  }
}

}  // namespace
}  // namespace netpocket
