#include "gui/workbench/editor/number_edit.h"

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

namespace netpocket {
namespace {

double after_steps(double value, int steps, Limits limits = {-1e13, 1e13}) {
  NumberEdit edit(limits, false);
  edit.set_value(value);
  for (int i = 0; i < std::abs(steps); ++i) edit.stepBy(steps > 0 ? 1 : -1);
  return edit.value();
}

TEST(NumberEdit, StepsTheSecondDigit) {
  EXPECT_EQ(after_steps(4.5, 1), 4.6);
  EXPECT_EQ(after_steps(0.004, 1), 0.0041);
  EXPECT_EQ(after_steps(12e9, -1), 11e9);
  EXPECT_EQ(after_steps(1210, 1), 1300);
  EXPECT_EQ(after_steps(0, 1), 0.1);
  EXPECT_EQ(after_steps(0, 1, {0, 0.01}), 1e-4);
  EXPECT_EQ(after_steps(-4.5, 1), -4.4);
}

TEST(NumberEdit, StepsUpAndDownAreInverse) {
  EXPECT_EQ(after_steps(0.99, 1), 1.0);
  EXPECT_EQ(after_steps(1.0, -1), 0.99);
  EXPECT_EQ(after_steps(9.9, 2), 11);
  EXPECT_EQ(after_steps(11, -2), 9.9);
}

TEST(NumberEdit, StepsStayWithinTheLimits) {
  EXPECT_EQ(after_steps(0.95, 9, {0, 1}), 1);
  EXPECT_EQ(after_steps(1e-5, -30, {1e-5, 0.1}), 1e-5);
  EXPECT_GT(after_steps(0.02, -500, {0, 1, true}), 0) << "an excluded minimum is never reached";
}

TEST(NumberEdit, TypingCountsWhenFinished) {
  NumberEdit edit({0, 10}, false);
  edit.set_value(4.5);
  QSignalSpy typed(&edit, &NumberEdit::typed);
  QSignalSpy finished(&edit, &NumberEdit::finished);
  edit.selectAll();
  QTest::keyClicks(&edit, "3,25");
  EXPECT_EQ(typed.size(), 4);
  EXPECT_EQ(finished.size(), 0);
  EXPECT_EQ(edit.typed_value(), 3.25);
  EXPECT_EQ(edit.value(), 4.5);
  QTest::keyClick(&edit, Qt::Key_Return);
  EXPECT_EQ(finished.size(), 1);
}

TEST(NumberEdit, EscapeTakesTypingBack) {
  NumberEdit edit({0, 10}, false);
  edit.set_value(4.5);
  edit.selectAll();
  QTest::keyClicks(&edit, "abc");
  EXPECT_FALSE(edit.typed_value());
  EXPECT_TRUE(edit.has_pending_text());
  QTest::keyClick(&edit, Qt::Key_Escape);
  EXPECT_EQ(edit.typed_value(), 4.5);
  EXPECT_FALSE(edit.has_pending_text());
}

TEST(NumberEdit, WholeNumbersOnly) {
  NumberEdit edit({3, 64}, true);
  edit.set_value(8);
  edit.selectAll();
  QTest::keyClicks(&edit, "8.5");
  EXPECT_FALSE(edit.typed_value());
  edit.set_value(8);
  edit.stepBy(2);
  EXPECT_EQ(edit.value(), 10);
}

}  // namespace
}  // namespace netpocket
