// Nothing is lost: questions before closing, runs and scenarios that a crash left behind, saving, exports.

#include <QAbstractButton>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QTest>
#include <QUndoStack>

#include "engine/recording/recording.h"
#include "gui/workbench/editor/message_bar.h"
#include "gui/workbench/editor/scenario_editor.h"
#include "gui/workbench/export/export_dialog.h"
#include "gui/workbench/export/export_tray.h"
#include "gui/workbench/lost_runs_bar.h"
#include "gui/workbench/run_file_actions.h"
#include "gui/workbench/runs_panel.h"
#include "gui/workbench/session/run_folder.h"
#include "gui/workbench/viewport/viewport.h"
#include "tests/gui/workbench/window_fixture.h"

namespace netpocket {
namespace {

TEST_F(WindowTest, AsksBeforeUnsavedChangesAreLost) {
  ASSERT_FALSE(window_->document().set_value(*find_parameter("closing.duration"), 3.0));
  answer_question(QMessageBox::Cancel);
  EXPECT_FALSE(window_->close());
  EXPECT_TRUE(window_->isVisible());
  answer_question(QMessageBox::Discard);
  EXPECT_TRUE(window_->close());
}

TEST_F(WindowTest, SavesBeforeItClosesWhenAskedTo) {
  write_file("mine.toml", "[closing]\nduration = 4\n");
  window_->open(file("mine.toml"));
  ASSERT_FALSE(window_->document().set_value(*find_parameter("closing.duration"), 3.0));
  answer_question(QMessageBox::Save);
  EXPECT_TRUE(window_->close());
  QFile saved(file("mine.toml"));
  ASSERT_TRUE(saved.open(QIODevice::ReadOnly));
  EXPECT_EQ(saved.readAll(), "[closing]\nduration = 3\n");
}

TEST_F(WindowTest, OpeningAnotherScenarioAsksFirst) {
  write_file("other.toml", "name = \"other\"\n");
  ASSERT_FALSE(window_->document().set_value(*find_parameter("closing.duration"), 3.0));
  answer_question(QMessageBox::Cancel);
  window_->open(file("other.toml"));
  EXPECT_EQ(window_->document().scenario().name, "quick");
  answer_question(QMessageBox::Discard);
  window_->open(file("other.toml"));
  EXPECT_EQ(window_->document().scenario().name, "other");
}

TEST_F(WindowTest, AsksBeforeUnsavedRunsAreLost) {
  window_->apply_preferences({.ask_about_runs = true});
  ASSERT_TRUE(run_to(0.2));
  answer_question(QMessageBox::Cancel);
  EXPECT_FALSE(window_->close());
  answer_question(QMessageBox::Discard);
  EXPECT_TRUE(window_->close());
}

TEST_F(WindowTest, AsksBeforeAnUnsavedRunIsRemoved) {
  window_->apply_preferences({.ask_about_runs = true});
  ASSERT_TRUE(run_to(0.1));
  auto& runs = window_->session().runs();
  auto* list = window_->findChild<RunsPanel*>()->list();
  window_->findChild<QDockWidget*>("runs")->raise();
  list->setFocus();
  answer_question(QMessageBox::Cancel);
  QTest::keyClick(list, Qt::Key_Delete);
  EXPECT_EQ(runs.ids().size(), 1u);
  window_->activateWindow();
  list->setFocus();
  ASSERT_TRUE(wait_until([&] { return list->hasFocus(); }));
  answer_question(QMessageBox::Discard);
  QTest::keyClick(list, Qt::Key_Delete);
  EXPECT_TRUE(runs.ids().empty());
}

TEST_F(WindowTest, SavedRunsAreNotAskedAbout) {
  window_->apply_preferences({.ask_about_runs = true});
  ASSERT_TRUE(run_to(0.2));
  EXPECT_EQ(window_->session().runs().unsaved().size(), 1u);
  QDir(folder_.path()).mkdir("saved");
  window_->run_files().save_unsaved_to(file("saved"));
  ASSERT_TRUE(wait_until([&] { return window_->session().runs().unsaved().empty(); }));
  EXPECT_EQ(QDir(file("saved")).entryList({"*.h5"}), QStringList{"quick.h5"});
  EXPECT_EQ(Recording(file("saved/quick.h5").toStdString()).frame_count(), window_->session().current()->frame_count());
  EXPECT_TRUE(window_->close());
}

TEST_F(WindowTest, EveryRunGetsAFileOfItsOwn) {
  ASSERT_TRUE(run_to(0.1));
  ASSERT_TRUE(run_to(0.1));
  write_file("quick.h5", "something else");
  window_->run_files().save_unsaved_to(folder_.path());
  ASSERT_TRUE(wait_until([&] { return window_->session().runs().unsaved().empty(); }));
  EXPECT_EQ(QDir(folder_.path()).entryList({"*.h5"}).size(), 3);
  EXPECT_EQ(QFile(file("quick.h5")).size(), 14);
}

TEST_F(WindowTest, RunsOfACrashedSessionAreOffered) {
  ASSERT_TRUE(run_to(0.3));
  const netpocket::Run& run = *window_->session().current();
  const std::size_t frames = run.frame_count();
  window_->session().runs().flush(run.id, [](const QString&) {});
  window_->session().runs().finish_writing();
  // What a crash leaves: the folder with its recording, and nobody who holds its lock.
  const QString lost = file("recovery/runs/runs-lost");
  ASSERT_TRUE(QDir().mkpath(lost));
  ASSERT_TRUE(QFile::copy(QString::fromStdString(run.file->path()), lost + "/run0.h5"));
  reopen();
  EXPECT_TRUE(window_->lost_runs().isVisible());
  screenshot("lost_runs");
  window_->lost_runs().recover();
  EXPECT_FALSE(window_->lost_runs().isVisible());
  ASSERT_TRUE(wait_until([&] { return window_->session().current() != nullptr; }));
  EXPECT_EQ(window_->session().current()->frame_count(), frames);
  EXPECT_EQ(window_->session().runs().unsaved().size(), 1u);
  EXPECT_FALSE(QDir(lost).exists());
  window_.reset();
  // Everything temporary went with the session.
  EXPECT_TRUE(QDir(file("recovery/runs")).entryList(QDir::Dirs | QDir::NoDotAndDotDot).isEmpty());
}

TEST(RunFolder, OfALivingSessionIsNotLost) {
  QTemporaryDir parent;
  {
    const RunFolder folder(parent.path());
    QFile recording(folder.path() + "/run0.h5");
    ASSERT_TRUE(recording.open(QIODevice::WriteOnly));
    EXPECT_TRUE(find_lost_runs(parent.path()).empty());
  }
  EXPECT_TRUE(QDir(parent.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot).isEmpty());
}

TEST(RunFolder, WithoutAPlaceToWriteTakesTheTemporaryFolder) {
  const RunFolder folder("/proc/nowhere");
  EXPECT_TRUE(QDir(folder.path()).exists());
}

TEST_F(WindowTest, ScenarioOfACrashedSessionIsOffered) {
  ASSERT_FALSE(window_->document().set_value(*find_parameter("closing.duration"), 3.0));
  window_->document().autosave();
  // A copy without a lock is what a crash leaves.
  const QDir recovery(file("recovery"));
  const QStringList files = recovery.entryList({"*.recovery"});
  ASSERT_EQ(files.size(), 1);
  ASSERT_TRUE(QFile::copy(recovery.filePath(files.front()), recovery.filePath("crashed.recovery")));
  window_.reset();
  window_ = std::make_unique<MainWindow>(options_);
  window_->show();
  auto* bar = window_->editor().recovery_bar();
  EXPECT_FALSE(bar->isHidden());
  for (auto* button : bar->findChildren<QAbstractButton*>()) {
    if (button->text() == "Recover") button->click();
  }
  EXPECT_EQ(window_->document().scenario().closing.duration, 3);
  EXPECT_TRUE(window_->isWindowModified());
}

TEST_F(WindowTest, FramesARecordingThatIsOpenedAtTheStart) {
  Scenario scenario = quick_scenario();
  scenario.target.position = {0, 60, 0};
  window_->document().start_from(scenario);
  ASSERT_TRUE(run_to(0.1));
  auto& saving = window_->session().runs();
  saving.save(window_->session().current()->id, file("far.h5"));
  ASSERT_TRUE(wait_until([&] { return saving.unsaved().empty(); }));
  reopen();
  ASSERT_TRUE(wait_until([&] { return window_->viewport().state().complete(); })) << "the scenario's";
  const auto target_in_sight = [&] {
    const Viewport& view = window_->viewport();
    if (window_->session().current() == nullptr || !view.state().complete()) return false;
    const auto& bodies = view.state().structure->bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i].role != BodyRole::target) continue;
      const auto point = OrbitCamera(view.view()).project(view.state().snapshot->bodies[i].position, view.size());
      return point && view.rect().contains(point->position.toPoint());
    }
    return false;
  };
  window_->open(file("far.h5"));
  EXPECT_TRUE(wait_until(target_in_sight, 20));
  screenshot("framed_recording");
}

