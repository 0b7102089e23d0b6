// Runs the tests in a Qt application; without a display unless QT_QPA_PLATFORM says otherwise.

#include <gtest/gtest.h>

#include <QApplication>

#include "gui/workbench/viewport/presenter.h"
#include "tests/gui/plain_desktop.h"

int main(int argc, char** argv) {
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  testing::InitGoogleTest(&argc, argv);
  netpocket::leave_desktop();
  netpocket::prepare_opengl_format();
  QApplication application(argc, argv);
  netpocket::use_plain_look();
  return RUN_ALL_TESTS();
}
