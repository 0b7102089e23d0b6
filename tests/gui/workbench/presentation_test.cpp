// Presenter mode: what an audience sees, and that the window is as before afterwards.

#include "gui/workbench/presentation/presentation.h"

#include <QApplication>
#include <QDockWidget>
#include <QMenuBar>
#include <QStatusBar>
#include <QTest>
#include <QToolBar>

#include "gui/workbench/editor/scenario_editor.h"
#include "gui/workbench/presentation/headline.h"
#include "gui/workbench/run_actions.h"
#include "gui/workbench/start/start_page.h"
#include "gui/workbench/timeline/timeline_bar.h"
#include "gui/workbench/view_actions.h"
#include "gui/workbench/viewport/viewport.h"
#include "tests/gui/workbench/window_fixture.h"

namespace netpocket {
namespace {

// Where everything is and how large its letters are.
QStringList arrangement(const MainWindow& window) {
  QStringList lines{QString("%1 x %2").arg(window.width()).arg(window.height())};
  const auto note = [&](const QString& name, const QWidget* widget) {
    const QRect place(widget->mapTo(&window, QPoint()), widget->size());
    lines << QString("%1 %2 %3,%4 %5x%6 font %7")
                 .arg(name)
                 .arg(widget->isVisible())
                 .arg(place.x())
                 .arg(place.y())
                 .arg(place.width())
                 .arg(place.height())
                 .arg(widget->font().pointSizeF());
  };
  for (const auto* dock : window.findChildren<QDockWidget*>()) note(dock->objectName(), dock);
  lines.sort();
  note("menus", window.menuBar());
  note("toolbar", window.findChild<QToolBar*>());
  note("status", window.statusBar());
  note("center", window.centralWidget());
  return lines;
}

class PresentationTest : public WindowTest {
 protected:
  Presentation& mode() const { return window_->presentation(); }
};

TEST_F(PresentationTest, EverythingIsAsBeforeAfterwards) {
  window_->resize(1000, 640);
  auto* runs = window_->findChild<QDockWidget*>("runs");
  runs->raise();
  window_->findChild<QDockWidget*>("plots")->hide();
  window_->editor().setFocus();
  QTest::qWait(50);
  const QStringList before = arrangement(*window_);
  const QByteArray layout = window_->saveState();
  const SceneOptions options = window_->view_actions().options();
  const QWidget* focus = QApplication::focusWidget();

  QTest::keyClick(window_.get(), Qt::Key_F5);
  ASSERT_TRUE(mode().is_on());
  QTest::qWait(50);
  EXPECT_NE(arrangement(*window_), before);
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
  EXPECT_FALSE(mode().is_on());
  EXPECT_TRUE(wait_until([&] { return arrangement(*window_) == before; }, 5))
      << before.join("\n").toStdString() << "\nbut now\n"
      << arrangement(*window_).join("\n").toStdString();
  EXPECT_EQ(window_->saveState(), layout);
  EXPECT_EQ(window_->view_actions().options().annotation_scale, options.annotation_scale);
  EXPECT_EQ(QApplication::focusWidget(), focus);
  EXPECT_FALSE(window_->isFullScreen());
}

TEST_F(PresentationTest, ShowsTheViewAndTheNumbersInLargeType) {
  ASSERT_TRUE(run_to(0.6));
  const double usual = window_->timeline().font().pointSizeF();
  mode().set_on(true);
  ASSERT_TRUE(wait_until([&] { return window_->headline().isVisible(); }));
  for (const auto* dock : window_->findChildren<QDockWidget*>()) EXPECT_FALSE(dock->isVisible());
  for (const auto* bar : window_->findChildren<QToolBar*>()) EXPECT_FALSE(bar->isVisible());
  EXPECT_TRUE(window_->isFullScreen());
  EXPECT_EQ(window_->menuBar()->height(), 0);
  EXPECT_GE(window_->timeline().font().pointSizeF(), Presentation::kTypeScale * usual - 1e-6);
  EXPECT_GT(window_->view_actions().options().annotation_scale, 1.4);
  EXPECT_TRUE(window_->viewport().hasFocus());
  const QString numbers = window_->headline().text();
  EXPECT_TRUE(numbers.contains("Time 0.60 s")) << numbers.toStdString();
  EXPECT_TRUE(numbers.contains("Phase Closing")) << numbers.toStdString();
  EXPECT_TRUE(numbers.contains("Contact force")) << numbers.toStdString();
  window_->headline().set_capture(Verdict::yes);
  EXPECT_TRUE(window_->headline().text().contains("Captured"));
}

// Keys of the hidden menus act, and the numbers follow a run that goes on.
TEST_F(PresentationTest, RunsGoOn) {
  mode().set_on(true);
  EXPECT_TRUE(window_->headline().text().contains("Not simulated yet"));
  QTest::keyClick(&window_->viewport(), Qt::Key_Space);
  ASSERT_TRUE(wait_until([&] { return window_->session().is_running(); }));
  EXPECT_TRUE(wait_until([&] { return window_->headline().text().contains("Phase Closing"); }));
  EXPECT_TRUE(wait_until([&] { return !window_->session().is_running(); }, 60));
  EXPECT_TRUE(mode().is_on());
  EXPECT_TRUE(window_->headline().text().contains("Time 2.00 s")) << window_->headline().text().toStdString();
}

TEST_F(PresentationTest, ClosingKeepsTheUsualLayout) {
  window_->findChild<QDockWidget*>("findings")->hide();
  mode().set_on(true);
  ASSERT_TRUE(window_->close());
  reopen();
  EXPECT_FALSE(mode().is_on());
  EXPECT_FALSE(window_->isFullScreen());
  EXPECT_TRUE(window_->findChild<QDockWidget*>("plots")->isVisible());
  EXPECT_FALSE(window_->findChild<QDockWidget*>("findings")->isVisible());
}

TEST_F(PresentationTest, TheStartPageGivesWay) {
  window_->show_start_page();
  mode().set_on(true);
  EXPECT_TRUE(window_->start_page().isHidden());
}

TEST_F(PresentationTest, AMaximisedWindowIsMaximisedAgain) {
  window_->showMaximized();
  mode().set_on(true);
  mode().set_on(false);
  EXPECT_TRUE(window_->isMaximized());
  EXPECT_FALSE(window_->isFullScreen());
}

}  // namespace
}  // namespace netpocket
