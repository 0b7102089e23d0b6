// From a recording on disk to frames, video and sheet.

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/recording/recorder.h"
#include "engine/recording/recording.h"
#include "engine/scenario/scenario.h"
#include "engine/scenario/write_scenario.h"
#include "render/output/png_file.h"
#include "render/output/render_frames.h"
#include "render/output/render_sheet.h"
#include "render/output/run_renderer.h"
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

// Whether nothing is drawn within some pixels of a picture's edge.
bool has_empty_edge(const Image& image) {
  constexpr int kEdge = 3;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (std::min({x, y, image.width - 1 - x, image.height - 1 - y}) >= kEdge) continue;
      const auto* pixel = image.rgb.data() + static_cast<std::ptrdiff_t>(y) * image.width * 3 + 3 * x;
      if (!std::equal(pixel, pixel + 3, image.rgb.data())) return false;
    }
  }
  return true;
}

// A run in which everything moves by many times its size, with a net that is large for a moment.
class RunWithLargeMoment : public RenderRun {
 protected:
  static constexpr int kLargeFrame = 57;

  RunWithLargeMoment() {
    const auto structure = synthetic::make_structure();
    Recorder recorder(drifting(), {}, structure, true);
    for (int i = 0; i <= 200; ++i) {
      Snapshot snapshot = synthetic::make_snapshot(structure, i, i / 200.0);
      if (i == kLargeFrame) snapshot.positions *= 2.5;
      const Eigen::Vector3d moved = i * Eigen::Vector3d(1, 2, -0.5);
      snapshot.positions.colwise() += moved;
      for (BodyState& body : snapshot.bodies) body.position += moved;
      recorder.write(snapshot);
    }
    recorder.finish({RunReason::finished, 200, ""}, {});
  }

  std::string drifting() const { return folder_ + "/drifting.h5"; }

  static RunView bare_view(CameraPreset camera) {
    RunView view;
    view.backend = GlBackend::osmesa;
    view.camera = camera;
    view.frame.width = 300;
    view.frame.height = 300;
    view.share = {0.96, 0.92};  // of sheets
    view.frame.scene.axes = view.frame.scene.scale_bar = view.frame.scene.time_label = false;
    return view;
  }
};

TEST_F(RunWithLargeMoment, IsWholeAtTheTimesThatAreAskedFor) {
  const Recording recording(drifting());
  for (const CameraPreset camera : {CameraPreset::follow, CameraPreset::iso, CameraPreset::side}) {
    SCOPED_TRACE(static_cast<int>(camera));
    RunRenderer renderer(recording, common_view({&recording}, bare_view(camera), {0, kLargeFrame, 200}));
    for (const double time : {0, kLargeFrame, 200}) {
      const Image image = smooth_frame(renderer.draw(time));
      EXPECT_TRUE(has_empty_edge(image)) << time;
      EXPECT_GT(pictures::drawn_fraction(image), camera == CameraPreset::follow ? 0.02 : 0.0002) << time;
    }
  }
}

TEST_F(RunWithLargeMoment, IsClippedWhereNobodyAskedForThatMoment) {
  const Recording recording(drifting());
  RunRenderer renderer(recording, bare_view(CameraPreset::follow));
  EXPECT_FALSE(has_empty_edge(smooth_frame(renderer.draw(kLargeFrame))));
  EXPECT_TRUE(has_empty_edge(smooth_frame(renderer.draw(kLargeFrame + 1))));
}

}  // namespace
}  // namespace netpocket
