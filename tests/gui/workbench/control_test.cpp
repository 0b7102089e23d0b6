// The control dock: loops as data, live gains, disturbances at a click, and the comparison with a run without control.

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>
#include <algorithm>

#include "engine/capture/checkpoint_log.h"
#include "engine/recording/recording.h"
#include "gui/workbench/control/control_actions.h"
#include "gui/workbench/control/control_panel.h"
#include "gui/workbench/control/disturbance_form.h"
#include "gui/workbench/control/disturbance_words.h"
#include "gui/workbench/control/gain_form.h"
#include "gui/workbench/control/load_bar.h"
#include "gui/workbench/control/loop_reading.h"
#include "gui/workbench/control/loop_values.h"
#include "gui/workbench/editor/number_edit.h"
#include "gui/workbench/editor/parameter_row.h"
#include "gui/workbench/editor/scenario_editor.h"
#include "gui/workbench/panels/plots_panel.h"
#include "gui/workbench/timeline/timeline_bar.h"
#include "render/figures/control_loops.h"
#include "tests/gui/workbench/window_fixture.h"

namespace netpocket {
namespace {

enum Column { kLoop, kState, kError, kLoad };

// ---- readings and bars ----

TEST(LoopReading, TakesValuesFromChannels) {
  const ChannelList channels(
      {{"time", "s", ""}, {"s", "1", ""}, {"w", "m", ""}, {"a", "m", ""}, {"f", "N", ""}, {"l", "1", ""}});
  ControlLoopInfo loop;
  loop.state = {"s"};
  loop.set_point = {"w"};
  loop.actual = {"a"};
  loop.delivered = {"f"};
  loop.load = {"l"};
  const LoopReading active = read_loop(loop, channels, {0, 1, 2, 5, 7, 1.5});
  EXPECT_EQ(active.state, LoopState::active);
  EXPECT_EQ(active.error, std::vector<double>{3});  // actual minus set point
  EXPECT_EQ(active.unit, "m");
  EXPECT_EQ(active.effort_unit, "N");
  EXPECT_TRUE(active.is_saturated());
  const LoopReading waiting = read_loop(loop, channels, {0, 0, 2, 5, 7, 0.5});
  EXPECT_TRUE(waiting.error.empty());
  EXPECT_FALSE(waiting.is_saturated());
  const LoopReading nothing = read_loop(loop, channels, {});
  EXPECT_FALSE(nothing.state);
  EXPECT_TRUE(nothing.actual.empty());
  loop.actual = {"missing"};
  EXPECT_TRUE(read_loop(loop, channels, {0, 1, 2, 5, 7, 1.5}).actual.empty());
}

TEST(LoadBar, SaysSaturatedInWordsToo) {
  LoadBar bar;
  bar.show_load(0.436, true, false);
  EXPECT_EQ(bar.text(), "43 %");
  const QImage below = bar.grab().toImage();
  bar.show_load(3, true, true);
  EXPECT_EQ(bar.text(), "saturated");
  EXPECT_NE(bar.grab().toImage(), below);
  bar.show_load({}, false, false);
  EXPECT_EQ(bar.text(), "no limit");
}

TEST(Disturbances, AreNamedInPlainWords) {
  DisturbanceParameters disturbance;
  disturbance.torque = {0, -20, 0};
  disturbance.duration = 0.5;
  EXPECT_EQ(disturbance_words(disturbance), QString("-20 N\u202fm about y on the spacecraft for 0.5 s"));
  disturbance = {DisturbedBody::target, {3, 0, 0}, {0, 0, 0}, 0, 1};
  EXPECT_EQ(disturbance_words(disturbance), "3 N along x on the target for 1 s");
}

// ---- the window ----

constexpr const char* kControlled = R"(name = "controlled"
[pocket]
mesh_columns = 2
mesh_rows = 2
elements_per_side = 1
[closing]
duration = 0.8
[towing]
mode = "none"
[output]
end_time = 2
[actuators]
kind = "box"
most_torque = [2, 50, 50]
[winch]
drive = "length"
# The spacecraft is to turn.
[[controller]]
kind = "attitude_pd"
attitude = [0.1, 0, 0]         # rad (my choice)
[[controller]]
kind = "position_sliding_mode"
phase = "closed"
observer = 2
)";

class ControlTest : public WindowTest {
 protected:
  ControlTest() {
    EXPECT_TRUE(window_->document().start_from(QString(kControlled)).ok());
    dock()->show();
    dock()->raise();
  }

