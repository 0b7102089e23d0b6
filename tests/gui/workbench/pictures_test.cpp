// How the window looks, against pictures that people have looked at. What it shows is made up (tests/render), so that
// no change of the engine changes a picture.

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLineEdit>
#include <QTabWidget>
#include <QTest>
#include <cmath>
#include <utility>

#include "engine/recording/recorder.h"
#include "engine/scenario/write_scenario.h"
#include "engine/state/pocket_groups.h"
#include "gui/workbench/dialogs/preferences_dialog.h"
#include "gui/workbench/editor/scenario_editor.h"
#include "gui/workbench/editor/text_page.h"
#include "gui/workbench/editor/toml_edit_view.h"
#include "gui/workbench/panels/findings_panel.h"
#include "gui/workbench/panels/plots_panel.h"
#include "gui/workbench/second_view.h"
#include "gui/workbench/timeline/timeline_bar.h"
#include "gui/workbench/view_actions.h"
#include "gui/workbench/viewport/orbit_camera.h"
#include "gui/workbench/viewport/viewport.h"
#include "tests/gui/workbench/window_fixture.h"
#include "tests/pictures/baseline.h"
#include "tests/render/synthetic_pocket.h"

namespace netpocket {
namespace {

constexpr int kFrames = 101;       // 0, 0.1, ... 10 s
constexpr double kTouched = 5.6;   // s
constexpr double kPeakForce = 42;  // N

// Channels with the look of a capture: a force that comes, turns and goes.
void make_up_channels(Snapshot& frame) {
  const double t = frame.time, since = std::max(0.0, t - kTouched), closed = t / 10;
  frame.channel(Channel::time) = t;
  frame.channel(Channel::closing_length) = frame.channel(Channel::commanded_length) = 5.8 - 3.7 * closed;
  frame.channel(Channel::closing_speed) = frame.channel(Channel::commanded_speed) = -0.37;
  frame.channel(Channel::contact_fy) = kPeakForce * std::sin(1.9 * since) * std::exp(-0.4 * since);
  frame.channel(Channel::contact_count) = since > 0 ? 24 : 0;
  frame.channel(Channel::target_y) = 7.5 - 0.01 * since * since;
  frame.channel(Channel::spacecraft_y) = -1 + 0.002 * since * since;
  frame.channel(Channel::energy_kinetic) = 3 * closed;
  frame.channel(Channel::energy_input) = 5 * closed;
  frame.channel(Channel::energy_error) = 1e-4 * closed;
  frame.channel(Channel::time_step) = 1e-4;
}

Snapshot made_up_frame(const Structure& structure, int index) {
  Snapshot frame = synthetic::make_snapshot(structure, 0.1 * index, index / (kFrames - 1.0));
  make_up_channels(frame);
  return frame;
}

RunStatistics made_up_statistics() {
  RunStatistics statistics;
  statistics.time_step = 1e-4;
  statistics.step_limit = "axial wave in panel 3";
  return statistics;
}

class PictureTest : public WindowTest {
 protected:
  PictureTest() {
    if (options_.presenter != PresenterKind::image) return;
    window_->resize(1280, 800);
    editor().search()->setText("duration");
    auto* runs = window_->findChild<QDockWidget*>("runs");
    runs->raise();
    window_->viewport().setFocus();
  }

  void SetUp() override {
    if (options_.presenter != PresenterKind::image) GTEST_SKIP() << "baselines are drawn by the image presenter";
  }

  ScenarioEditor& editor() const { return window_->editor(); }

  // A scenario of which nothing is left to defaults that may change.
  void edit_scenario() const {
    write_file("frozen.toml", R"(name = "frozen"
[pocket]
rod_count = 8
mesh_columns = 4
mesh_rows = 4
elements_per_side = 1
[rods]
profile = [[0.6, 0], [4.8, 5.3], [7.56, 12]]
outer_diameter = 0.1
[spacecraft]
position = [0, -1, 0]
size = [1.6, 2, 1.6]
[target]
shape = "sphere"
radius = 4.2
position = [0, 7.5, 0]
[closing]
law = "cycloid"
start = 0
duration = 10
closed_length = 2.1
elements = 2
[towing]
mode = "force"
start = 10
duration = 4
[output]
end_time = 14
)");
    window_->open(file("frozen.toml"));
  }

