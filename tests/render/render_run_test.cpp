// From a recording on disk to frames, video and sheet.

#include <gtest/gtest.h>

#include "engine/recording/recorder.h"
#include "engine/recording/recording.h"
#include "engine/scenario/scenario.h"
#include "engine/scenario/write_scenario.h"
#include "render/output/png_file.h"
#include "render/output/render_frames.h"
#include "render/output/render_sheet.h"
#include "render/render_error.h"
#include "tests/render/picture_checks.h"
#include "tests/render/synthetic_pocket.h"

namespace netpocket {
namespace {

namespace fs = std::filesystem;

constexpr int kFrames = 11;  // 0, 1, ... 10 s

class RenderRun : public testing::Test {
 protected:
  RenderRun() {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = pictures::folder("run/" + test);
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    RunOrigin origin;
    origin.scenario_name = "made_up";
    origin.scenario_text = write_scenario_text(Scenario{});
    const auto structure = synthetic::make_structure();
    Recorder recorder(file(), origin, structure, true);
    for (int i = 0; i < kFrames; ++i) recorder.write(synthetic::make_snapshot(structure, i, i / 10.0));
    recorder.finish({RunReason::finished, 10, ""}, {});
  }

  std::string file() const { return folder_ + "/run.h5"; }

  RenderOptions options() const {
    RenderOptions options;
    options.view.backend = GlBackend::osmesa;
    options.view.frame.width = 320;
    options.view.frame.height = 180;
    options.folder = folder_ + "/frames";
    return options;
  }

  std::string folder_;
};

TEST_F(RenderRun, WritesNumberedFrames) {
  const Recording recording(file());
  std::vector<RenderProgress> reports;
  const auto outcome = render_frames(recording, {0, 4.9, 10}, options(), [&](const auto& p) { reports.push_back(p); });
  EXPECT_EQ(outcome, RenderOutcome::finished);
  ASSERT_EQ(reports.size(), 3u);
  EXPECT_EQ(reports.back().done, 3u);
  EXPECT_EQ(reports.back().total, 3u);
  EXPECT_EQ(reports.back().seconds_left, 0);
  for (const char* name : {"0000.png", "0001.png", "0002.png"}) {
    EXPECT_GT(pictures::drawn_fraction(read_png(options().folder + "/" + name)), 0.05) << name;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(options().folder), {}), 3);
  EXPECT_GT(pictures::differing_fraction(read_png(options().folder + "/0000.png"),
                                         read_png(options().folder + "/0002.png"), 10),
            0.05);
}

TEST_F(RenderRun, CancelLeavesWholeFilesOnly) {
  const Recording recording(file());
  std::stop_source stop;
  auto with_video = options();
  with_video.video = folder_ + "/video.mp4";
  const auto outcome = render_frames(
      recording, frame_times(recording, 1), with_video,
      [&](const auto& p) {
        if (p.done == 3) stop.request_stop();
      },
      stop.get_token());
  EXPECT_EQ(outcome, RenderOutcome::cancelled);
  int count = 0;
  for (const auto& entry : fs::directory_iterator(options().folder)) {
    EXPECT_NO_THROW(read_png(entry.path())) << entry.path();
    ++count;
  }
  EXPECT_EQ(count, 3);
  EXPECT_FALSE(fs::exists(with_video.video));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 2);  // frames and run.h5
}

TEST_F(RenderRun, MakesAVideoWithoutKeepingFrames) {
  const Recording recording(file());
  auto only_video = options();
  only_video.folder.clear();
  only_video.video = folder_ + "/video.mp4";
  render_frames(recording, frame_times(recording, 2), only_video);
  EXPECT_GT(fs::file_size(only_video.video), 2000u);
  EXPECT_FALSE(fs::exists(folder_ + "/frames"));
}

TEST_F(RenderRun, MakesASheet) {
  const Recording recording(file());
  SheetOptions sheet;
  sheet.view.backend = GlBackend::osmesa;
  sheet.view.frame.scene.color_by = ColorBy::tension;
  const auto path = folder_ + "/sheet.png";
  render_sheet(recording, {0, 2, 4, 6, 8, 10}, path, sheet);
  const auto image = read_png(path);
  EXPECT_EQ(image.width, 24 + 3 * (640 + 24));
  EXPECT_EQ(image.height, 24 + 2 * (640 + 39 + 24));
  EXPECT_GT(pictures::drawn_fraction(image), 0.05);
}

TEST_F(RenderRun, UnwritableFolderIsOneSentence) {
  const Recording recording(file());
  auto bad = options();
  bad.folder = file() + "/frames";  // below a file
  try {
    render_frames(recording, {0}, bad);
    FAIL();
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("cannot make the folder"), std::string::npos) << error.what();
  }
  EXPECT_THROW(render_frames(recording, {}, options()), RenderError);
  EXPECT_THROW(frame_times(recording, 0), RenderError);
}

TEST_F(RenderRun, FrameTimesCoverTheRun) {
  const Recording recording(file());
  EXPECT_EQ(frame_times(recording, 25).size(), 251u);
  EXPECT_DOUBLE_EQ(frame_times(recording, 25).back(), 10);
}

TEST_F(RenderRun, FollowsTheTarget) {
  const Recording recording(file());
  auto following = options();
  following.view.camera = CameraPreset::follow;
  EXPECT_EQ(render_frames(recording, {0, 10}, following), RenderOutcome::finished);
  EXPECT_GT(pictures::drawn_fraction(read_png(options().folder + "/0001.png")), 0.05);
}

}  // namespace
}  // namespace netpocket