TEST_F(WindowTest, ExportsFromTheCameraOfTheView) {
  ASSERT_TRUE(run_to(0.1));
  window_->viewport().set_preset(CameraPreset::mouth);
  ShownView shown{window_->viewport().view(), {}, 0.1};
  shown.display.color_by = ColorBy::tension;
  shown.display.contact_arrows = true;
  ExportDialog dialog(folder_.path(), "quick", shown, nullptr);
  dialog.choose(ExportKind::sheet);
  dialog.set_target(file("sheet.png"));
  EXPECT_TRUE(dialog.uses_view());
  const QStringList arguments = dialog.arguments("run.h5", "view.toml");
  EXPECT_FALSE(arguments.contains("--camera"));
  EXPECT_EQ(arguments[arguments.indexOf("--view") + 1], "view.toml");
  EXPECT_EQ(arguments[arguments.indexOf("--color-by") + 1], "tension");
  EXPECT_TRUE(arguments.contains("--arrows"));
  window_->run_files().export_as(dialog);
  ASSERT_TRUE(wait_until([&] { return QFile::exists(file("sheet.png")) || !window_->notice().isEmpty(); }, 60));
  EXPECT_EQ(window_->notice(), QString());
}

TEST_F(WindowTest, AsksBeforeAnExportReplacesAnything) {
  ExportDialog dialog(folder_.path(), "quick", {}, window_.get());
  dialog.choose(ExportKind::report);
  write_file("there.html", "mine");
  dialog.set_target(file("there.html"));
  answer_question(QMessageBox::Cancel);
  dialog.accept();
  EXPECT_NE(dialog.result(), QDialog::Accepted);
  answer_question(QMessageBox::Yes);
  dialog.accept();
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
  // An empty folder holds nothing to replace.
  dialog.choose(ExportKind::csv);
  QDir().mkpath(file("empty"));
  dialog.set_target(file("empty"));
  dialog.setResult(QDialog::Rejected);
  dialog.accept();
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
  // What is exported next goes where the last one was going to.
  dialog.set_target(file("empty/quick_csv"));
  dialog.choose(ExportKind::video);
  EXPECT_EQ(dialog.target(), file("empty/quick.mp4"));
}