  // A made-up recording, opened.
  void open_recording() {
    RunOrigin origin;
    origin.scenario_name = "made_up";
    origin.scenario_text = write_scenario_text(Scenario{});
    origin.phases = pocket_phases(0, 10, std::numeric_limits<double>::quiet_NaN());
    const Structure structure = synthetic::make_structure();
    {
      Recorder recorder(file("made_up.h5").toStdString(), origin, structure, true);
      for (int i = 0; i < kFrames; ++i) recorder.write(made_up_frame(structure, i));
      recorder.finish({RunReason::finished, 10, ""}, made_up_statistics());
    }
    edit_scenario();
    // Modified, so that the recording's scenario, which is the default one, is not taken over.
    ASSERT_FALSE(window_->document().set_value(*find_parameter("closing.duration"), 9.0));
    window_->open(file("made_up.h5"));
    ASSERT_TRUE(wait_until([&] { return window_->session().current() != nullptr; }));
    // It is framed for the moment that is seen first.
    ASSERT_TRUE(
        wait_until([&] { return window_->viewport().state().structure == window_->session().current()->structure; }));
    window_->plots().show_figure("figure05_force");
    window_->timeline().go_to(7);
    ASSERT_TRUE(wait_until([&] {
      const ViewState& state = window_->viewport().state();
      return state.structure == window_->session().current()->structure && std::abs(state.snapshot->time - 7) < 1e-6;
    }));
  }

  // A run that the window takes for one of the simulation's: 7 s of it are made up. Its state is to be set.
  RunId begin_live_run() {
    edit_scenario();
    auto& session = window_->session();
    session.start(window_->document().scenario(), false);
    EXPECT_TRUE(wait_until([&] { return session.live()->state == RunState::paused; }));
    const RunId id = session.live()->id;
    // The simulation's own recording, of the first frame, gives way to another.
    session.runs().finish(id);
    const auto structure = std::make_shared<const Structure>(synthetic::make_structure());
    session.runs().begin(id, structure, window_->document().scenario());
    session.runs().finish_writing();
    session.live()->file->write(made_up_frame(*structure, 0));  // in place of the simulation's
    for (int i = 1; i <= 70; ++i) {
      constexpr double kSpeed = 0.42;
      const auto frame = std::make_shared<const Snapshot>(made_up_frame(*structure, i));
      session.runs().append(id, frame, made_up_statistics(), kSpeed);
    }
    window_->plots().show_figure("figure05_force");
    return id;
  }

  void set_live_state(RunId id, RunState state, const RunStatus& status = {}) {
    auto& session = window_->session();
    session.runs().set_state(id, state, status, made_up_statistics());
    session.set_follow(true);
    EXPECT_TRUE(wait_until([&] { return std::abs(window_->viewport().state().snapshot->time - 7) < 1e-6; }));
    window_->viewport().set_preset(CameraPreset::iso);
  }

  QImage picture() {
    EXPECT_TRUE(wait_for_picture());
    QTest::qWait(400);  // plots follow within 50 ms, marks within 250 ms
    EXPECT_TRUE(wait_for_picture());
    return window_->grab().toImage();
  }

  void expect_like_baseline(const QImage& picture, const QString& name) const {
    const QString path = file(name + ".png");
    ASSERT_TRUE(picture.convertToFormat(QImage::Format_RGB888).save(path));
    pictures::expect_like_baseline(path.toStdString(), "window_" + name.toStdString());
  }

