#pragma once
// A real main window with settings and files of its own, and a scenario that runs in a second or two.

#include <gtest/gtest.h>

#include <QMessageBox>
#include <QTemporaryDir>
#include <functional>
#include <memory>

#include "gui/workbench/main_window.h"

namespace netpocket {

// Coarse net, few frames: quick to simulate, with everything in it.
Scenario quick_scenario();

class WindowTest : public testing::Test {
 protected:
  WindowTest();
  ~WindowTest() override;

  // As wait_patiently().
  static bool wait_until(const std::function<bool()>& condition, double seconds = 30);
  // Lets a run come to `time`, s, and pauses it.
  bool run_to(double time);
  // Until the viewport, and the second one when there is one, shows a smooth picture of the state that it was given
  // last.
  bool wait_for_picture();
  // Drags files into the window and lets them go.
  void drop(const QStringList& paths);
  // Presses a button of the next question that comes up.
  static void answer_question(QMessageBox::StandardButton button);
  // Makes the window anew, with the same settings and files.
  void reopen();
  // With NETPOCKET_SCREENSHOTS=FOLDER set: a picture of the window for people.
  void screenshot(const QString& name);

  QString file(const QString& name) const { return folder_.filePath(name); }
  void write_file(const QString& name, const QByteArray& content) const;

  QTemporaryDir folder_;
  WindowOptions options_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace netpocket
