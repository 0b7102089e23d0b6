// Everything by keyboard, and told where one looks for it.

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QSet>
#include <QTest>

#include "gui/workbench/dialogs/shortcut_sheet.h"
#include "gui/workbench/viewport/viewport.h"
#include "tests/gui/workbench/window_fixture.h"

namespace netpocket {
namespace {

// All that has a key in the menus.
QList<const QAction*> actions_with_keys(const MainWindow& window) {
  QList<const QAction*> found;
  QSet<const QAction*> seen;
  for (const auto* menu : window.menuBar()->findChildren<QMenu*>()) {
    for (const QAction* action : menu->actions()) {
      if (action->shortcut().isEmpty() || seen.contains(action)) continue;
      seen << action;
      found << action;
    }
  }
  return found;
}

TEST_F(WindowTest, EveryKeyMeansOneThing) {
  QHash<QKeySequence, QString> meanings;
  for (const QAction* action : actions_with_keys(*window_)) {
    for (const QKeySequence& key : action->shortcuts()) {
      EXPECT_FALSE(meanings.contains(key))
          << key.toString().toStdString() << " is also " << meanings.value(key).toStdString();
      meanings[key] = action->text();
    }
  }
  EXPECT_GT(meanings.size(), 50);
}

TEST_F(WindowTest, TheCheatSheetHasEveryKey) {
  const ShortcutSheet sheet(*window_->menuBar(), window_.get());
  QSet<QString> told;
  for (const auto* label : sheet.findChildren<QLabel*>()) told << label->text();
  for (const QAction* action : actions_with_keys(*window_)) {
    EXPECT_TRUE(told.contains(action->shortcut().toString(QKeySequence::NativeText))) << action->text().toStdString();
  }
}

TEST_F(WindowTest, KeysGoToThePanelsAndBack) {
  int key = Qt::Key_1;
  for (const char* name : {"scenario", "plots", "findings", "runs", "control"}) {
    auto* dock = window_->findChild<QDockWidget*>(name);
    dock->hide();
    QTest::keyClick(window_.get(), static_cast<Qt::Key>(key++), Qt::AltModifier);
    EXPECT_TRUE(dock->isVisible()) << name;
  }
  QTest::keyClick(window_.get(), Qt::Key_1, Qt::AltModifier);
  EXPECT_TRUE(window_->findChild<QDockWidget*>("scenario")->isAncestorOf(window_->focusWidget()));
  QTest::keyClick(window_.get(), Qt::Key_0, Qt::AltModifier);
  EXPECT_EQ(window_->focusWidget(), &window_->viewport());
}

}  // namespace
}  // namespace netpocket
