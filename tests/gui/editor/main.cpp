// Runs the tests in a Qt application without a display.

#include <gtest/gtest.h>

#include <QApplication>

#include "tests/gui/plain_desktop.h"

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  testing::InitGoogleTest(&argc, argv);
  netpocket::leave_desktop();
  QApplication application(argc, argv);
  netpocket::use_plain_look();
  return RUN_ALL_TESTS();
}