TEST_F(WindowTest, AsksBeforeClosingCancelsAnExport) {
  ASSERT_TRUE(run_to(0.1));
  window_->run_files().export_run(
      [this](const QString& recording) {
        return QStringList{"render", recording, "-o", file("frames"), "--fps", "50", "--size", "3840x2160"};
      },
      "pictures", file("frames"));
  ASSERT_TRUE(wait_until([&] { return window_->exports().is_busy(); }));
  answer_question(QMessageBox::Cancel);
  EXPECT_FALSE(window_->close());
  answer_question(QMessageBox::Discard);
  EXPECT_TRUE(window_->close());
}

TEST_F(WindowTest, ExportsAReport) {
  ASSERT_TRUE(run_to(0.1));
  ExportDialog dialog(folder_.path(), "quick", {}, nullptr);
  dialog.choose(ExportKind::report);
  EXPECT_FALSE(dialog.uses_view());
  dialog.set_target(file("report.html"));
  window_->run_files().export_as(dialog);
  ASSERT_TRUE(wait_until([&] { return window_->exports().is_busy(); }));
  ASSERT_TRUE(wait_until([&] { return !window_->exports().is_busy(); }, 120));
  EXPECT_EQ(window_->notice(), QString());
  EXPECT_TRUE(QFile::exists(file("report.html")));
}

}  // namespace
}  // namespace netpocket
