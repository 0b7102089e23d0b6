// What the workbench says when there is nowhere to show its window.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/gui/program.h"

namespace netpocket {
namespace {

constexpr int kRendering = 6;  // gui/commands/exit_code.h

class NoDisplayTest : public testing::Test {
 protected:
  NoDisplayTest() { unsetenv("QT_QPA_PLATFORM"); }
  ~NoDisplayTest() override { unsetenv("QT_QPA_PLATFORM"); }

  // One sentence, one line, no core dump.
  static void expect_refusal(const char* platform, const std::string& reason) {
    if (platform) setenv("QT_QPA_PLATFORM", platform, 1);
    const auto result = run_program({"workbench"});
    EXPECT_EQ(result.exit_code, kRendering);
    EXPECT_TRUE(result.error.starts_with("netpocket: the workbench ")) << result.error;
    EXPECT_NE(result.error.find(reason), std::string::npos) << result.error;
    EXPECT_EQ(result.error.find('\n'), result.error.size() - 1) << result.error;
  }
};

TEST_F(NoDisplayTest, WithoutAny) { expect_refusal(nullptr, "neither DISPLAY nor WAYLAND_DISPLAY is set"); }

TEST_F(NoDisplayTest, ThatCannotBeReached) { expect_refusal("xcb:display=:4711", "cannot be reached"); }

TEST_F(NoDisplayTest, WithoutAFontOfTheWindow) {
  const TestFolder folder;
  folder.write("fonts.conf", R"(<?xml version="1.0"?>
<fontconfig>
  <dir>/usr/share/fonts</dir>
  <selectfont>
    <rejectfont><pattern><patelt name="family"><string>DejaVu Sans Mono</string></patelt></pattern></rejectfont>
  </selectfont>
</fontconfig>
)");
  setenv("QT_QPA_PLATFORM", "offscreen", 1);
  setenv("FONTCONFIG_FILE", folder.file("fonts.conf").c_str(), 1);
  const auto result = run_program({"workbench"});
  unsetenv("FONTCONFIG_FILE");
  EXPECT_EQ(result.exit_code, kRendering);
  EXPECT_EQ(result.error, "netpocket: the font DejaVu Sans Mono is not installed (Debian: fonts-dejavu-core)\n");
}

TEST_F(NoDisplayTest, WithAMisspeltPlatform) { expect_refusal("xbc", "there is no Qt platform \"xbc\""); }

}  // namespace
}  // namespace netpocket
