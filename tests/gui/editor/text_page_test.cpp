#include "gui/workbench/editor/text_page.h"

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QTest>

#include "gui/workbench/editor/message_bar.h"
#include "gui/workbench/editor/number_edit.h"
#include "gui/workbench/editor/parameter_form.h"
#include "gui/workbench/editor/parameter_row.h"
#include "gui/workbench/editor/scenario_editor.h"
#include "gui/workbench/editor/toml_edit_view.h"
#include "temporary_document.h"
#include "tests/gui/patience.h"

namespace netpocket {
namespace {

class Text : public testing::Test {
 protected:
  Text() {
    EXPECT_TRUE(document->open(document.write("a.toml", "[target]\nradius = 4.5\nmass = 200\n")).ok());
    editor.show();
    editor.tabs()->setCurrentWidget(editor.text_page());
  }

  TomlEditView& view() { return *editor.text_page()->view(); }
  void type_at_end(const char* text) {
    view().moveCursor(QTextCursor::End);
    QTest::keyClicks(&view(), text);
  }

  TemporaryDocument document;
  ScenarioEditor editor{&*document};
};

TEST_F(Text, APauseMakesItAnEdit) {
  type_at_end("length = 3");
  EXPECT_EQ(document->undo_stack()->count(), 0);
  EXPECT_TRUE(wait_patiently([&] { return document->scenario().target.length == 3; }));
  EXPECT_EQ(document->undo_stack()->count(), 1);
  EXPECT_EQ(editor.form()->row("target.length")->findChild<NumberEdit*>()->value(), 3);
}

TEST_F(Text, AnEditInTheFormChangesOnlyItsValue) {
  QTextCursor cursor(view().document());
  cursor.setPosition(3);
  view().setTextCursor(cursor);
  EXPECT_FALSE(document->set_value(parameter("target.radius"), 4.25));
  EXPECT_EQ(view().toPlainText(), "[target]\nradius = 4.25\nmass = 200\n");
  EXPECT_EQ(view().textCursor().position(), 3) << "the cursor stays";
}

TEST_F(Text, AnErrorIsMarkedAndTheDocumentStays) {
  type_at_end("colour = 1");
  EXPECT_FALSE(editor.text_page()->commit());
  ASSERT_EQ(view().marked_lines().size(), 1u);
  EXPECT_EQ(view().marked_lines().begin()->first, 4);
  EXPECT_EQ(document->undo_stack()->count(), 0);
  editor.tabs()->setCurrentIndex(0);
  EXPECT_FALSE(editor.form()->isEnabled()) << "an edit here would lose what was typed there";
  EXPECT_TRUE(editor.text_bar()->text().contains("line 4"));
  editor.text_bar()->findChildren<QPushButton*>()[0]->click();
  EXPECT_EQ(editor.tabs()->currentWidget(), editor.text_page());
  editor.text_bar()->findChildren<QPushButton*>()[1]->click();
  EXPECT_EQ(view().toPlainText(), document->text());
  EXPECT_TRUE(editor.form()->isEnabled());
}

TEST_F(Text, AValueOutOfItsLimitsIsMarked) {
  type_at_end("length = -3");
  EXPECT_FALSE(editor.commit());
  EXPECT_EQ(view().marked_lines().count(4), 1u);
}

TEST_F(Text, UndoFirstTakesBackTypingThenEdits) {
  EXPECT_FALSE(document->set_value(parameter("target.mass"), 100.0));
  type_at_end("x");
  QTest::keyClick(&view(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(view().toPlainText(), document->text());
  EXPECT_EQ(document->scenario().target.mass, 100);
  QTest::keyClick(&view(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document->scenario().target.mass, 200);
  EXPECT_EQ(view().toPlainText(), "[target]\nradius = 4.5\nmass = 200\n");
}

TEST_F(Text, LineEndsOfTheFileStay) {
  ASSERT_TRUE(document->open(document.write("dos.toml", "[target]\r\nradius = 4.0\r\n")).ok());
  EXPECT_TRUE(editor.commit());
  EXPECT_FALSE(document->is_modified()) << "nothing was typed";
  type_at_end("mass = 150");
  EXPECT_TRUE(editor.commit());
  EXPECT_EQ(document->text(), "[target]\r\nradius = 4.0\r\nmass = 150");
}

TEST_F(Text, CommentsAloneAreAnEditToo) {
  type_at_end("# note");
  EXPECT_TRUE(editor.commit());
  EXPECT_TRUE(document->is_modified());
  EXPECT_FALSE(document->save());
  EXPECT_TRUE(read_file(document->path()).endsWith("# note"));
}

}  // namespace
}  // namespace netpocket
