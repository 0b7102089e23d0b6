#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QTabWidget>
#include <QTest>
#include <QUndoStack>
#include <algorithm>

#include "engine/state/pocket_groups.h"
#include "gui/workbench/editor/message_bar.h"
#include "gui/workbench/editor/scenario_editor.h"
#include "gui/workbench/editor/text_page.h"
#include "gui/workbench/editor/toml_edit_view.h"
#include "gui/workbench/export/export_tray.h"
#include "gui/workbench/file_actions.h"
#include "gui/workbench/panels/findings_panel.h"
#include "gui/workbench/panels/plots_panel.h"
#include "gui/workbench/panels/tones.h"
#include "gui/workbench/run_actions.h"
#include "gui/workbench/run_file_actions.h"
#include "gui/workbench/run_status_bar.h"
#include "gui/workbench/simulation/pocket_preview.h"
#include "gui/workbench/timeline/timeline_bar.h"
#include "gui/workbench/viewport/viewport.h"
#include "tests/gui/workbench/window_fixture.h"

namespace netpocket {
namespace {

const Parameter& parameter(const char* key) { return *find_parameter(key); }

TEST_F(WindowTest, ShowsThePocketAtOnce) {
  // Not blank: rods, net and target are there. The very first picture may come before the pocket is built.
  const auto colors = [&] {
    const QImage picture = window_->viewport().picture();
    QSet<QRgb> found;
    for (int x = 0; x < picture.width(); x += 7) {
      for (int y = 0; y < picture.height(); y += 7) found.insert(picture.pixel(x, y));
    }
    return found.size();
  };
  ASSERT_TRUE(wait_until([&] { return colors() > 20; }));
  screenshot("empty");
  EXPECT_GT(window_->viewport().picture().width(), 200);
}

TEST_F(WindowTest, RunsPausesAndGoesBack) {
  ASSERT_TRUE(run_to(0.5));
  auto& session = window_->session();
  EXPECT_EQ(session.current(), session.live());
  EXPECT_NEAR(session.current()->end_time(), 0.5, 1e-6);
  screenshot("running");
  window_->timeline().go_to(0.2);
  EXPECT_NEAR(session.current()->series.times()[session.shown_index()], 0.2, 0.011);
  ASSERT_TRUE(wait_for_picture());
  EXPECT_NEAR(window_->viewport().state().snapshot->time, 0.2, 0.011);
}

TEST_F(WindowTest, SpaceRunsAndPauses) {
  QTest::keyClick(&window_->viewport(), Qt::Key_Space);
  auto& session = window_->session();
  ASSERT_TRUE(wait_until([&] { return session.is_running() && session.live()->frame_count() > 3; }));
  QTest::keyClick(&window_->viewport(), Qt::Key_Space);
  ASSERT_TRUE(wait_until([&] { return !session.is_running(); }));
  EXPECT_EQ(session.live()->state, RunState::paused);
}

TEST_F(WindowTest, FinishesAndJudgesTheRun) {
  window_->run_actions().restart();
  auto& session = window_->session();
  ASSERT_TRUE(wait_until([&] { return session.live() && session.live()->state == RunState::ended; }, 120));
  EXPECT_NEAR(session.live()->end_time(), 2, 1e-6);
  ASSERT_TRUE(wait_until([&] { return !window_->findings().findings().empty(); }));
  EXPECT_EQ(window_->plots().series().size(), 1u);
  EXPECT_EQ(window_->plots().series().front().times().size(), session.live()->frame_count());
  EXPECT_NEAR(phase_end(window_->plots().series().front().phases, kClosing), 0.8, 1e-9);
  screenshot("finished");
}

TEST_F(WindowTest, EditRedrawsThePocketAndCanBeUndone) {
  ASSERT_TRUE(wait_until([&] { return window_->viewport().state().structure != nullptr; }));
  auto& document = window_->document();
  const std::size_t before = preview_pocket(document.scenario()).structure->elements.size();
  ASSERT_FALSE(document.set_value(parameter("pocket.rod_count"), std::int64_t{6}));
  ASSERT_TRUE(wait_until([&] { return window_->viewport().state().structure->nodes(kRodTips).size() == 6; }));
  EXPECT_TRUE(window_->isWindowModified());
  document.undo_stack()->undo();
  ASSERT_TRUE(wait_until([&] { return window_->viewport().state().structure->nodes(kRodTips).size() == 8; }));
  EXPECT_EQ(window_->viewport().state().structure->elements.size(), before);
}

TEST_F(WindowTest, StrategyEditActsOnTheRun) {
  ASSERT_TRUE(run_to(0.2));
  ASSERT_FALSE(window_->document().set_value(parameter("closing.duration"), 1.5));
  auto& session = window_->session();
  ASSERT_TRUE(wait_until([&] { return session.live()->scenario.closing.duration == 1.5; }));
  EXPECT_NEAR(phase_end(session.live()->series.phases, kClosing), 1.5, 1e-9);
  EXPECT_NEAR(phase_end(window_->plots().series().front().phases, kClosing), 1.5, 1e-9);
}

TEST_F(WindowTest, BranchSharesThePastAndKeepsTheOriginal) {
  ASSERT_TRUE(run_to(0.6));
  auto& session = window_->session();
  const RunId original = session.current()->id;
  const std::size_t frames = session.current()->frame_count();
  window_->timeline().go_to(0.3);
  const std::size_t shared = session.shown_index() + 1;
  ASSERT_FALSE(window_->document().set_value(parameter("closing.duration"), 3.0));
  window_->run_actions().branch();
  ASSERT_NE(session.current()->id, original);
  EXPECT_EQ(session.current()->frame_count(), shared);
  session.resume({.until = 0.6});
  ASSERT_TRUE(wait_until([&] { return session.current()->end_time() >= 0.6 - 1e-6; }));
  EXPECT_EQ(session.runs().find(original)->frame_count(), frames);
  const auto& length = session.current()->series.channel(Channel::commanded_length);
  const auto& before = session.runs().find(original)->series.channel(Channel::commanded_length);
  EXPECT_EQ(length[shared - 1], before[shared - 1]);
  EXPECT_GT(length.back(), before.back() + 1);  // slower closing: the mouth is wider by metres
  screenshot("branch");
}

TEST_F(WindowTest, DivergenceNamesThePlaceAndKeepsTheFrames) {
  Scenario scenario = quick_scenario();
  scenario.solver.time_step = 4e-3;  // ten times what its elements allow
  window_->document().start_from(scenario);
  window_->run_actions().restart();
  auto& session = window_->session();
  ASSERT_TRUE(wait_until([&] { return session.live() && session.live()->status.reason == RunReason::diverged; }));
  const QString notice = window_->notice();
  const auto& threads = session.live()->structure->threads;
  EXPECT_TRUE(std::ranges::any_of(threads, [&](const std::string& name) {
    return notice.contains(QString::fromStdString(name));
  })) << notice.toStdString();
  EXPECT_TRUE(notice.contains("solver.time_step")) << notice.toStdString();
  EXPECT_GT(session.live()->frame_count(), 0u);
  const QLabel& state = *window_->findChild<RunStatusBar*>()->state_field();
  EXPECT_EQ(state.text(), "Diverged");
  EXPECT_EQ(state.palette().color(QPalette::WindowText), tone_colour(Tone::bad, window_->palette()));
  screenshot("diverged");
  // What was wrong can be put right, and a new run made; the diverged one stays.
  ASSERT_FALSE(window_->document().set_value(parameter("solver.time_step"), 0.0));
  ASSERT_TRUE(run_to(0.1));
  EXPECT_EQ(session.runs().ids().size(), 2u);
}

TEST_F(WindowTest, ADraftSaysSo) {
  const auto draft_fields = [&] {
    const auto labels = window_->findChild<RunStatusBar*>()->findChildren<QLabel*>();
    return std::ranges::count_if(
        labels, [](const QLabel* label) { return label->isVisible() && label->text().startsWith("draft: capture "); });
  };
  ASSERT_TRUE(run_to(0.05));
  EXPECT_EQ(draft_fields(), 0);
  Scenario scenario = quick_scenario();
  scenario.solver.fidelity = Fidelity::draft;
  window_->document().start_from(scenario);
  window_->run_actions().restart();
  ASSERT_TRUE(wait_until([&] { return draft_fields() == 1; }));
  screenshot("draft");
}

TEST_F(WindowTest, StrategyThatNeedsARestartSaysSo) {
  ASSERT_TRUE(run_to(0.2));
  ASSERT_FALSE(window_->document().set_value(parameter("net.diameter"), 0.005));
  EXPECT_EQ(window_->editor().keys_that_need_restart(), QStringList{"net.diameter"});
  EXPECT_FALSE(window_->editor().restart_bar()->isHidden());
  screenshot("needs_restart");
  // Also after the run has changed its state.
  window_->session().resume({.until = 0.3});
  ASSERT_TRUE(wait_until([&] { return window_->session().live()->end_time() >= 0.3 - 1e-6; }));
  EXPECT_EQ(window_->editor().keys_that_need_restart(), QStringList{"net.diameter"});
  window_->editor().restart_requested();
  EXPECT_TRUE(wait_until([&] { return window_->session().runs().ids().size() == 2; }));
  EXPECT_TRUE(window_->editor().keys_that_need_restart().isEmpty());
}

TEST_F(WindowTest, FrictionTowingAndPressureActOnTheRunTheyAreEditedIn) {
  ASSERT_TRUE(run_to(0.2));
  const std::vector<std::pair<const char*, double>> edits = {
      {"contact.friction", 0.7}, {"towing.start", 1.5}, {"rods.pressure", 5e4}, {"output.end_time", 3.0}};
  for (const auto& edit : edits) {
    const Parameter& changed = parameter(edit.first);
    ASSERT_FALSE(window_->document().set_value(changed, edit.second));
    const auto acts = [&] { return std::get<double>(changed.get(window_->session().live()->scenario)) == edit.second; };
    ASSERT_TRUE(wait_until(acts)) << edit.first;
  }
  EXPECT_TRUE(window_->editor().keys_that_need_restart().isEmpty());
  // Each change is a mark on the timeline.
  const auto& notes = window_->session().live()->notes;
  EXPECT_EQ(std::ranges::count(notes, TimeMark::Kind::strategy, &TimeMark::kind), static_cast<long>(edits.size()));
}

TEST_F(WindowTest, TakesADroppedRecording) {
  ASSERT_TRUE(run_to(0.1));
  window_->session().runs().save(window_->session().current()->id, file("dropped.h5"));
  ASSERT_TRUE(wait_until([&] { return window_->session().runs().unsaved().empty(); }));
  drop({file("dropped.h5")});
  ASSERT_TRUE(wait_until([&] { return window_->session().current()->name == "dropped"; }));
  EXPECT_EQ(window_->session().current()->state, RunState::recorded);
  // Several at once, to be compared.
  drop({file("dropped.h5"), file("dropped.h5")});
  EXPECT_TRUE(wait_until([&] { return window_->session().runs().ids().size() == 4; }));
}

TEST_F(WindowTest, SavedCamerasComeBackInTheNextSession) {
  ASSERT_TRUE(wait_until([&] { return window_->viewport().state().structure != nullptr; }));
  window_->viewport().set_preset(CameraPreset::mouth);
  const CameraView view = window_->viewport().view();
  QTest::keyClick(&window_->viewport(), Qt::Key_6, Qt::ControlModifier | Qt::ShiftModifier);
  reopen();
  window_->viewport().set_preset(CameraPreset::side);
  QTest::keyClick(&window_->viewport(), Qt::Key_6);
  EXPECT_LT((window_->viewport().view().position - view.position).norm(), 1e-12);
  EXPECT_EQ(window_->viewport().view().half_height, view.half_height);
}

TEST_F(WindowTest, CameraBoxNamesWhereOneLooksFrom) {
  ASSERT_TRUE(wait_for_picture());
  const auto boxes = window_->findChildren<QComboBox*>();
  const auto box = std::ranges::find(boxes, QString("Camera"), &QComboBox::accessibleName);
  ASSERT_NE(box, boxes.end());
  auto& viewport = window_->viewport();
  EXPECT_EQ((*box)->currentIndex(), 0);
  QTest::keyClick(&viewport, Qt::Key_2);
  EXPECT_EQ((*box)->currentIndex(), 1);
  QTest::keyClick(&viewport, Qt::Key_Plus);
  QTest::keyClick(&viewport, Qt::Key_F);
  EXPECT_EQ((*box)->currentIndex(), 1);
  QTest::keyClick(&viewport, Qt::Key_Left);
  EXPECT_EQ((*box)->currentIndex(), -1);
  screenshot("free_camera");
  QTest::keyClick(&viewport, Qt::Key_2);
  EXPECT_EQ((*box)->currentIndex(), 1);
}

TEST_F(WindowTest, ClosesWhileRunning) {
  window_->document().start_from(Scenario{});
  window_->run_actions().restart();
  ASSERT_TRUE(wait_until([&] { return window_->session().is_running(); }));
  window_->close();
  EXPECT_FALSE(window_->isVisible());
  window_.reset();
}

TEST_F(WindowTest, BrokenFilesAreRefusedInOneSentence) {
  write_file("broken.toml", "[pocket\nrod_count = ");
  window_->open(file("broken.toml"));
  EXPECT_TRUE(window_->notice().contains("broken.toml")) << window_->notice().toStdString();
  EXPECT_EQ(window_->document().scenario().name, "quick");
  screenshot("broken_file");
  write_file("broken.h5", "this is not HDF5");
  window_->open(file("broken.h5"));
  ASSERT_TRUE(wait_until([&] { return window_->notice().contains("broken.h5"); }));
  window_->open(file("missing.h5"));
  ASSERT_TRUE(wait_until([&] { return window_->notice().contains("missing.h5"); }));
}

TEST_F(WindowTest, WhatIsWrongWithTheScenarioIsNotSaidAnyLongerThanItIs) {
  auto* text = window_->editor().text_page();
  const QString sound = text->view()->toPlainText();
  window_->editor().tabs()->setCurrentWidget(text);
  text->view()->setPlainText(sound + "nonsense");
  window_->run_actions().restart();
  EXPECT_FALSE(window_->notice().isEmpty());
  text->view()->setPlainText(sound);
  EXPECT_TRUE(wait_until([&] { return window_->notice().isEmpty(); })) << window_->notice().toStdString();
  // Numbers that do not go together.
  ASSERT_FALSE(window_->document().set_value(parameter("closing.closed_length"), 100.0));
  window_->run_actions().restart();
  EXPECT_FALSE(window_->notice().isEmpty());
  window_->document().undo_stack()->undo();
  EXPECT_TRUE(window_->notice().isEmpty()) << window_->notice().toStdString();
}

TEST_F(WindowTest, TakesADroppedScenario) {
  write_file("dropped.toml", "name = \"dropped\"\n[pocket]\nrod_count = 6\n");
  drop({file("dropped.toml")});
  ASSERT_TRUE(wait_until([&] { return window_->document().scenario().name == "dropped"; }));
  EXPECT_EQ(window_->document().scenario().pocket.rod_count, 6);
  EXPECT_TRUE(window_->file_actions().recent().front().endsWith("dropped.toml"));
}

TEST_F(WindowTest, ExportsFramesOfARunThatIsStillThere) {
  ASSERT_TRUE(run_to(0.2));
  const QString frames = file("frames");
  window_->run_files().export_run(
      [&](const QString& recording) {
        return QStringList{"render", recording, "-o", frames, "--fps", "10", "--size", "160x120"};
      },
      "Pictures", frames);
  ASSERT_TRUE(wait_until([&] { return window_->exports().is_busy(); }));
  ASSERT_TRUE(wait_until([&] { return !window_->exports().is_busy(); }, 60));
  EXPECT_EQ(window_->notice(), QString());
  EXPECT_EQ(QDir(frames).entryList({"*.png"}).size(), 3);
}

TEST_F(WindowTest, FailedExportSaysWhy) {
  ASSERT_TRUE(run_to(0.1));
  window_->run_files().export_run(
      [&](const QString& recording) {
        return QStringList{"render", recording, "-o", "/proc/no"};
      },
      "Pictures", "/proc/no");
  ASSERT_TRUE(wait_until([&] { return window_->notice().contains("/proc/no"); }, 60))
      << window_->notice().toStdString();
}

TEST_F(WindowTest, PicksARodAndTellsItsName) {
  ASSERT_TRUE(wait_for_picture());
  auto& viewport = window_->viewport();
  const auto& state = viewport.state();
  const auto tip = OrbitCamera(state.camera)
                       .project(state.snapshot->positions.col(state.structure->nodes(kRodTips)[0]), viewport.size());
  QTest::mouseClick(&viewport, Qt::LeftButton, {}, tip->position.toPoint());
  ASSERT_TRUE(viewport.selection());
  EXPECT_EQ(viewport.selection()->kind, PickKind::node);
  screenshot("picked");
  QTest::keyClick(&viewport, Qt::Key_Escape);
  EXPECT_FALSE(viewport.selection());
}

TEST_F(WindowTest, PlotsWhatWasPickedOverTheRun) {
  ASSERT_TRUE(run_to(0.3));
  auto& viewport = window_->viewport();
  const Pick target{PickKind::body, 1, 0, {0, 0, 0}};
  viewport.select(target);
  emit viewport.plot_requested(target);
  ASSERT_TRUE(wait_until([&] { return window_->plots().figure_name() == "picked"; }));
  ASSERT_TRUE(wait_until([&] { return window_->plots().chart()->figure().panels.size() == 2; }));
  const auto& height = window_->plots().chart()->figure().panels[0].curves[1];
  EXPECT_EQ(height.x.size(), window_->session().current()->frame_count());
  EXPECT_NEAR(height.y.front(), 7.5, 1e-9);  // scenarios/case1.toml: the target's start
  screenshot("picked_plot");
  // It grows with the run, and another run of the same pocket takes its place.
  window_->session().resume({.until = 0.4});
  const auto plotted = [&] { return window_->plots().chart()->figure().panels[0].curves[1].x; };
  ASSERT_TRUE(wait_until([&] { return plotted().back() > 0.39; }));
  ASSERT_TRUE(run_to(0.1));
  ASSERT_TRUE(wait_until([&] { return plotted().size() == window_->session().current()->frame_count(); }));
  EXPECT_NEAR(plotted().back(), 0.1, 1e-6);
}

TEST_F(WindowTest, SpacePressesTheButtonThatHasTheFocus) {
  auto* tick = window_->findChild<QCheckBox*>();
  ASSERT_TRUE(tick);
  tick->setFocus();
  const bool before = tick->isChecked();
  QTest::keyClick(tick, Qt::Key_Space);
  EXPECT_NE(tick->isChecked(), before);
  EXPECT_EQ(window_->session().live(), nullptr) << "nothing was started";
}

TEST_F(WindowTest, EditingAfterARunShowsThePreviewAndSaysSo) {
  ASSERT_TRUE(run_to(0.1));
  ASSERT_FALSE(window_->document().set_value(parameter("pocket.rod_count"), std::int64_t{6}));
  ASSERT_TRUE(wait_until([&] { return window_->viewport().state().structure->nodes(kRodTips).size() == 6; }));
  screenshot("preview_after_run");
  window_->timeline().go_to(0.05);
  EXPECT_EQ(window_->viewport().state().structure->nodes(kRodTips).size(), 8u);
}

// A preview is built in the background: asked for before, it must not take the place of what is chosen meanwhile.
TEST_F(WindowTest, APreviewThatComesLateIsNotShown) {
  ASSERT_TRUE(run_to(0.1));
  ASSERT_FALSE(window_->document().set_value(parameter("pocket.rod_count"), std::int64_t{6}));
  window_->timeline().go_to(0.05);
  QTest::qWait(500);
  EXPECT_EQ(window_->viewport().state().structure->nodes(kRodTips).size(), 8u);
  ASSERT_FALSE(window_->document().set_value(parameter("pocket.rod_count"), std::int64_t{10}));
  EXPECT_TRUE(wait_until([&] { return window_->viewport().state().structure->nodes(kRodTips).size() == 10; }));
}

TEST_F(WindowTest, ShowsTrailsAndTheInitialShape) {
  ASSERT_TRUE(run_to(0.4));
  EXPECT_EQ(window_->viewport().state().history, nullptr);
  QTest::keyClick(&window_->viewport(), Qt::Key_R);
  QTest::keyClick(&window_->viewport(), Qt::Key_I);
  QTest::keyClick(&window_->viewport(), Qt::Key_A);
  const auto history = window_->viewport().state().history;
  ASSERT_TRUE(history);
  ASSERT_TRUE(history->initial);
  EXPECT_EQ(history->initial->time, 0);
  ASSERT_EQ(history->paths.size(), 2u);  // spacecraft and target
  EXPECT_EQ(history->paths[0].times.size(), window_->session().current()->frame_count());
  EXPECT_TRUE(wait_for_picture());
  screenshot("trails");
  // A preview of another pocket has no past.
  ASSERT_FALSE(window_->document().set_value(parameter("pocket.rod_count"), std::int64_t{6}));
  ASSERT_TRUE(wait_until([&] { return window_->viewport().state().structure->nodes(kRodTips).size() == 6; }));
  EXPECT_EQ(window_->viewport().state().history, nullptr);
}

TEST_F(WindowTest, FollowsADarkDesktop) {
  const QPalette light = QApplication::palette();
  QPalette dark(QColor(45, 48, 54), QColor(38, 41, 46));
  dark.setColor(QPalette::Base, QColor(30, 32, 36));
  QApplication::setPalette(dark);
  EXPECT_TRUE(wait_until([&] { return window_->viewport().options().background == Background::space; }));
  EXPECT_TRUE(run_to(0.4));
  // Bars that were hidden when it turned dark.
  ASSERT_FALSE(window_->document().set_value(parameter("net.diameter"), 0.005));
  window_->show_notice("A notice.");
  for (const auto* bar : window_->findChildren<MessageBar*>()) {
    EXPECT_LT(bar->palette().color(QPalette::Window).lightness(), 128) << bar->text().toStdString();
    EXPECT_GT(bar->palette().color(QPalette::WindowText).lightness(), 128) << bar->text().toStdString();
  }
  screenshot("dark");
  QApplication::setPalette(light);
  EXPECT_TRUE(wait_until([&] { return window_->viewport().options().background == Background::white; }));
  for (const auto* bar : window_->findChildren<MessageBar*>()) {
    EXPECT_GT(bar->palette().color(QPalette::Window).lightness(), 128) << bar->text().toStdString();
    EXPECT_LT(bar->palette().color(QPalette::WindowText).lightness(), 128) << bar->text().toStdString();
  }
}

TEST_F(WindowTest, AnyReasonableSizeWorks) {
  for (const QSize size : {QSize(1280, 800), QSize(1920, 1080), QSize(700, 480)}) {
    window_->resize(size);
    EXPECT_TRUE(wait_for_picture());
    screenshot(QString("size_%1").arg(size.width()));
  }
}

TEST_F(WindowTest, RemembersItsLayout) {
  window_->resize(1000, 700);
  window_->close();
  window_ = std::make_unique<MainWindow>(options_);
  EXPECT_TRUE(window_->settings().contains("window/layout"));
}

}  // namespace
}  // namespace netpocket
