#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QStyleOptionComboBox>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>

#include "gui/workbench/editor/closing_preview.h"
#include "gui/workbench/editor/group_box.h"
#include "gui/workbench/editor/message_bar.h"
#include "gui/workbench/editor/number_edit.h"
#include "gui/workbench/editor/parameter_field.h"
#include "gui/workbench/editor/parameter_form.h"
#include "gui/workbench/editor/parameter_row.h"
#include "gui/workbench/editor/scenario_editor.h"
#include "gui/workbench/panels/chart_view.h"
#include "temporary_document.h"
#include "tests/gui/patience.h"

namespace netpocket {
namespace {

class Form : public testing::Test {
 protected:
  Form() {
    editor.resize(420, 800);
    editor.show();
  }

  ParameterRow& row(const char* key) { return *editor.form()->row(key); }
  template <typename Widget>
  Widget& part(const char* key, int index = 0) {
    return *row(key).findChildren<Widget*>()[index];
  }
  void type(const char* key, const char* text, int index = 0) {
    auto& edit = part<NumberEdit>(key, index);
    edit.setFocus();
    edit.selectAll();
    QTest::keyClicks(&edit, text);
  }

  TemporaryDocument document;
  ScenarioEditor editor{&*document};
};

TEST_F(Form, HasARowForEveryParameter) {
  for (const Parameter& p : parameters()) {
    if (p.key == "system") continue;  // there is one kind only, so there is nothing to choose
    ParameterRow* row = editor.form()->row(QString::fromStdString(std::string(p.key)));
    ASSERT_TRUE(row) << p.key;
    EXPECT_FALSE(row->field()->toolTip().isEmpty());
  }
}

TEST_F(Form, TypedNumberIsAnEditThatCanBeUndone) {
  type("target.mass", "150");
  EXPECT_EQ(document->scenario().target.mass, 200) << "not before it is finished";
  QTest::keyClick(&part<NumberEdit>("target.mass"), Qt::Key_Return);
  EXPECT_EQ(document->scenario().target.mass, 150);
  document->undo_stack()->undo();
  EXPECT_EQ(part<NumberEdit>("target.mass").value(), 200);
  document->undo_stack()->redo();
  EXPECT_EQ(part<NumberEdit>("target.mass").value(), 150);
}

TEST_F(Form, StepsMergeIntoOneEdit) {
  auto& edit = part<NumberEdit>("target.radius");
  edit.setFocus();
  for (int i = 0; i < 5; ++i) QTest::keyClick(&edit, Qt::Key_Up);
  EXPECT_EQ(document->scenario().target.radius, 5.0);
  EXPECT_EQ(document->undo_stack()->count(), 1);
  QTest::qWait(900);
  QCoreApplication::processEvents();  // also when the process stood still meanwhile
  QTest::keyClick(&edit, Qt::Key_Up);
  EXPECT_EQ(document->undo_stack()->count(), 2) << "after a pause it is another edit";
}

TEST_F(Form, ARangeErrorStandsUnderTheField) {
  type("contact.restitution", "1.5");
  EXPECT_TRUE(row("contact.restitution").problem().contains("<= 1"))
      << row("contact.restitution").problem().toStdString();
  QTest::keyClick(&part<NumberEdit>("contact.restitution"), Qt::Key_Return);
  EXPECT_EQ(document->scenario().contact.restitution, 0.5);
  EXPECT_EQ(part<NumberEdit>("contact.restitution").text(), "1.5") << "what was typed stays to be corrected";
  type("contact.restitution", "x");
  EXPECT_TRUE(row("contact.restitution").problem().contains("not a number"));
  QTest::keyClick(&part<NumberEdit>("contact.restitution"), Qt::Key_Escape);
  EXPECT_TRUE(row("contact.restitution").problem().isEmpty());
}

TEST_F(Form, AProblemOfTheWholeStandsAtItsParameter) {
  type("closing.closed_length", "9");
  QTest::keyClick(&part<NumberEdit>("closing.closed_length"), Qt::Key_Return);
  EXPECT_TRUE(row("closing.closed_length").problem().contains("shorter"));
  document->undo_stack()->undo();
  EXPECT_TRUE(row("closing.closed_length").problem().isEmpty());
}

TEST_F(Form, ChoicesShowTheirLongestWord) {
  editor.resize(330, 800);  // as the window starts
  QCoreApplication::processEvents();
  for (const char* key : {"towing.mode", "solver.evaluation", "closing.law"}) {
    const auto& box = part<QComboBox>(key);
    int longest = 0;
    for (int i = 0; i < box.count(); ++i)
      longest = std::max(longest, box.fontMetrics().horizontalAdvance(box.itemText(i)));
    QStyleOptionComboBox option;
    option.initFrom(&box);
    const QRect room = box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box);
    EXPECT_LE(longest, room.width()) << key;
  }
}

TEST_F(Form, ChoiceChangesWhichFieldsAreUsed) {
  EXPECT_TRUE(row("target.radius").field()->isEnabled());
  EXPECT_FALSE(row("target.size").field()->isEnabled());
  auto& box = part<QComboBox>("target.shape");
  box.setFocus();
  QTest::keyClick(&box, Qt::Key_Down);
  EXPECT_EQ(document->scenario().target.shape, TargetShape::box);
  EXPECT_FALSE(row("target.radius").field()->isEnabled());
  EXPECT_TRUE(row("target.size").field()->isEnabled());
}

TEST_F(Form, VectorAndProfileFields) {
  type("target.position", "0.25", 2);
  QTest::keyClick(&part<NumberEdit>("target.position", 2), Qt::Key_Return);
  EXPECT_EQ(document->scenario().target.position, Eigen::Vector3d(0, 7.5, 0.25));
  auto& table = part<QTableWidget>("rods.profile");
  ASSERT_EQ(table.rowCount(), 3);
  table.item(1, 0)->setText("5.0");
  EXPECT_EQ(document->scenario().rods.profile[1].x(), 5.0);
  table.item(1, 0)->setText("?");
  EXPECT_TRUE(row("rods.profile").problem().contains("not a number"));
}

TEST_F(Form, RowsOfTheClosingTableComeAndGo) {
  EXPECT_FALSE(document->set_value(parameter("closing.law"), Choice{4}));
  auto& table = part<QTableWidget>("closing.table");
  QToolButton& add = part<QToolButton>("closing.table", 0);
  add.click();
  add.click();
  EXPECT_EQ(table.rowCount(), 2);
  EXPECT_EQ(document->scenario().closing.table.size(), 2u);
  part<QToolButton>("closing.table", 1).click();
  EXPECT_EQ(document->scenario().closing.table.size(), 1u);
  EXPECT_FALSE(row("closing.table").problem().isEmpty()) << "one point is no law";
}

TEST_F(Form, RowsOfScatterNameRodsOrPanelsAndStartSound) {
  for (const auto& [key, head] : {std::pair("scatter.rod_stiffness", "rod"), {"scatter.panel_stiffness", "panel"}}) {
    auto& table = part<QTableWidget>(key);
    EXPECT_EQ(table.horizontalHeaderItem(0)->text(), head);
    EXPECT_EQ(table.horizontalHeaderItem(1)->text(), "factor");
    part<QToolButton>(key, 0).click();
    EXPECT_EQ(table.rowCount(), 1);
    EXPECT_TRUE(row(key).problem().isEmpty()) << row(key).problem().toStdString();
  }
}

TEST_F(Form, ResetGoesToTheFileThenToTheDefault) {
  ASSERT_TRUE(document->open(document.write("a.toml", "[target]\nmass = 100\n")).ok());
  EXPECT_FALSE(row("target.mass").is_changed());
  EXPECT_TRUE(row("target.mass").reset_button()->isEnabled()) << "differs from the default";
  EXPECT_FALSE(row("target.radius").reset_button()->isEnabled());
  EXPECT_FALSE(document->set_value(parameter("target.mass"), 50.0));
  EXPECT_TRUE(row("target.mass").is_changed());
  row("target.mass").reset_button()->click();
  EXPECT_EQ(document->scenario().target.mass, 100);
  EXPECT_FALSE(row("target.mass").is_changed());
  row("target.mass").reset_button()->click();
  EXPECT_EQ(document->scenario().target.mass, 200);
  EXPECT_FALSE(row("target.mass").reset_button()->isHidden());
}

TEST_F(Form, SearchShowsWhatMatches) {
  editor.search()->setText("friction");
  EXPECT_TRUE(row("contact.friction").isVisible());
  EXPECT_TRUE(row("contact.friction_velocity").isVisible());
  EXPECT_FALSE(row("contact.restitution").isVisible());
  EXPECT_FALSE(row("net.diameter").isVisible());
  editor.search()->setText("table 2 net young");
  EXPECT_TRUE(row("net.youngs_modulus").isVisible());
  EXPECT_FALSE(row("rods.youngs_modulus").isVisible());
  editor.search()->setText("no such thing");
  EXPECT_FALSE(editor.form()->isVisible());
  QTest::keyClick(editor.search(), Qt::Key_Escape);
  editor.search()->clear();
  EXPECT_TRUE(row("net.diameter").isVisible());
}

TEST_F(Form, SearchUnfoldsAndRestores) {
  GroupBox* group = editor.form()->group("contact");
  group->heading()->click();
  EXPECT_FALSE(row("contact.friction").isVisible());
  editor.search()->setText("friction");
  EXPECT_TRUE(row("contact.friction").isVisible());
  editor.search()->clear();
  EXPECT_FALSE(row("contact.friction").isVisible());
}

TEST_F(Form, EnterInTheSearchGoesToTheFirstMatch) {
  editor.activateWindow();
  editor.search()->setText("restitution");
  QTest::keyClick(editor.search(), Qt::Key_Return);
  EXPECT_TRUE(row("contact.restitution").isAncestorOf(editor.focusWidget()));
}

TEST_F(Form, ChangedOnly) {
  EXPECT_FALSE(document->set_value(parameter("target.mass"), 50.0));
  editor.changed_only()->setChecked(true);
  EXPECT_TRUE(row("target.mass").isVisible());
  EXPECT_FALSE(row("target.radius").isVisible());
  document->undo_stack()->undo();
  EXPECT_FALSE(editor.form()->isVisible());
}

TEST_F(Form, PreviewFollowsTyping) {
  QSignalSpy preview(&editor, &ScenarioEditor::preview);
  type("closing.duration", "5");
  const auto range = time_range(editor.form()->closing_preview()->chart()->figure());
  ASSERT_TRUE(range);
  EXPECT_NEAR(range->end, 5.5, 1e-9) << "duration and a tenth after it";
  ASSERT_GE(preview.size(), 1);
  EXPECT_EQ(document->scenario().closing.duration, 10) << "typing is not yet an edit";
  QTest::keyClick(&part<NumberEdit>("closing.duration"), Qt::Key_Escape);
  EXPECT_NEAR(time_range(editor.form()->closing_preview()->chart()->figure())->end, 11, 1e-9);
}

TEST_F(Form, ARunSortsEditsByWhatTheyMeanToIt) {
  QSignalSpy strategy(&editor, &ScenarioEditor::strategy_edited);
  QSignalSpy restart(&editor, &ScenarioEditor::restart_needed);
  EXPECT_FALSE(document->set_value(parameter("contact.friction"), 0.3));
  EXPECT_EQ(strategy.size(), 0) << "no run yet";
  editor.set_running(&document->scenario());
  EXPECT_FALSE(document->set_value(parameter("contact.friction"), 0.2));
  ASSERT_EQ(strategy.size(), 1);
  EXPECT_EQ(strategy[0][0].toStringList(), QStringList{"contact.friction"});
  EXPECT_FALSE(document->set_value(parameter("target.mass"), 100.0));
  EXPECT_EQ(editor.keys_that_need_restart(), QStringList{"target.mass"});
  EXPECT_EQ(restart.size(), 1);
  EXPECT_FALSE(editor.restart_bar()->isHidden());
  QSignalSpy requested(&editor, &ScenarioEditor::restart_requested);
  editor.restart_bar()->findChild<QPushButton*>()->click();
  EXPECT_EQ(requested.size(), 1);
  document->undo_stack()->undo();
  EXPECT_TRUE(editor.keys_that_need_restart().isEmpty());
  EXPECT_TRUE(editor.restart_bar()->isHidden());
  editor.set_running(nullptr);
}

TEST_F(Form, ReadOnlyTakesNoEdits) {
  editor.set_read_only(true);
  type("target.mass", "150");
  QTest::keyClick(&part<NumberEdit>("target.mass"), Qt::Key_Return);
  QTest::keyClick(&part<NumberEdit>("target.mass"), Qt::Key_Up);
  EXPECT_EQ(document->scenario().target.mass, 200);
}

TEST_F(Form, UndoKeyIsTheDocumentsUnlessSomethingIsTyped) {
  QAction* undo = document->undo_stack()->createUndoAction(&editor);
  undo->setShortcut(QKeySequence::Undo);
  editor.addAction(undo);
  ASSERT_TRUE(wait_patiently([&] { return editor.isActiveWindow(); }));
  EXPECT_FALSE(document->set_value(parameter("target.mass"), 150.0));
  auto& edit = part<NumberEdit>("target.radius");
  edit.setFocus();
  QTest::keyClick(&edit, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document->scenario().target.mass, 200);
}

TEST_F(Form, RevealUnfoldsAndFocuses) {
  editor.activateWindow();
  editor.form()->group("solver")->set_expanded(false);
  editor.reveal("solver.safety");
  EXPECT_TRUE(row("solver.safety").isVisible());
  EXPECT_TRUE(row("solver.safety").isAncestorOf(editor.focusWidget()));
}

}  // namespace
}  // namespace netpocket