  static QPalette dark() {
    QPalette palette(QColor(45, 48, 54), QColor(38, 41, 46));
    palette.setColor(QPalette::Base, QColor(30, 32, 36));
    return palette;
  }
};

TEST_F(PictureTest, ScenarioBeforeAnyRun) {
  edit_scenario();
  expect_like_baseline(picture(), "scenario");
}

TEST_F(PictureTest, Recording) {
  open_recording();
  expect_like_baseline(picture(), "recording");
}

TEST_F(PictureTest, RecordingInTheDark) {
  const QPalette light = QApplication::palette();
  QApplication::setPalette(dark());
  open_recording();
  expect_like_baseline(picture(), "recording_dark");
  QApplication::setPalette(light);
}

TEST_F(PictureTest, Running) {
  set_live_state(begin_live_run(), RunState::running);
  expect_like_baseline(picture(), "running");
}

TEST_F(PictureTest, Diverged) {
  const RunStatus status = {RunReason::diverged, 7,
                            "panel 3 row 2 (element 214), in contact with the target, moves at 165 km/s in step 70000 "
                            "of 100 µs, at t = 7.0000 s; try a solver.time_step below 5e-05 s"};
  set_live_state(begin_live_run(), RunState::ended, status);
  emit window_->session().run_diverged(
      "The run has diverged and stands still: " + QString::fromStdString(status.message) + ".");
  expect_like_baseline(picture(), "diverged");
}

TEST_F(PictureTest, NeedsARestart) {
  set_live_state(begin_live_run(), RunState::running);
  editor().search()->setText("diameter");
  ASSERT_FALSE(window_->document().set_value(*find_parameter("net.diameter"), 0.005));
  ASSERT_FALSE(window_->document().set_value(*find_parameter("rods.outer_diameter"), 0.12));
  expect_like_baseline(picture(), "needs_restart");
}

TEST_F(PictureTest, Findings) {
  open_recording();
  window_->findChild<QDockWidget*>("findings")->raise();
  ASSERT_TRUE(wait_until([&] { return !window_->findings().findings().empty(); }));
  expect_like_baseline(picture(), "findings");
}

TEST_F(PictureTest, SecondView) {
  open_recording();
  window_->view_actions().second_view_action()->trigger();
  // Cameras are aimed when both views have come to their places.
  QSize before;
  ASSERT_TRUE(wait_until([&] {
    const QSize last = std::exchange(before, QSize(window_->viewport().width(), window_->second_view()->width()));
    QTest::qWait(100);
    return before == last && before == QSize(window_->viewport().width(), window_->second_view()->width());
  }));
  window_->viewport().fit();
  window_->second_view()->viewport().set_preset(CameraPreset::front);
  expect_like_baseline(picture(), "second_view");
}

TEST_F(PictureTest, PickedAndPlotted) {
  open_recording();
  ASSERT_TRUE(wait_for_picture());
  const std::int32_t tip = window_->viewport().state().structure->nodes(kRodTips)[1];
  window_->viewport().select(Pick{PickKind::node, tip, 0, {0, 0, 0}});
  emit window_->viewport().plot_requested(*window_->viewport().selection());
  ASSERT_TRUE(wait_until([&] { return window_->plots().figure_name() == "picked"; }));
  expect_like_baseline(picture(), "picked");
}

TEST_F(PictureTest, Measuring) {
  open_recording();
  ASSERT_TRUE(wait_for_picture());  // cameras are aimed when the layout has come to rest
  window_->viewport().set_preset(CameraPreset::front);
  ASSERT_TRUE(wait_for_picture());
  window_->viewport().set_measuring(true);
  const ViewState& shown = window_->viewport().shown();
  for (const std::size_t rod : {0u, 3u}) {
    const Eigen::Vector3d tip = shown.snapshot->positions.col(shown.structure->nodes(kRodTips)[rod]);
    const auto seen = OrbitCamera(shown.camera).project(tip, window_->viewport().size());
    QTest::mouseClick(&window_->viewport(), Qt::LeftButton, {}, seen->position.toPoint());
  }
  ASSERT_EQ(window_->viewport().measured().size(), 2u);
  expect_like_baseline(picture(), "measuring");
}

TEST_F(PictureTest, TextWithAnError) {
  edit_scenario();
  editor().tabs()->setCurrentWidget(editor().text_page());
  editor().text_page()->view()->setPlainText("name = \"frozen\"\n[closing]\ndurration = 5\n");
  EXPECT_FALSE(window_->scenario_to_run());
  window_->viewport().setFocus();
  expect_like_baseline(picture(), "text_error");
}

TEST_F(PictureTest, Preferences) {
  Preferences preferences;
  preferences.folder = "/captures";  // the default is the home folder of whoever tests
  PreferencesDialog dialog(preferences, 96 << 20, nullptr);
  expect_like_baseline(dialog.grab().toImage(), "preferences");
}

}  // namespace
}  // namespace netpocket
