// The start page, and the guided first capture done as a user does it.

#include <QAction>
#include <QApplication>
#include <QListWidget>
#include <QPushButton>
#include <QTest>

#include "gui/workbench/editor/message_bar.h"
#include "gui/workbench/editor/presets.h"
#include "gui/workbench/editor/scenario_editor.h"
#include "gui/workbench/export/export_tray.h"
#include "gui/workbench/file_actions.h"
#include "gui/workbench/panels/plots_panel.h"
#include "gui/workbench/run_actions.h"
#include "gui/workbench/run_file_actions.h"
#include "gui/workbench/start/card_delegate.h"
#include "gui/workbench/start/first_capture.h"
#include "gui/workbench/start/scenario_sketch.h"
#include "gui/workbench/start/start_page.h"
#include "gui/workbench/timeline/timeline_bar.h"
#include "gui/workbench/viewport/viewport.h"
#include "tests/gui/workbench/window_fixture.h"

namespace netpocket {
namespace {

QImage picture_of(const QListWidgetItem& item) { return item.data(CardDelegate::kPictureRole).value<QImage>(); }

int count_colours(const QImage& image) {
  QSet<QRgb> found;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) found.insert(image.pixel(x, y));
  }
  return static_cast<int>(found.size());
}

class StartTest : public WindowTest {
 protected:
  StartPage& page() const { return window_->start_page(); }
  FirstCapture& guide() const { return window_->first_capture(); }

  QListWidgetItem* scenario(const QString& name) const {
    return page().scenarios()->findItems(name, Qt::MatchExactly).value(0);
  }

  // Puts the mouse on an item and clicks.
  static void click(QListWidget* list, QListWidgetItem* item) {
    list->scrollToItem(item);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(item).center());
  }
};

TEST_F(StartTest, ShowsEveryScenarioAsAPicture) {
  window_->show_start_page();
  ASSERT_EQ(page().scenarios()->count(), static_cast<int>(presets().size()));
  ASSERT_TRUE(wait_until([&] {
    for (int i = 0; i < page().scenarios()->count(); ++i) {
      if (picture_of(*page().scenarios()->item(i)).isNull()) return false;
    }
    return true;
  }));
  for (int i = 0; i < page().scenarios()->count(); ++i) {
    const QListWidgetItem& item = *page().scenarios()->item(i);
    EXPECT_GT(count_colours(picture_of(item)), 50) << item.text().toStdString();
    EXPECT_FALSE(item.data(CardDelegate::kSentenceRole).toString().isEmpty()) << item.text().toStdString();
  }
  screenshot("start_page");
}

// At any width a further card would not fit at the right.
TEST_F(StartTest, CardsFillTheRow) {
  window_->show_start_page();
  for (const int width : {1200, 1280, 1440, 1920}) {
    window_->resize(width, 800);
    QListWidget* list = page().scenarios();
    ASSERT_TRUE(wait_until([&] { return list->window()->width() == width; }, 5));
    QTest::qWait(150);  // the list lays its cards out a little later
    int right = 0;
    for (int i = 0; i < list->count(); ++i) right = std::max(right, list->visualItemRect(list->item(i)).right());
    EXPECT_LE(right, list->viewport()->width()) << width;
    EXPECT_GT(right, list->viewport()->width() - 24) << width;
  }
}

// A net in front of a target is dark, its rods are blue, and nothing of the pocket is at the picture's edge.
TEST(ScenarioSketch, ShowsThePocketInTheMiddle) {
  const QImage picture = sketch_pocket(preview_pocket(quick_scenario()), {448, 280}, Background::white);
  ASSERT_EQ(picture.size(), QSize(448, 280));
  int blue = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const QColor colour = picture.pixelColor(x, y);
      blue += colour.blue() > colour.red() + 60 ? 1 : 0;
      const bool edge = x == 0 || y == 0 || x == picture.width() - 1 || y == picture.height() - 1;
      ASSERT_TRUE(!edge || colour == QColor(Qt::white)) << x << ", " << y;
    }
  }
  EXPECT_GT(blue, 300);
}

TEST_F(StartTest, AClickOnAScenarioOpensItAndClosesThePage) {
  window_->show_start_page();
  ASSERT_TRUE(page().isVisible());
  click(page().scenarios(), scenario("case2"));
  EXPECT_EQ(window_->document().scenario().name, "case2");
  EXPECT_FALSE(page().isVisible());
}

TEST_F(StartTest, UnsavedChangesAreAskedAboutAndThePageStays) {
  ASSERT_FALSE(window_->document().set_value(*find_parameter("closing.duration"), 9.0));
  window_->show_start_page();
  answer_question(QMessageBox::Cancel);
  click(page().scenarios(), scenario("case2"));
  EXPECT_EQ(window_->document().scenario().name, "quick");
  EXPECT_TRUE(page().isVisible());
}

