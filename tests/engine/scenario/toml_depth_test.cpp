#include "engine/scenario/toml_depth.h"

#include <gtest/gtest.h>

#include <string>

namespace netpocket {
namespace {

TEST(TomlDepth, CountsDotsOfKeysOnly) {
  EXPECT_EQ(line_of_too_deep_key("a.b = 1.5\n[c.d]\nx = [1.5, 2.5, 3.5]\n", 1), 0);
  EXPECT_EQ(line_of_too_deep_key("text = \"one. two. three.\" # four. five. six.\n", 1), 0);
  EXPECT_EQ(line_of_too_deep_key("text = '''\n. . .\n''' # x\ny = '. \\'\nz = \"\\\" . . .\"", 1), 0);
  EXPECT_EQ(line_of_too_deep_key("", 1), 0);
}

TEST(TomlDepth, FindsDeepKeysHoweverWritten) {
  EXPECT_EQ(line_of_too_deep_key("\n\na.b.c = 1", 1), 3);
  EXPECT_EQ(line_of_too_deep_key("[a . b . c]", 1), 1);
  EXPECT_EQ(line_of_too_deep_key("x = {a.b.c = 1}", 1), 1);
  EXPECT_EQ(line_of_too_deep_key("\"a,\".\"b,\".'c=' = 1", 1), 1);
  EXPECT_EQ(line_of_too_deep_key("1.2.3 = 1", 1), 1);
  EXPECT_EQ(line_of_too_deep_key("t = \"\"\"a\nb\"\"\"\na.b.c = 1", 1), 3);
}

TEST(TomlDepth, EndsAtEveryUnfinishedToken) {
  for (const char* text : {"\"", "'", "\"\"\"", "'''", "\"\\", "\"\"\"\\", "#", "a.", "\"\"\"\"\""}) {
    EXPECT_EQ(line_of_too_deep_key(text, 1), 0) << text;
  }
}

}  // namespace
}  // namespace netpocket
