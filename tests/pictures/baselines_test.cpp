// Pictures of the real program against those in tests/baselines. NETPOCKET_RENEW=1 renews them; look at them then.

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/gui/program.h"
#include "tests/pictures/baseline.h"
#include "tests/pictures/made_up_recordings.h"

namespace netpocket::pictures {
namespace {

struct PictureCase {
  std::string name;
  std::vector<std::string> options;  // of render; POCKET and so on stand for recordings
};

void PrintTo(const PictureCase& picture, std::ostream* out) { *out << picture.name; }

std::string test_name(const testing::TestParamInfo<PictureCase>& info) { return info.param.name; }

// Makes the recordings that the words name and puts their paths in.
std::vector<std::string> with_recordings(std::vector<std::string> words, const TestFolder& folder) {
  for (auto& word : words) {
    const std::string name = word;
    if (name == "POCKET") write_pocket_recording(word = folder.file("pocket.h5"));
    if (name == "OTHER") write_pocket_recording(word = folder.file("other.h5"), "other", Sphere{3.6});
    if (name == "BOX") write_pocket_recording(word = folder.file("box.h5"), "box", Box{{6, 7, 5}});
    if (name == "CYLINDER") write_pocket_recording(word = folder.file("cylinder.h5"), "cylinder", Cylinder{3, 7});
    if (name == "BROKEN") write_broken_recording(word = folder.file("broken.h5"));
    if (name == "SERIES") write_series_recording(word = folder.file("case1.h5"), "case1", 10);
    if (name == "FASTER") write_series_recording(word = folder.file("case2.h5"), "case2", 7.5);
    if (name == "FASTEST") write_series_recording(word = folder.file("case3.h5"), "case3", 5);
    if (name == "NOTHING") write_empty_series_recording(word = folder.file("nothing.h5"));
    if (name == "VIEW") {
      word = folder.write("view.toml", "position = [14, 16, 9]\nfocal_point = [0, 10, 0]\nview_angle = 40\n");
    }
  }
  return words;
}

void run(const std::vector<std::string>& arguments) {
  const auto result = run_program(arguments);
  ASSERT_EQ(result.exit_code, 0) << result.error;
}

class Frame : public testing::TestWithParam<PictureCase> {};

TEST_P(Frame, LooksLikeItsBaseline) {
  const TestFolder folder;
  std::vector<std::string> arguments = {"render", "-o", folder.file("out"), "--backend", "osmesa", "--quiet"};
  const auto options = with_recordings(GetParam().options, folder);
  if (std::ranges::find(options, "--size") == options.end()) arguments.insert(arguments.end(), {"--size", "480x320"});
  if (std::ranges::find(options, "--times") == options.end()) arguments.insert(arguments.end(), {"--times", "6"});
  arguments.insert(arguments.end(), options.begin(), options.end());
  run(arguments);
  expect_like_baseline(folder.file("out/0000.png"), GetParam().name);
}

INSTANTIATE_TEST_SUITE_P(
    Scene, Frame,
    testing::Values(
        PictureCase{"camera_iso", {"POCKET"}}, PictureCase{"camera_side", {"POCKET", "--camera", "side"}},
        PictureCase{"camera_front", {"POCKET", "--camera", "front"}},
        PictureCase{"camera_mouth", {"POCKET", "--camera", "mouth"}},
        PictureCase{"camera_follow", {"POCKET", "--camera", "follow"}},
        PictureCase{"camera_of_a_view_file", {"POCKET", "--view", "VIEW"}},
        PictureCase{"phase_open", {"POCKET", "--times", "0"}}, PictureCase{"phase_closed", {"POCKET", "--times", "8"}},
        PictureCase{"phase_towing", {"POCKET", "--times", "10"}},
        PictureCase{"space", {"POCKET", "--background", "space"}},
        PictureCase{"tension", {"POCKET", "--color-by", "tension"}},
        PictureCase{"tension_in_space", {"POCKET", "--color-by", "tension", "--background", "space"}},
        PictureCase{"strain", {"POCKET", "--color-by", "strain"}},
        PictureCase{"speed", {"POCKET", "--color-by", "speed", "--camera", "side"}},
        PictureCase{"contact_colors", {"POCKET", "--color-by", "contact", "--target-opacity", "0.4"}},
        PictureCase{"contact_arrows", {"POCKET", "--arrows"}},
        PictureCase{"contact_arrows_in_space", {"POCKET", "--arrows", "--background", "space", "--camera", "side"}},
        PictureCase{"ghost_and_trails", {"POCKET", "--times", "10", "--ghost", "--trails"}},
        PictureCase{"title", {"POCKET", "--title", "Made-up capture"}},
        PictureCase{"transparent", {"POCKET", "--transparent", "--target-opacity", "0.6"}}, PictureCase{"box", {"BOX"}},
        PictureCase{"cylinder", {"CYLINDER"}}, PictureCase{"broken", {"BROKEN", "--times", "5"}},
        PictureCase{"jagged", {"POCKET", "--supersampling", "1"}}, PictureCase{"tall", {"POCKET", "--size", "240x400"}},
        PictureCase{"side_by_side", {"POCKET", "OTHER", "--size", "300x300"}}),
    test_name);

class Sheet : public testing::TestWithParam<PictureCase> {};

TEST_P(Sheet, LooksLikeItsBaseline) {
  const TestFolder folder;
  std::vector<std::string> arguments = {"render", "--sheet", folder.file("sheet.png"), "--backend",
                                        "osmesa", "--quiet", "--panel-size",           "200x200"};
  const auto options = with_recordings(GetParam().options, folder);
  arguments.insert(arguments.end(), options.begin(), options.end());
  run(arguments);
  expect_like_baseline(folder.file("sheet.png"), GetParam().name);
}

INSTANTIATE_TEST_SUITE_P(Pages, Sheet,
                         testing::Values(PictureCase{"sheet", {"POCKET", "--times", "0,5,7.5,10", "--columns", "2"}},
                                         PictureCase{"sheet_of_two_runs", {"POCKET", "OTHER", "--times", "0,7"}}),
                         test_name);

class PaperFigure : public testing::TestWithParam<PictureCase> {};

TEST_P(PaperFigure, LooksLikeItsBaseline) {
  const TestFolder folder;
  const auto options = with_recordings(GetParam().options, folder);
  std::vector<std::string> arguments = {"plot", "-o", folder.file("figures"), "--dpi", "60"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  run(arguments);
  const auto figure = std::ranges::find(options, "--figure") + 1;
  expect_like_baseline(folder.file("figures/" + *figure + ".png"), GetParam().name);
}

INSTANTIATE_TEST_SUITE_P(
    Plots, PaperFigure,
    testing::Values(PictureCase{"figure03", {"SERIES", "--figure", "figure03_closing"}},
                    PictureCase{"figure05", {"SERIES", "--figure", "figure05_force"}},
                    PictureCase{"figure06", {"SERIES", "--figure", "figure06_position"}},
                    PictureCase{"figure09", {"SERIES", "FASTER", "FASTEST", "--figure", "figure09_force"}},
                    PictureCase{"figure10", {"FASTER", "--figure", "figure10_target_position"}},
                    PictureCase{"figure11", {"FASTEST", "--figure", "figure11_spacecraft_position"}},
                    PictureCase{"energy", {"SERIES", "--figure", "energy"}},
                    PictureCase{"tension_figure", {"SERIES", "FASTER", "--figure", "tension"}},
                    PictureCase{"one_frame", {"NOTHING", "--figure", "figure06_position"}}),
    test_name);

}  // namespace
}  // namespace netpocket::pictures