  QDockWidget* dock() const { return window_->findChild<QDockWidget*>("control"); }
  ControlPanel& panel() const { return window_->control(); }
  CaptureSession& session() const { return window_->session(); }
  const netpocket::Run& live() const { return *session().live(); }
  // Runs on to a time, s, and waits there.
  bool go_on_to(double time) {
    session().resume({.until = time});
    return wait_until([&] { return live().end_time() >= time - 1e-6 && live().state != RunState::running; });
  }
  static double last(const netpocket::Run& run, const char* channel) {
    return run.series.channels[*run.series.channel_list->find(channel)].back();
  }
};

TEST_F(ControlTest, ShowsTheLoopsBeforeAnyRun) {
  ASSERT_TRUE(wait_until([&] { return panel().list()->topLevelItemCount() == 10; }));
  EXPECT_EQ(panel().text(0, kLoop), "Attitude PD");
  EXPECT_EQ(panel().text(0, kState), "–");
  EXPECT_EQ(panel().text(9, kLoop), "Winch 8");
  EXPECT_FALSE(panel().disturbances()->button()->isEnabled());
  EXPECT_FALSE(panel().compare_button()->isEnabled());
  EXPECT_FALSE(panel().compare_button()->toolTip().isEmpty());
}

TEST_F(ControlTest, FollowsTheRunAndTheShownFrame) {
  ASSERT_TRUE(run_to(0.4));
  EXPECT_EQ(panel().text(0, kState), "active");
  EXPECT_EQ(panel().text(0, kLoad), "saturated");  // 0.1 rad ask for 107 N m, and there are 2
  EXPECT_EQ(panel().text(1, kState), "waiting");
  EXPECT_EQ(panel().text(1, kError), "–");
  EXPECT_EQ(panel().text(2, kState), "active");
  const QString at_end = panel().text(2, kError);
  EXPECT_TRUE(panel().values()->row_text(0).startsWith("Set point 0.1 0 0 rad"))
      << panel().values()->row_text(0).toStdString();
  EXPECT_TRUE(panel().values()->row_text(4).startsWith("Delivered"));
  screenshot("control");
  window_->timeline().go_to(0);
  ASSERT_TRUE(wait_until([&] { return panel().text(2, kError) != at_end; }));
  // A recording that is opened shows the same.
  session().runs().save(live().id, file("run.h5"));
  session().runs().finish_writing();
  const std::size_t before = session().runs().ids().size();
  window_->open(file("run.h5"));
  ASSERT_TRUE(wait_until([&] { return session().runs().ids().size() > before; }));
  window_->timeline().go_to(0.4);
  ASSERT_TRUE(wait_until([&] { return panel().text(2, kError) == at_end; }));
  EXPECT_EQ(panel().text(0, kLoad), "saturated");
}

TEST_F(ControlTest, TheDockComesWithTheFirstLoops) {
  reopen();
  EXPECT_FALSE(dock()->isVisible());
  ASSERT_TRUE(window_->document().start_from(QString(kControlled)).ok());
  // As a tab behind the scenario.
  ASSERT_TRUE(wait_until([&] { return !dock()->isHidden(); }));
  EXPECT_FALSE(window_->editor().visibleRegion().isEmpty());
}

TEST_F(ControlTest, AScenarioWithoutLoopsSaysWhatToDo) {
  window_->document().start_from(quick_scenario());
  ASSERT_TRUE(wait_until([&] { return panel().list()->topLevelItemCount() == 0; }));
  EXPECT_TRUE(panel().list()->isHidden());
}

TEST_F(ControlTest, ARunWithoutControllersMayBePausedWhileAScenarioWithThemIsOpened) {
  window_->document().start_from(quick_scenario());
  ASSERT_TRUE(run_to(0.2));
  ASSERT_TRUE(window_->document().start_from(QString(kControlled)).ok());
  ASSERT_TRUE(wait_until([&] { return panel().findChild<QTreeWidget*>()->topLevelItemCount() > 0; }));
  EXPECT_TRUE(window_->session().live() != nullptr);
}

TEST_F(ControlTest, ScenariosWithMoreAndFewerControllersFollowEachOther) {
  const auto loops = [this] { return panel().findChild<QTreeWidget*>()->topLevelItemCount(); };
  ASSERT_TRUE(wait_until([&] { return loops() > 0; }));
  window_->document().start_from(quick_scenario());
  ASSERT_TRUE(wait_until([&] { return loops() == 0; }));
  // Written into the text, what is saved has none of them.
  ASSERT_TRUE(window_->document().set_text(QString(kControlled)).ok());
  ASSERT_TRUE(wait_until([&] { return loops() > 0; }));
  EXPECT_TRUE(window_->document().is_modified());
}

TEST_F(ControlTest, GainsActOnTheRunAtOnceAndCommentsStay) {
  ASSERT_TRUE(run_to(0.2));
  ParameterRow* frequency = panel().gains()->row("controller.0.frequency");
  ASSERT_NE(frequency, nullptr);
  EXPECT_EQ(panel().gains()->row("controller.0.slope"), nullptr) << "a PD has none";
  ParameterRow* rate = panel().gains()->row("controller.0.rate");
  ASSERT_NE(rate, nullptr);
  auto* edit = frequency->findChild<NumberEdit*>();
  edit->setFocus();
  edit->selectAll();
  QTest::keyClicks(edit, "0.7");
  QTest::keyClick(edit, Qt::Key_Return);
  ASSERT_TRUE(wait_until([&] { return live().scenario.controllers[0].frequency == 0.7; }));
  EXPECT_EQ(window_->document().scenario().controllers[0].frequency, 0.7);
  const QString text = window_->document().text();
  EXPECT_TRUE(text.contains("# The spacecraft is to turn.")) << text.toStdString();
  EXPECT_TRUE(text.contains("# rad (my choice)"));
  EXPECT_TRUE(
      text.contains("[[controller]]\nkind = \"attitude_pd\"\nattitude = [0.1, 0, 0]         # rad (my choice)\n"
                    "frequency = 0.7\n"))
      << text.toStdString();
  // What cannot change in a run says so.
  ASSERT_FALSE(window_->document().set_value(rate->parameter(), 50.0));
  ASSERT_TRUE(wait_until([&] { return rate->needs_restart(); }));
  EXPECT_FALSE(frequency->needs_restart());
  EXPECT_EQ(live().scenario.controllers[0].rate, 100);
}

// A change of a gain is recorded: the run can be continued from its recording.
TEST_F(ControlTest, ADisturbanceAtAClickIsRecordedMarkedAndContinued) {
  ASSERT_TRUE(run_to(0.3));
  panel().disturbances()->set_disturbance(DisturbedBody::target, false, 0, 200, 0.1);
  QTest::keyClick(window_.get(), Qt::Key_D, Qt::ControlModifier);
  ASSERT_TRUE(wait_until([&] { return live().scenario.disturbances.size() == 1; }));
  EXPECT_NEAR(live().scenario.disturbances[0].start, 0.3, 1e-9);
  EXPECT_TRUE(std::ranges::any_of(time_marks(live()), [](const TimeMark& mark) {
    return mark.kind == TimeMark::Kind::disturbance && mark.label.contains("200 N along x");
  }));
  const double before = last(live(), "target_vx");
  ASSERT_TRUE(go_on_to(0.36));
  EXPECT_NEAR(last(live(), "disturbance_on_target_force_x"), 200, 1e-6);
  ASSERT_TRUE(go_on_to(0.5));
  EXPECT_NEAR(last(live(), "target_vx") - before, 200 * 0.1 / 200, 0.03);  // the net may touch it
  // A change of the strategy does not take the disturbance away.
  ASSERT_FALSE(window_->document().set_value(*find_parameter("closing.duration"), 1.0));
  ASSERT_TRUE(wait_until([&] { return live().scenario.closing.duration == 1.0; }));
  EXPECT_EQ(live().scenario.disturbances.size(), 1u);
  window_->plots().show_figure("control_loops");
  screenshot("disturbance");

  session().runs().save(live().id, file("run.h5"));
  session().runs().finish_writing();
  const Recording recording(file("run.h5").toStdString());
  const CheckpointLog log(recording, 0.5, {});
  EXPECT_EQ(log.simulation_at(0.5).scenario().disturbances, live().scenario.disturbances);
  window_->open(file("run.h5"));
  ASSERT_TRUE(wait_until([&] { return session().current() != session().live(); }));
  EXPECT_EQ(session().current()->scenario.disturbances, live().scenario.disturbances);
}

TEST_F(ControlTest, ADisturbanceOfNothingIsRefusedInWords) {
  ASSERT_TRUE(run_to(0.1));
  panel().disturbances()->set_disturbance(DisturbedBody::spacecraft, true, 1, 0, 1);
  panel().disturbances()->button()->click();
  EXPECT_TRUE(window_->notice().contains("size"));
  EXPECT_TRUE(live().scenario.disturbances.empty());
}

TEST_F(ControlTest, ComparesWithTheRunWithoutControllers) {
  ASSERT_TRUE(run_to(0.4));
  const RunId with = live().id;
  QTest::keyClick(window_.get(), Qt::Key_L, Qt::ControlModifier);
  ASSERT_NE(live().id, with);
  ASSERT_TRUE(wait_until([&] { return live().end_time() >= 0.4 - 1e-6 && live().state == RunState::paused; }));
  EXPECT_EQ(session().runs().find(with)->name, "controlled, with loop");
  EXPECT_EQ(live().name, "controlled, without loop");
  EXPECT_EQ(last(live(), "controller_1_state"), static_cast<double>(LoopState::off));
  EXPECT_EQ(last(live(), "exerted_torque_x"), 0);
  EXPECT_NE(last(*session().runs().find(with), "exerted_torque_x"), 0);
  EXPECT_EQ(window_->plots().figure_name(), "control_loops");
  ASSERT_TRUE(wait_until([&] { return window_->plots().series().size() == 2; }));
  ASSERT_TRUE(wait_until([&] { return window_->plots().series()[0].times().size() == live().frame_count(); }));
  const Figure figure = control_loops_figure(window_->plots().series());
  std::vector<std::string> labels;
  for (const Curve& curve : figure.panels.front().curves) labels.push_back(curve.label);
  EXPECT_EQ(labels, (std::vector<std::string>{"controlled, without loop", "controlled, with loop"}));
  EXPECT_FALSE(window_->control_actions().compare_action()->isEnabled()) << "its controllers are off";
  screenshot("comparison");
}

TEST_F(ControlTest, EverythingIsReachedByKeys) {
  ASSERT_TRUE(run_to(0.1));
  QTest::keyClick(window_.get(), Qt::Key_5, Qt::AltModifier);
  EXPECT_EQ(window_->focusWidget(), panel().list());
  QTest::keyClick(panel().list(), Qt::Key_Down);
  EXPECT_NE(panel().gains()->row("controller.1.slope"), nullptr);
  bool reached = false;
  for (int i = 0; i < 60 && !reached; ++i) {
    QTest::keyClick(window_->focusWidget(), Qt::Key_Tab);
    reached = window_->focusWidget() == panel().disturbances()->button();
  }
  EXPECT_TRUE(reached);
}

}  // namespace
}  // namespace netpocket
