// What moves is drawn quickly, what rests is drawn well.

#include "gui/workbench/viewport/viewport.h"

#include <QAction>
#include <QTest>
#include <future>

#include "gui/workbench/timeline/timeline_bar.h"
#include "gui/workbench/viewport/drawing_thread.h"
#include "tests/gui/workbench/window_fixture.h"

namespace netpocket {
namespace {

class DraftTest : public WindowTest {
 protected:
  DraftTest() { EXPECT_TRUE(run_to(0.2)); }

  bool is_draft() const { return window_->viewport().state().draft; }
  bool comes_to_rest() const {
    return wait_until([this] { return !is_draft() && !window_->viewport().shown().draft; });
  }
};

TEST_F(DraftTest, PlayedFramesAreDraftsAndTheLastOneIsSmoothed) {
  ASSERT_TRUE(comes_to_rest());
  int frames = 0;
  const auto connection = QObject::connect(&window_->session(), &CaptureSession::frame_shown, window_.get(), [&] {
    ++frames;
    EXPECT_TRUE(is_draft());
  });
  window_->timeline().playback().set_loop(true);
  window_->timeline().playback().play(1);
  ASSERT_TRUE(wait_until([&] { return frames > 3; }));
  window_->timeline().playback().stop();
  QObject::disconnect(connection);
  ASSERT_TRUE(comes_to_rest());
  EXPECT_EQ(window_->viewport().shown().snapshot, window_->viewport().state().snapshot);
}

TEST_F(DraftTest, MovedCamerasSeeDrafts) {
  auto& viewport = window_->viewport();
  const auto moves = std::to_array<std::function<void()>>({
      [&] { QTest::keyClick(&viewport, Qt::Key_Left); },
      [&] { viewport.set_preset(CameraPreset::front); },
      [&] {
        QTest::mousePress(&viewport, Qt::LeftButton, {}, {100, 100});
        QTest::mouseMove(&viewport, {200, 150});
        QTest::mouseRelease(&viewport, Qt::LeftButton, {}, {200, 150});
      },
  });
  for (const auto& move : moves) {
    ASSERT_TRUE(comes_to_rest());
    move();
    EXPECT_TRUE(is_draft());
  }
  EXPECT_TRUE(comes_to_rest());
}

// Then there is nothing to draw better.
TEST_F(DraftTest, WithoutSmoothingNothingIsDrawnTwice) {
  auto& viewport = window_->viewport();
  SceneOptions options = viewport.options();
  options.fast_smoothing = false;
  viewport.set_options(options);
  ASSERT_TRUE(wait_until([&] { return viewport.shown().options == viewport.state().options; }));
  QTest::keyClick(&viewport, Qt::Key_Left);
  EXPECT_FALSE(is_draft());
  EXPECT_FALSE(viewport.state().smoothed());
}

TEST_F(DraftTest, DraftsAreNotSmoothed) {
  ASSERT_TRUE(comes_to_rest());
  std::promise<QImage> drawn;
  DrawingThread thread;
  const int canvas = thread.add([&](const DrawnPicture& picture) { drawn.set_value(picture.image); });
  const auto draw = [&](const ViewState& state) {
    drawn = {};
    thread.request(canvas, state, 320, 240);
    return drawn.get_future().get();
  };
  ViewState state = window_->viewport().state();
  const QImage smoothed = draw(state);
  state.draft = true;
  const QImage draft = draw(state);
  EXPECT_TRUE(draft != smoothed);
  SceneOptions options = *state.options;
  options.fast_smoothing = false;
  state = window_->viewport().state();
  state.options = std::make_shared<const SceneOptions>(options);
  EXPECT_TRUE(draw(state) == draft);
  thread.remove(canvas);
}

}  // namespace
}  // namespace netpocket
