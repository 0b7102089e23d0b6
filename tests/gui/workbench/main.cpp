// Runs the tests in a Qt application; without a display unless QT_QPA_PLATFORM says otherwise.

#include <gtest/gtest.h>

#include <QApplication>
#include <QStandardPaths>
#include <QStyle>

#include "gui/workbench/viewport/presenter.h"
#include "gui/workbench/window_style.h"

int main(int argc, char** argv) {
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  testing::InitGoogleTest(&argc, argv);
  QStandardPaths::setTestModeEnabled(true);
  netpocket::prepare_opengl_format();
  QApplication application(argc, argv);
  QApplication::setStyle(new netpocket::WindowStyle("Fusion"));
  // What pictures depend on and desktops differ in.
  QApplication::setFont(QFont("DejaVu Sans", 9));
  QApplication::setPalette(QApplication::style()->standardPalette());
  QApplication::setCursorFlashTime(0);
  return RUN_ALL_TESTS();
}
