#include "render/gl/gl_host.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <functional>

#include "render/output/png_file.h"
#include "render/render_error.h"
#include "tests/render/picture_checks.h"

namespace netpocket {
namespace {

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const RenderError& error) {
    return error.what();
  }
  return {};
}

int draw_pocket(const std::string& environment, const std::string& arguments) {
  const std::string command =
      "env -u DISPLAY -u WAYLAND_DISPLAY " + environment + " " NETPOCKET_DRAW_POCKET " " + arguments;
  return WEXITSTATUS(std::system(command.c_str()));
}

TEST(GlHost, NamesOfBackends) {
  EXPECT_EQ(gl_backend_from_name("auto"), GlBackend::automatic);
  EXPECT_EQ(gl_backend_from_name("osmesa"), GlBackend::osmesa);
  EXPECT_EQ(gl_backend_from_name("egl"), GlBackend::egl);
  EXPECT_EQ(message_of([] { gl_backend_from_name("opengl"); }),
            "unknown rendering back end 'opengl': use auto, osmesa or egl");
}

TEST(GlHost, ReportsWhatIsThere) {
  const auto reports = available_backends();
  ASSERT_EQ(reports.size(), 2u);
  for (const auto& report : reports) EXPECT_FALSE(report.detail.empty()) << report.name;
  // Both are among the packages that ./dev installs.
  EXPECT_TRUE(reports[0].available) << reports[0].detail;
  EXPECT_TRUE(reports[1].available) << reports[1].detail;
  EXPECT_NE(reports[0].detail.find("OpenGL"), std::string::npos);
}

TEST(GlHost, DrawsThroughOneLibraryOnly) {
  const auto host = make_gl_host(GlBackend::osmesa);
  EXPECT_EQ(host->name(), "osmesa");
  EXPECT_TRUE(host->is_current());
  EXPECT_NE(message_of([] { make_gl_host(GlBackend::egl); }).find("already draws with OSMesa"), std::string::npos);
}

TEST(GlHost, MissingLibraryIsOneSentence) {
  const auto folder = pictures::folder("missing_library");
  const auto errors = folder + "/errors.txt";
  EXPECT_EQ(draw_pocket("NETPOCKET_OSMESA=libNoSuchMesa.so.8", folder + "/none.png 2>" + errors), 6);
  std::ifstream file(errors);
  std::string first, second;
  std::getline(file, first);
  std::getline(file, second);
  EXPECT_NE(first.find("cannot draw with osmesa: cannot load the OpenGL library: libNoSuchMesa.so.8"),
            std::string::npos)
      << first;
  EXPECT_TRUE(second.empty()) << second;
  EXPECT_FALSE(std::filesystem::exists(folder + "/none.png"));
}

TEST(GlHost, AutomaticFallsBackWhenOneIsMissing) {
  const auto folder = pictures::folder("fallback");
  EXPECT_EQ(
      draw_pocket("NETPOCKET_OSMESA=libNoSuchMesa.so.8", folder + "/egl.png --backend auto --width 320 --height 180"),
      0);
  EXPECT_GT(pictures::drawn_fraction(read_png(folder + "/egl.png")), 0.05);
}

// Both are Mesa's software rasteriser here; a graphics device may round differently, hence a few levels on a few
// pixels.
TEST(GlHost, BackendsDrawTheSame) {
  const auto folder = pictures::folder("backends");
  const std::string size = " --width 640 --height 360 --closed 0.5 --color-by tension";
  ASSERT_EQ(draw_pocket("", folder + "/osmesa.png --backend osmesa" + size), 0);
  ASSERT_EQ(draw_pocket("", folder + "/egl.png --backend egl" + size), 0);
  const auto osmesa = read_png(folder + "/osmesa.png"), egl = read_png(folder + "/egl.png");
  EXPECT_GT(pictures::drawn_fraction(osmesa), 0.1);
  EXPECT_LT(pictures::differing_fraction(osmesa, egl, 4), 0.001);
}

}  // namespace
}  // namespace netpocket