TEST_F(StartTest, RecentFilesOpenAndMissingOnesAreLeftOut) {
  ASSERT_FALSE(window_->document().save_as(file("one.toml")));
  window_->file_actions().note_recent(file("gone.toml"));
  window_->document().start_from(Scenario{});
  window_->show_start_page();
  ASSERT_EQ(page().recent()->count(), 1);
  EXPECT_EQ(page().recent()->item(0)->text(), "one.toml");
  screenshot("start_page_recent");
  click(page().recent(), page().recent()->item(0));
  EXPECT_EQ(window_->document().path(), file("one.toml"));
  EXPECT_FALSE(page().isVisible());
}

// A file that cannot be read leaves its sentence in sight.
TEST_F(StartTest, ProblemsAreNotCovered) {
  write_file("bad.toml", "[closing]\ndurration = 3\n");
  window_->show_start_page();
  emit page().file_chosen(file("bad.toml"));
  EXPECT_FALSE(page().isVisible());
  EXPECT_TRUE(window_->notice().contains("durration")) << window_->notice().toStdString();
}

TEST_F(StartTest, TabGoesRoundOnThePageAndEscapeLeavesIt) {
  window_->show_start_page();
  QSet<QWidget*> reached;
  for (int i = 0; i < 12; ++i) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    ASSERT_TRUE(page().isAncestorOf(QApplication::focusWidget()));
    reached << QApplication::focusWidget();
  }
  EXPECT_TRUE(reached.contains(page().scenarios()));
  EXPECT_TRUE(reached.contains(page().guide_button()));
  page().scenarios()->setFocus();
  page().scenarios()->setCurrentItem(scenario("case3"));
  QTest::keyClick(page().scenarios(), Qt::Key_Return);
  EXPECT_EQ(window_->document().scenario().name, "case3");
  window_->show_start_page();
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
  EXPECT_FALSE(page().isVisible());
  EXPECT_EQ(QApplication::focusWidget(), &window_->viewport());
}

TEST_F(StartTest, TheGuideOpensCaseOne) {
  window_->show_start_page();
  QTest::mouseClick(page().guide_button(), Qt::LeftButton);
  EXPECT_EQ(window_->document().scenario().name, "case1");
  EXPECT_FALSE(page().isVisible());
  EXPECT_TRUE(guide().isVisible());
  EXPECT_EQ(guide().step(), GuideStep::look);
  screenshot("guide_look");
  QTest::mouseClick(guide().leave_button(), Qt::LeftButton);
  EXPECT_FALSE(guide().isVisible());
}

TEST_F(StartTest, StepsAreDoneByDoingThem) {
  guide().begin();
  ASSERT_TRUE(wait_for_picture());
  // A picture that comes is not a look, nor is a wheel that only comes nearer.
  EXPECT_EQ(guide().step(), GuideStep::look);
  for (int i = 0; i < 3; ++i) QTest::keyClick(&window_->viewport(), Qt::Key_Right);
  ASSERT_EQ(guide().step(), GuideStep::change);

  // A change that is taken back at once is none.
  ASSERT_FALSE(window_->document().set_value(*find_parameter("closing.duration"), 0.8));
  EXPECT_EQ(guide().step(), GuideStep::change);
  ASSERT_FALSE(window_->document().set_value(*find_parameter("closing.duration"), 0.7));
  ASSERT_EQ(guide().step(), GuideStep::run);

  ASSERT_TRUE(wait_for_picture());
  window_->run_actions().run_action()->trigger();
  ASSERT_TRUE(wait_until([&] { return guide().step() == GuideStep::scrub; }));
  ASSERT_TRUE(wait_until([&] { return !window_->session().is_running(); }));
  EXPECT_EQ(guide().step(), GuideStep::scrub);  // new frames are no scrubbing

  window_->timeline().step_frames(-3);
  ASSERT_TRUE(wait_until([&] { return guide().step() == GuideStep::force; }));

  window_->plots().show_figure("figure05_force");
  EXPECT_EQ(guide().step(), GuideStep::force);
  emit window_->plots().time_clicked(0.5);
  ASSERT_TRUE(wait_until([&] { return guide().step() == GuideStep::picture; }));
  screenshot("guide_picture");

  ASSERT_FALSE(window_->plots().export_figure(file("force.png")));
  emit window_->plots().exported(file("force.png"));
  EXPECT_EQ(guide().step(), GuideStep::end);
  EXPECT_FALSE(guide().skip_button()->isVisible());
}

TEST_F(StartTest, ShowMeGoesToThePlace) {
  guide().begin();
  QTest::mouseClick(guide().skip_button(), Qt::LeftButton);
  ASSERT_EQ(guide().step(), GuideStep::change);
  QTest::mouseClick(guide().show_button(), Qt::LeftButton);
  EXPECT_TRUE(window_->editor().isAncestorOf(QApplication::focusWidget()));
  for (int i = 0; i < 2; ++i) QTest::mouseClick(guide().skip_button(), Qt::LeftButton);
  ASSERT_EQ(guide().step(), GuideStep::scrub);
  QTest::mouseClick(guide().skip_button(), Qt::LeftButton);
  window_->plots().show_figure("energy");
  QTest::mouseClick(guide().show_button(), Qt::LeftButton);
  EXPECT_EQ(window_->plots().figure_name(), "figure05_force");
}

}  // namespace
}  // namespace netpocket
